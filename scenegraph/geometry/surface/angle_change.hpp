#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>

namespace hw {

/// What a linear map does to angles: all that turns, mirrors and scales alike in all directions is the same here. A
/// fresh one keeps every angle. Ordered, so that it can be a part of a key.
struct AngleChange {
    std::array<std::int64_t, 6> square{};  ///< Of the map at unit size, less identity, in 2^-20.

    bool is_none() const { return square == std::array<std::int64_t, 6>{}; }
    auto operator<=>(const AngleChange&) const = default;
};

/// None for a map that flattens: there are no angles in what it makes.
AngleChange angle_change(const glm::dmat3& map);

/// What turns normals as `map` turns faces, as far as angles between them go: the identity where none changes.
glm::dmat3 fold_normal_matrix(const glm::dmat3& map);

}  // namespace hw
