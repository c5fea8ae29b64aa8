#include "measure/silhouettes/smooth_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw {

MeshData smooth_mesh(std::uint32_t triangles)
{
    const auto rows = std::max(4u, static_cast<std::uint32_t>(std::sqrt(triangles / 4.0))), columns = 2 * rows;
    MeshData mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            // The caps stay open by a hair's breadth, so that no two positions are equal, and are closed below.
            const double down = std::numbers::pi * (row + 0.001) / (rows + 0.002);
            const double around = 2.0 * std::numbers::pi * column / columns;
            const double flat = std::sin(down);
            const double radius = 1.0 + 0.1 * std::sin(5.0 * around) * std::sin(7.0 * down) * flat * flat;
            mesh.positions.push_back(glm::vec3(glm::dvec3(radius * flat * std::cos(around), radius * std::cos(down),
                                                          radius * flat * std::sin(around))));
        }
    }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t index : {a, b, c}) mesh.indices.push_back(index);
    };
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t next = (column + 1) % columns;
            const std::uint32_t a = row * columns + column, b = row * columns + next, below = columns;
            add(a, b, a + below);
            add(b, b + below, a + below);
        }
    }
    for (std::uint32_t column = 1; column + 1 < columns; ++column) {
        add(0, column + 1, column);
        add(rows * columns, rows * columns + column, rows * columns + column + 1);
    }
    return mesh;
}

}  // namespace hw
