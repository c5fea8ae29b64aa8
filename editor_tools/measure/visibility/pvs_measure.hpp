#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/visibility.hpp"
#include "measure/no_value.hpp"

namespace hw::measure {

struct PvsRayOptions {
    std::uint64_t rays = 10'000'000;
    std::uint64_t seed = 1;
    int threads = 0;  ///< 0: as many as the machine has. The counts do not depend on it.
};

/// A ray that meets what the rows hide.
struct FalseInvisible {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
    std::uint32_t slot = 0;
};

struct PvsRayResult {
    std::uint64_t rays = 0;
    std::uint64_t hits = 0;
    std::uint64_t claims = 0;              ///< Rays in float that met a hidden chunk.
    std::uint64_t false_invisibles = 0;    ///< Those of them that exact arithmetic confirms. Must be 0.
    int clusters = 0;                      ///< Clusters with enough rays to speak of a truth.
    double row_share = kNoValue;           ///< Mean share of triangles in the rows of these clusters; no value of none.
    double sampled_share = kNoValue;       ///< Mean share of triangles that their rays met.
    std::vector<FalseInvisible> examples;  ///< At most sixteen, any of them.
};

/// Shoots rays from places all over the scene, half of them anywhere in its box and half near drawn surfaces, and
/// compares what they meet with what visible_chunks() shows there. Of the rays of a place half go evenly over the
/// sphere, half at triangles that the rows hide. Places inside of walls, where everything is shown,
/// are left out.
PvsRayResult measure_pvs(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, const Visibility& visibility,
                         const PvsRayOptions& options);

}  // namespace hw::measure
