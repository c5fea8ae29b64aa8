#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>

namespace hw::measure {

/// A level of equal rooms on a grid, as large as one likes, seen from its first room:
/// doorways are out of line, so that sight ends after a room or two. Each room is a shell and nine vessels, all
/// instances of a few meshes. The same number of rooms gives the same bytes.
struct ScaleLevel {
    int rooms = 0;
    std::uint64_t objects = 0;
    std::uint64_t triangles = 0;  ///< Drawn: instances count each time.
    glm::dvec3 eye_world{0.0};    ///< In a room of the first row and column, looking to `target_world`.
    glm::dvec3 target_world{0.0};
};

inline constexpr int kObjectsOfRoom = 10;

/// Writes the model as a .glb. Throws hw::Error if the file cannot be written.
ScaleLevel write_scale_level(const std::filesystem::path& file, int rooms);

}  // namespace hw::measure
