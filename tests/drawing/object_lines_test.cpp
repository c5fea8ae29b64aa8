// What pictures know of the faces beside a line.
#include "hatchway/drawing/object_lines.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

namespace hw {
namespace {

/// Faces around an edge along y; each looks to where its angle from +x towards -z says.
ObjectLine edge_of_faces(const std::vector<float>& degrees)
{
    MeshData mesh;
    mesh.positions = {{0, -1, 0}, {0, 1, 0}};
    for (const float angle : degrees) {
        const float rad = angle * std::numbers::pi_v<float> / 180.0f;
        const auto corner = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.emplace_back(-std::sin(rad), 0, -std::cos(rad));
        mesh.indices.insert(mesh.indices.end(), {0, 1, corner});
    }
    const Surface surface = build_surface(mesh);
    const ObjectLines lines = object_lines({surface, 0.7f, {}});
    for (const ObjectLine& line : lines.lines)
        if (line.ends[0].x == 0.0f && line.ends[1].x == 0.0f && line.ends[0].z == 0.0f && line.ends[1].z == 0.0f)
            return line;
    return {};
}

TEST(object_lines, at_an_edge_of_many_faces_the_outermost_two_tell_whether_all_are_culled)
{
    const LineSides sides = edge_of_faces({40, 0, 100, 60, -30}).sides;
    EXPECT_TRUE(sides.are_culled);
    EXPECT_NEAR(glm::dot(sides.normal_a, sides.normal_b), std::cos(130.0 * std::numbers::pi / 180.0), 1e-5);
}

TEST(object_lines, an_edge_of_faces_that_look_all_around_is_never_culled)
{
    EXPECT_FALSE(edge_of_faces({0, 120, 240}).sides.are_culled);
    EXPECT_FALSE(edge_of_faces({0, 100, -100}).sides.are_culled);
}

}  // namespace
}  // namespace hw
