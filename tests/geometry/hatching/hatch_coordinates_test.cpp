#include "hatchway/geometry/hatching/hatch_coordinates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/geometry/test_meshes.hpp"

namespace hw::test {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr HatchSource kSources[] = {HatchSource::box, HatchSource::cylinder, HatchSource::principal};

/// A tube around y without caps, radius 1, 2 high.
MeshData tube(int segments, int rows)
{
    std::vector<glm::vec3> positions;
    for (int row = 0; row <= rows; ++row)
        for (int i = 0; i < segments; ++i) {
            const float angle = 2.0f * kPi * static_cast<float>(i) / static_cast<float>(segments);
            const float height = 2.0f * static_cast<float>(row) / static_cast<float>(rows);
            positions.emplace_back(std::sin(angle), height, std::cos(angle));
        }
    std::vector<std::uint32_t> indices;
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < segments; ++i) {
            const auto at = [&](int r, int s) { return static_cast<std::uint32_t>(r * segments + s % segments); };
            for (const std::uint32_t v :
                 {at(row, i), at(row, i + 1), at(row + 1, i + 1), at(row, i), at(row + 1, i + 1), at(row + 1, i)})
                indices.push_back(v);
        }
    return mesh_of(positions, indices);
}

void expect_to_repeat(const MeshData& mesh, const HatchCoordinates& hatch)
{
    ASSERT_EQ(hatch.indices.size(), mesh.indices.size());
    ASSERT_EQ(hatch.uv.size(), hatch.vertex.size());
    ASSERT_EQ(hatch.direction.size(), hatch.vertex.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        ASSERT_LT(hatch.indices[i], hatch.vertex.size());
        ASSERT_EQ(hatch.vertex[hatch.indices[i]], mesh.indices[i]) << "corner " << i;
    }
    for (std::size_t i = 0; i < hatch.uv.size(); ++i) {
        ASSERT_TRUE(std::isfinite(hatch.uv[i].x) && std::isfinite(hatch.uv[i].y)) << i;
        ASSERT_NEAR(glm::length(hatch.direction[i]), 1.0f, 1e-3f) << i;
    }
}

/// The gradients of u and v on a triangle, metres per metre along the surface.
std::array<glm::vec3, 2> gradients(const MeshData& mesh, const HatchCoordinates& hatch, std::size_t triangle)
{
    std::array<glm::vec3, 3> p;
    std::array<glm::vec2, 3> uv;
    for (int c = 0; c < 3; ++c) {
        p[c] = mesh.positions[mesh.indices[triangle * 3 + c]];
        uv[c] = hatch.uv[hatch.indices[triangle * 3 + c]];
    }
    const glm::vec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    const glm::vec3 normal = area / glm::dot(area, area);
    std::array<glm::vec3, 2> result{};
    for (int c = 0; c < 3; ++c) {
        const glm::vec3 g = glm::cross(normal, p[(c + 2) % 3] - p[(c + 1) % 3]);
        result[0] += g * uv[c].x;
        result[1] += g * uv[c].y;
    }
    return result;
}

}  // namespace

TEST(hatch_coordinates, a_box_has_six_charts_that_meet_at_creases_alone)
{
    const HatchCoordinates hatch = make_hatch_coordinates(box({0, 0, 0}, {1, 2, 3}), HatchSource::box);
    EXPECT_EQ(hatch.report.charts, 6u);
    EXPECT_EQ(hatch.report.crease_edges, 12u);
    EXPECT_EQ(hatch.report.chart_border_edges, 0u);
}

TEST(hatch_coordinates, seen_from_outside_v_lies_to_the_left_of_u_on_every_side_of_a_box)
{
    const MeshData mesh = box({0, 0, 0}, {1, 2, 3});
    const HatchCoordinates hatch = make_hatch_coordinates(mesh, HatchSource::box);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto [u, v] = gradients(mesh, hatch, t);
        const glm::vec3 a = mesh.positions[mesh.indices[t * 3]];
        const glm::vec3 normal = glm::normalize(
            glm::cross(mesh.positions[mesh.indices[t * 3 + 1]] - a, mesh.positions[mesh.indices[t * 3 + 2]] - a));
        EXPECT_NEAR(glm::dot(glm::cross(u, v), normal), 1.0f, 1e-4f) << "triangle " << t;
    }
}

TEST(hatch_coordinates, a_smooth_sphere_is_stretched_little_by_the_box_and_its_breaks_are_counted)
{
    const MeshData mesh = sphere(48, 24);
    const HatchCoordinates hatch = make_hatch_coordinates(mesh, HatchSource::box);
    expect_to_repeat(mesh, hatch);
    EXPECT_EQ(hatch.report.crease_edges, 0u);
    EXPECT_GT(hatch.report.chart_border_edges, 60u);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto [u, v] = gradients(mesh, hatch, t);
        EXPECT_GT(glm::length(glm::cross(u, v)), 0.5f) << "triangle " << t;
    }
}

