#include "hatchway/geometry/surface/triangulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace {

struct Filled {
    double area = 0.0;      ///< Of all triangles, along the polygon's normal.
    double absolute = 0.0;  ///< The same without signs: more when triangles overlap.
    std::size_t count = 0;
};

Filled fill(const std::vector<glm::vec3>& polygon, const glm::dvec3& normal)
{
    std::vector<std::uint32_t> triangles;
    hw::triangulate(polygon, triangles);
    Filled filled;
    filled.count = triangles.size() / 3;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const glm::dvec3 a(polygon.at(triangles[i]));
        const glm::dvec3 cross =
            glm::cross(glm::dvec3(polygon.at(triangles[i + 1])) - a, glm::dvec3(polygon.at(triangles[i + 2])) - a);
        filled.area += 0.5 * glm::dot(cross, normal);
        filled.absolute += 0.5 * glm::length(cross);
    }
    return filled;
}

/// A star of that many points around the origin, in the plane z = 0.
std::vector<glm::vec3> star(int points)
{
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = 3.14159265358979 * i / points;
        const double radius = i % 2 == 0 ? 2.0 : 0.5;
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    return corners;
}

}  // namespace

TEST(triangulation, a_convex_polygon_is_a_fan)
{
    std::vector<std::uint32_t> triangles;
    hw::triangulate(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, triangles);
    EXPECT_EQ(triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    hw::triangulate(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}}, triangles);
    EXPECT_EQ(triangles.size(), 6u) << "two corners add nothing";
}

TEST(triangulation, triangles_of_a_concave_polygon_cover_it_once_whichever_way_it_turns_and_lies)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int round = 0; round < 50; ++round) {
        const glm::dvec3 u = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        const glm::dvec3 normal = glm::normalize(glm::cross(u, glm::dvec3(any(random), any(random), any(random))));
        const glm::dvec3 v = glm::cross(normal, u);
        std::vector<glm::vec3> turned;
        for (const glm::vec3& corner : star(3 + round % 9))
            turned.emplace_back(u * double(corner.x) + v * double(corner.y));
        const Filled filled = fill(turned, normal);
        const int points = 3 + round % 9;
        EXPECT_EQ(filled.count, turned.size() - 2);
        EXPECT_NEAR(filled.area, points * std::sin(3.14159265358979 / points), 1e-5);
        EXPECT_NEAR(filled.absolute, filled.area, 1e-5) << "no triangle overlaps another or turns its back";
    }
}

TEST(triangulation, straight_and_repeated_corners_and_crossings_keep_the_number_of_triangles)
{
    const glm::dvec3 up(0, 0, 1);
    const Filled straight = fill({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}}, up);
    EXPECT_EQ(straight.count, 4u);
    EXPECT_NEAR(straight.area, 3.0, 1e-9);
    EXPECT_EQ(fill({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, up).count, 2u) << "a bow tie";
    EXPECT_EQ(fill({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, up).count, 3u) << "a point";
}
