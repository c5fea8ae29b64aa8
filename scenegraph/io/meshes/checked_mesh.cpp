#include "hatchway/io/meshes/checked_mesh.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hatchway/core/limits.hpp"

namespace hw {

void check_vertex_count(std::uint64_t count, const FilePlace& place)
{
    if (count > limits::kMaxVertices)
        place.refuse(fmt::format("there are {} vertices", count), fmt::format("at most {}", limits::kMaxVertices));
}

void check_triangle_count(std::uint64_t count, const FilePlace& place)
{
    if (count > limits::kMaxTriangles)
        place.refuse(fmt::format("there are {} triangles", count), fmt::format("at most {}", limits::kMaxTriangles));
}

void check_corner_count(std::int64_t count, const FilePlace& place)
{
    if (count < 0 || count > static_cast<std::int64_t>(kMaxPolygonCorners))
        place.refuse(fmt::format("a face has {} corners", count), fmt::format("at most {}", kMaxPolygonCorners));
}

float checked_coordinate(double value, const FilePlace& place)
{
    if (!(std::abs(value) <= limits::kMaxCoordinate))
        place.refuse(fmt::format("there is the coordinate {}", value),
                     fmt::format("finite ones up to {:g}", limits::kMaxCoordinate));
    return static_cast<float>(value);
}

}  // namespace hw