TEST(hatch_coordinates, the_cylinder_goes_round_a_tube_and_breaks_along_one_line)
{
    const MeshData mesh = tube(32, 5);
    const HatchCoordinates hatch = make_hatch_coordinates(mesh, HatchSource::cylinder);
    expect_to_repeat(mesh, hatch);
    EXPECT_EQ(hatch.report.charts, 1u);
    EXPECT_EQ(hatch.report.chart_border_edges, 5u);
    const auto [low, high] = std::ranges::minmax(hatch.uv, {}, &glm::vec2::x);
    EXPECT_NEAR(high.x - low.x, 2.0f * kPi, 0.01f);
}

TEST(hatch_coordinates, principal_strokes_go_round_a_tube)
{
    const MeshData mesh = tube(32, 8);
    const HatchCoordinates hatch = make_hatch_coordinates(mesh, HatchSource::principal);
    expect_to_repeat(mesh, hatch);
    EXPECT_EQ(hatch.report.charts, 1u);
    EXPECT_EQ(hatch.report.singularities, 0u);
    EXPECT_GE(hatch.report.chart_border_edges, 8u);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto [u, v] = gradients(mesh, hatch, t);
        EXPECT_LT(std::abs(u.y), 0.05f) << "u rises round the tube, triangle " << t;
        EXPECT_NEAR(glm::length(u), 1.0f, 0.1f);
        EXPECT_NEAR(std::abs(v.y), 1.0f, 0.1f);
    }
    for (const glm::vec3& direction : hatch.direction) EXPECT_LT(std::abs(direction.y), 0.05f);
}

TEST(hatch_coordinates, principal_strokes_go_round_the_thin_way_of_a_torus_without_a_singular_point)
{
    const MeshData mesh = torus(48, 24, 1.0f, 0.3f);
    const HatchCoordinates hatch = make_hatch_coordinates(mesh, HatchSource::principal);
    expect_to_repeat(mesh, hatch);
    EXPECT_EQ(hatch.report.singularities, 0u);
    EXPECT_EQ(hatch.report.charts, 1u);
    std::size_t along_the_ring = 0;
    for (std::size_t i = 0; i < hatch.vertex.size(); ++i) {
        const glm::vec3 p = mesh.positions[hatch.vertex[i]];
        const glm::vec3 ring = glm::normalize(glm::vec3(-p.z, 0.0f, p.x));
        if (std::abs(glm::dot(ring, hatch.direction[i])) > 0.3f) ++along_the_ring;
    }
    EXPECT_LT(static_cast<double>(along_the_ring), 0.05 * static_cast<double>(hatch.vertex.size()));
}

TEST(hatch_coordinates, a_sphere_has_singular_points_since_no_direction_is_continuous_on_it)
{
    const HatchCoordinates hatch = make_hatch_coordinates(sphere(32, 16), HatchSource::principal);
    EXPECT_GE(hatch.report.singularities, 2u);
    EXPECT_LE(hatch.report.singularities, 16u);
    EXPECT_EQ(hatch.report.charts, 1u);
}

TEST(hatch_coordinates, flat_ground_has_level_strokes_and_no_break)
{
    const MeshData mesh = sheet(8, [](float, float) { return 0.0f; });
    const HatchCoordinates hatch = make_hatch_coordinates(mesh, HatchSource::principal);
    EXPECT_EQ(hatch.report.charts, 1u);
    EXPECT_EQ(hatch.report.chart_border_edges, 0u);
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
        EXPECT_NEAR(std::abs(gradients(mesh, hatch, t)[0].x), 1.0f, 0.02f);
}

TEST(hatch_coordinates, a_scaled_and_moved_mesh_has_scaled_coordinates)
{
    const MeshData mesh = torus(24, 12);
    MeshData large = mesh;
    for (glm::vec3& p : large.positions) p = p * 1024.0f;
    for (const HatchSource source : kSources) {
        const HatchCoordinates small = make_hatch_coordinates(mesh, source);
        const HatchCoordinates scaled = make_hatch_coordinates(large, source);
        ASSERT_EQ(small.uv.size(), scaled.uv.size());
        EXPECT_EQ(small.report.chart_border_edges, scaled.report.chart_border_edges);
        for (std::size_t i = 0; i < small.uv.size(); ++i)
            EXPECT_LT(glm::length(scaled.uv[i] / 1024.0f - small.uv[i]), 1e-3f) << i;
    }
}

TEST(hatch_coordinates, hard_meshes_give_finite_coordinates_for_every_triangle)
{
    MeshData caps = mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3, 1, 1, 3});
    MeshData fan = mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0.5f}}, {0, 1, 2, 0, 1, 3, 0, 1, 4});
    MeshData sliver = mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5f, 1e-8f, 0}}, {0, 1, 2});
    for (const MeshData& mesh : {caps, fan, sliver, moebius_strip(40), klein_bottle(24, 12), flat_shaded(torus(16, 8)),
                                 joined({sphere(12, 6), box({2, 0, 0}, {3, 1, 1})}), mesh_of({}, {})})
        for (const HatchSource source : kSources) expect_to_repeat(mesh, make_hatch_coordinates(mesh, source));
}

TEST(hatch_coordinates, one_mesh_has_one_answer)
{
    const MeshData mesh = sphere(24, 12);
    const HatchCoordinates once = make_hatch_coordinates(mesh, HatchSource::principal);
    const HatchCoordinates again = make_hatch_coordinates(mesh, HatchSource::principal);
    EXPECT_TRUE(once.uv == again.uv && once.indices == again.indices);
}

}  // namespace hw::test
