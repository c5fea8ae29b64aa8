#include "hatchway/geometry/surface/inherited_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/geometry/surface/angle_change.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

/// An ellipsoid whose poles are rings, as sines and cosines of floats leave them: `ring` wide.
hw::MeshData ellipsoid_with_pole_rings(float ring, const glm::mat4& place)
{
    constexpr int kSegments = 40, kRings = 20;
    hw::MeshData mesh;
    for (int r = 0; r <= kRings; ++r)
        for (int s = 0; s < kSegments; ++s) {
            const float polar = 3.14159265f * static_cast<float>(r) / kRings;
            const float round = 6.2831853f * static_cast<float>(s) / kSegments;
            const float radius = r == 0 || r == kRings ? ring : std::sin(polar);
            mesh.positions.push_back({radius * std::cos(round), 0.6f * std::cos(polar), radius * std::sin(round)});
        }
    for (int r = 0; r < kRings; ++r)
        for (int s = 0; s < kSegments; ++s) {
            const auto at = [&](int ring_at, int segment) {
                return static_cast<std::uint32_t>(ring_at * kSegments + segment % kSegments);
            };
            mesh.indices.insert(mesh.indices.end(), {at(r, s), at(r, s + 1), at(r + 1, s)});
            mesh.indices.insert(mesh.indices.end(), {at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
        }
    return moved(mesh, place);
}

}  // namespace

TEST(needles, the_pole_of_an_ellipsoid_has_no_star_of_lines)
{
    const glm::mat4 turned = glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(0.3f, 0.5f, 0.8f));
    for (const float ring : {4.4e-8f, 1e-7f, 6e-7f})
        for (const glm::mat4& place : {glm::mat4(1.0f), turned, glm::translate(turned, glm::vec3(0.5f, 2.0f, 0.25f))}) {
            const hw::Surface surface = hw::build_surface(ellipsoid_with_pole_rings(ring, place));
            const hw::EdgeClasses classes = hw::classes_at(surface, 0.6f);
            // The rings themselves are small borders of holes or fold onto themselves: nothing else is a line.
            double longest = 0.0;
            for (const hw::EdgeRange range : {classes.ridges[1], classes.valleys[1], classes.valleys[2]})
                for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
                    const auto [a, b] = hw::edge_vertices(surface, edge);
                    longest = std::max<double>(longest, glm::distance(surface.positions[a], surface.positions[b]));
                }
            EXPECT_LT(longest, 1e-5) << ring;
        }
}

TEST(needles, a_cap_that_lies_almost_on_a_line_takes_the_plane_beyond_its_longest_side)
{
    // A folded strip whose fold is cut by a vertex one step off the line.
    const float off = std::nextafter(1.0f, 2.0f) - 1.0f;
    const hw::MeshData mesh = mesh_of({{1, 1, 0}, {1, 1, 2}, {1 + off, 1 + off, 1}, {0, 1, 1}, {1, 0, 1}},
                                      {0, 1, 3, 0, 2, 1, 0, 4, 2, 2, 4, 1});
    const hw::Surface surface = hw::build_surface(mesh);
    EXPECT_EQ(surface.report.needle_faces, 1u);
    const hw::EdgeClasses classes = hw::classes_at(surface, 0.6f);
    EXPECT_EQ(classes.crease_count(), 2u);  // the fold, in two pieces
}

TEST(needles, two_that_share_their_longest_side_take_the_planes_around_them)
{
    // A ribbon of two needles between two faces at a right angle.
    const float thin = 1e-7f;
    const hw::MeshData mesh = mesh_of({{1, 1, 0}, {1, 1, 2}, {1, 1 - thin, 0}, {1, 1 - thin, 2}, {0, 1, 1}, {1, 0, 1}},
                                      {0, 1, 4, 0, 2, 1, 1, 2, 3, 2, 5, 3});
    const hw::Surface surface = hw::build_surface(mesh);
    ASSERT_EQ(surface.report.needle_faces, 2u);
    for (const auto& entry : surface.filter.inherited) EXPECT_NE(entry.source, hw::kNoFace);
    EXPECT_EQ(hw::classes_at(surface, 0.6f).crease_count(), 1u);
}

TEST(needles, thin_faces_whose_corners_are_well_known_keep_their_planes)
{
    EXPECT_FALSE(hw::is_needle({0, 0, 0}, {1, 0, 0}, {0.5f, 1e-5f, 0}));           // thin, but not uncertain
    EXPECT_FALSE(hw::is_needle({8e6f, 0, 0}, {8e6f + 8, 0, 0}, {8e6f, 0.5f, 0}));  // uncertain, but not thin
    EXPECT_TRUE(hw::is_needle({1, 1, 0}, {1, 1, 1}, {1, std::nextafter(1.0f, 2.0f), 0.5f}));
    EXPECT_TRUE(hw::is_needle({0, 0, 0}, {1, 0, 0}, {3, 0, 0}));
}

TEST(folds, are_angles_in_the_world)
{
    // A ridge of 30 degrees becomes one of 94 under a scale of 1, 4, 1, and a ridge of 94 one of 30 under the inverse.
    const auto roof = [](float height) {
        return mesh_of({{-1, 0, -1}, {-1, 0, 1}, {0, height, 1}, {0, height, -1}, {1, 0, 1}, {1, 0, -1}},
                       {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5});
    };
    const float low = std::tan(0.2617994f);
    const glm::dmat3 up = glm::dmat3(glm::scale(glm::dmat4(1.0), glm::dvec3(1, 4, 1)));
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 0.8, glm::dvec3(1, 2, 3)));
    const auto ridges = [](const hw::MeshData& mesh, const glm::dmat3& map) {
        return hw::classes_at(hw::build_surface(mesh, {.world_from_object = map}), 0.7f).ridges[1].size();
    };
    EXPECT_EQ(ridges(roof(low), glm::dmat3(1.0)), 0u);
    EXPECT_EQ(ridges(roof(low), up), 1u);
    EXPECT_EQ(ridges(roof(low), turn * up), 1u);
    EXPECT_EQ(ridges(roof(low), -up), 1u);  // mirrored
    EXPECT_EQ(ridges(roof(4.0f * low), glm::inverse(up)), 0u);
    EXPECT_EQ(ridges(roof(low), 1e-4 * turn), 0u);
    EXPECT_EQ(ridges(roof(low), glm::dmat3(1, 0, 0, 0, 0, 0, 0, 0, 1)), 0u);  // flat: no angles
    // A shear brings the two slopes of 47 degrees to 76 and 63.
    EXPECT_EQ(ridges(roof(4.0f * low), glm::dmat3(1.0)), 1u);
    EXPECT_EQ(ridges(roof(4.0f * low), glm::dmat3(1, 3, 0, 0, 1, 0, 0, 0, 1)), 0u);
}

TEST(folds, what_turns_mirrors_and_scales_alike_changes_no_angle)
{
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 0.8, glm::dvec3(1, 2, 3)));
    EXPECT_TRUE(hw::angle_change(turn).is_none());
    EXPECT_TRUE(hw::angle_change(-1e-3 * turn).is_none());
    EXPECT_TRUE(hw::angle_change(glm::dmat3(0.0)).is_none());
    const glm::dmat3 uneven = turn * glm::dmat3(1, 0, 0, 0, 2, 0, 0, 0, 1);
    EXPECT_FALSE(hw::angle_change(uneven).is_none());
    EXPECT_EQ(hw::angle_change(uneven), hw::angle_change(5.0 * glm::transpose(turn) * uneven));
}
