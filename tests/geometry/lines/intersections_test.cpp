#include "hatchway/geometry/lines/intersections.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

glm::dmat4 at(double x, double y, double z)
{
    return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

double length_of(const std::vector<hw::IntersectionLine>& lines)
{
    double sum = 0.0;
    for (const auto& line : lines) sum += glm::distance(line.ends_world[0], line.ends_world[1]);
    return sum;
}

/// Joints that an odd number of pieces meet in: 0 for closed lines.
std::size_t odd_joints(const std::vector<hw::IntersectionLine>& lines)
{
    std::map<std::uint32_t, int> uses;
    for (const auto& line : lines)
        for (const std::uint32_t joint : line.joints) ++uses[joint];
    return std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second % 2 != 0; });
}

/// A post that goes through a floor at the height 0, around which it is cut by 8 m.
struct PostInFloor {
    const hw::Surface floor = hw::build_surface(box({-5, -1, -5}, {5, 0, 5}));
    const hw::Surface post = hw::build_surface(box({-1, -0.5f, -1}, {1, 3, 1}));
    const std::vector<hw::LineObject> objects{{&floor}, {&post}};
};

}  // namespace

TEST(intersections, a_box_through_a_floor_is_cut_around)
{
    const PostInFloor scene;
    const auto lines = hw::find_intersections(scene.objects);
    EXPECT_NEAR(length_of(lines), 8.0, 1e-12);
    EXPECT_EQ(odd_joints(lines), 0u);
    for (const auto& line : lines) EXPECT_NEAR(line.ends_world[0].y, 0.0, 1e-15);
}

TEST(intersections, components_of_one_mesh_cut_each_other_like_objects)
{
    hw::MeshData mesh = box({-5, -1, -5}, {5, 0, 5});
    const hw::MeshData post = box({-1, -0.5f, -1}, {1, 3, 1});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), post.positions.begin(), post.positions.end());
    mesh.normals.insert(mesh.normals.end(), post.normals.begin(), post.normals.end());
    for (const std::uint32_t index : post.indices) mesh.indices.push_back(first + index);
    const hw::Surface both = hw::build_surface(mesh);
    ASSERT_EQ(both.components.size(), 2u);
    const std::vector<hw::LineObject> objects{{&both}};
    const auto lines = hw::find_intersections(objects);
    EXPECT_NEAR(length_of(lines), 8.0, 1e-12);
    EXPECT_EQ(odd_joints(lines), 0u);
    for (const auto& line : lines) EXPECT_EQ(line.objects[0], line.objects[1]);
}

TEST(intersections, objects_in_contact_have_none)
{
    const hw::Surface floor = hw::build_surface(box({-5, -1, -5}, {5, 0, 5}));
    const hw::Surface post = hw::build_surface(box({-1, 0, -1}, {1, 3, 1}));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.37, glm::dvec3(0.2, 1.0, 0.4));
    for (const double sunk : {0.0, 1e-9, -1e-9, 1e-6}) {
        const std::vector<hw::LineObject> objects{{&floor, turn}, {&post, turn * at(0.1, -sunk, 0.2)}};
        EXPECT_TRUE(hw::find_intersections(objects).empty()) << sunk;
    }
}

TEST(intersections, spheres_cut_each_other_in_closed_lines)
{
    const hw::Surface ball = hw::build_surface(sphere(96, 48));
    const glm::dmat4 turn = glm::rotate(at(0.9, 0.3, 0.2), 0.7, glm::dvec3(0.3, 0.5, 0.1));
    const std::vector<hw::LineObject> objects{{&ball}, {&ball, turn}};
    const auto lines = hw::find_intersections(objects);
    const double apart = glm::length(glm::dvec3(0.9, 0.3, 0.2));
    const double radius = std::sqrt(1.0 - 0.25 * apart * apart);
    EXPECT_NEAR(length_of(lines), 2.0 * 3.141592653589793 * radius, 0.01);
    EXPECT_EQ(odd_joints(lines), 0u);
}

TEST(intersections, lines_are_closed_also_where_vertices_lie_in_faces)
{
    // The box's corners and edges lie exactly in planes, on edges and on vertices of the grid of the other.
    const hw::Surface ring = hw::build_surface(torus(32, 16));
    const hw::Surface block = hw::build_surface(box({0, -1, 0}, {2, 0, 2}));
    for (const glm::dmat4& place : {at(0, 0, 0), at(0.5, 0, 0), at(1, 0, 0), at(-1, 0, -1)}) {
        const std::vector<hw::LineObject> objects{{&ring}, {&block, place}};
        EXPECT_EQ(odd_joints(hw::find_intersections(objects)), 0u);
    }
}

TEST(intersections, do_not_depend_on_scale_and_are_the_same_every_time)
{
    const hw::Surface ball = hw::build_surface(sphere(24, 12));
    std::size_t count = 0;
    for (const double scale : {1.0, 1e-6, 1e6}) {
        const glm::dmat4 larger = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
        const std::vector<hw::LineObject> objects{{&ball, larger}, {&ball, larger * at(0.7, 0.1, 0.2)}};
        const auto lines = hw::find_intersections(objects), again = hw::find_intersections(objects);
        ASSERT_EQ(lines.size(), again.size());
        for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i].ends_world, again[i].ends_world);
        if (count == 0) count = lines.size();
        EXPECT_EQ(lines.size(), count);
    }
}

TEST(intersections, are_hidden_and_joined_like_all_lines)
{
    const PostInFloor scene;
    const auto cuts = hw::find_intersections(scene.objects);
    const hw::LineCamera camera{.eye_world = {6, 5, 8}, .target_world = {0, 0, 0}, .size_px = {800, 600}};
    int visible = 0, hidden = 0;
    for (const auto& line :
         hw::find_visible_lines(scene.objects, camera, {.with_hidden = true, .intersections = cuts})) {
        if (line.line_class != hw::LineClass::intersection) continue;
        EXPECT_EQ(line.object, 0u);
        ++(line.is_visible ? visible : hidden);
    }
    EXPECT_EQ(visible, 1);  // around the two sides that are seen
    EXPECT_EQ(hidden, 1);
}
