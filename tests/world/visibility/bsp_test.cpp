#include "hatchway/world/visibility/tree/bsp.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hatchway/core/error.hpp"
#include "hatchway/world/visibility/tree/structure.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::SceneBuilder;

struct Built {
    Structure structure;
    BspBuild build;
};

Built built(const Scene& scene)
{
    StructureOptions options;
    options.least_area_share = 0.0;
    Built result;
    result.structure = choose_structure(scene, Level{}, options);
    const Structure& s = result.structure;
    result.build = build_bsp(s.grid, s.planes, s.polygons, s.box_min, s.box_max);
    return result;
}

double area_of_pieces(const BspBuild& build)
{
    double sum = 0.0;
    for (const auto& pieces : build.polygons_of_node) {
        for (const BlockingPolygon& piece : pieces) sum += area(piece.polygon);
    }
    return sum * build.tree.grid.step_m * build.tree.grid.step_m;
}

/// The sign by rational arithmetic, from the plane's whole numbers: shares nothing with the code but the plane.
int rational_sign(const Grid& grid, const ExactPlane& plane, const glm::dvec3& point)
{
    const auto whole = [](Int128 value) {
        const bool is_negative = value < 0;
        unsigned __int128 rest =
            is_negative ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
        mpz_class result = static_cast<unsigned long>(rest >> 64);
        result = (result << 64) + mpz_class(static_cast<unsigned long>(rest));
        return is_negative ? mpz_class(-result) : result;
    };
    mpq_class sum = mpq_class(whole(plane.offset)) * mpq_class(grid.step_m);
    for (int axis = 0; axis < 3; ++axis) {
        sum += mpq_class(whole(plane.normal[static_cast<std::size_t>(axis)])) *
               (mpq_class(point[axis]) - mpq_class(grid.origin_world[axis]));
    }
    return sgn(sum);
}

/// The leaf by walking the tree with rational signs.
int rational_leaf(const BspTree& tree, const glm::dvec3& point)
{
    int child = tree.nodes.empty() ? ~0 : 0;
    while (child >= 0) {
        const BspNode& node = tree.nodes[static_cast<std::size_t>(child)];
        child = rational_sign(tree.grid, node.plane, point) > 0 ? node.front : node.back;
    }
    return ~child;
}

void expect_exact(const Built& built, std::uint64_t seed)
{
    EXPECT_NEAR(area_of_pieces(built.build) / built.structure.area_m2, 1.0, 1e-9);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const Box& box = built.build.tree.bounds_world;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 point = box.min + box.size() * glm::dvec3(share(engine), share(engine), share(engine));
        ASSERT_EQ(leaf_at(built.build.tree, point), rational_leaf(built.build.tree, point));
    }
}

/// Random quads, nearly or exactly alike in plane.
Scene tangle(int count, std::uint64_t seed)
{
    SceneBuilder builder;
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> place(-5.0, 5.0);
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 corner(place(engine), place(engine), place(engine));
        const glm::dvec3 u(place(engine), place(engine), place(engine));
        const glm::dvec3 v(place(engine), place(engine), place(engine));
        builder.quad({{corner, corner + u, corner + u + v, corner + v}}, i % 2);
    }
    return builder.scene();
}

TEST(bsp, an_empty_scene_is_one_leaf)
{
    const Built result = built(Scene{});
    EXPECT_EQ(result.build.tree.leaf_count, 1);
    EXPECT_EQ(leaf_at(result.build.tree, {0, 0, 0}), 0);
}

TEST(bsp, a_tangle_keeps_its_area_and_classifies_exactly)
{
    for (const std::uint64_t seed : {1u, 2u, 3u}) expect_exact(built(tangle(40, seed)), seed);
}

TEST(bsp, a_splitter_a_hundred_thousandth_of_a_degree_from_a_polygon)
{
    SceneBuilder builder;
    const double tilt = 1e-5 * 3.14159265358979 / 180.0;
    builder.quad({{{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {5, 0, -5}}});
    builder.quad({{{-5, -5 * tilt, -5}, {-5, -5 * tilt, 5}, {5, 5 * tilt, 5}, {5, 5 * tilt, -5}}});
    builder.quad({{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}});
    expect_exact(built(builder.scene()), 4);
}

TEST(bsp, a_vertex_within_epsilon_of_a_splitter)
{
    for (const double epsilon : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 0.0, -1e-6, -1e-4}) {
        SceneBuilder builder;
        builder.quad({{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}});
        builder.quad({{{epsilon, 0, 0}, {3, 0, 1}, {4, 0.1, 3}, {1, 0.1, 2}}});
        builder.quad({{{-1, 1, 0}, {epsilon, 1, 1}, {2, 1.5, 2}, {-1, 1.5, 3}}});
        expect_exact(built(builder.scene()), 5);
    }
}

TEST(bsp, duplicate_planes_and_duplicate_polygons)
{
    SceneBuilder builder;
    for (int i = 0; i < 3; ++i) {
        builder.quad({{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}});
        builder.quad({{{0, -2, -2}, {0, -2, 2}, {0, 2, 2}, {0, 2, -2}}});
    }
    builder.quad({{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}});
    const Built result = built(builder.scene());
    EXPECT_EQ(result.build.tree.nodes.size(), 2u + 1u);  // one plane for all six, the last one on both sides of it
    expect_exact(result, 6);
}

TEST(bsp, tiny_fragments_keep_their_area)
{
    SceneBuilder builder;
    for (int i = 0; i < 60; ++i) {
        const double angle = 3.14159265358979 * i / 60.0;
        const glm::dvec3 out(5 * std::cos(angle), 0, 5 * std::sin(angle));
        builder.quad({{-out - glm::dvec3(0, 3, 0), out - glm::dvec3(0, 3, 0), out + glm::dvec3(0, 3, 0),
                       -out + glm::dvec3(0, 3, 0)}});
    }
    expect_exact(built(builder.scene()), 7);
}

TEST(bsp, slivers_of_one_to_a_hundred_million_are_left_out_or_kept_whole)
{
    SceneBuilder builder;
    builder.quad({{{0, 0, 0}, {1, 1e-8, 0}, {1, 2e-8, 0}, {0, 1e-8, 0}}});
    builder.quad({{{-5, -5, 1}, {5, -5, 1}, {5, 5, 1}, {-5, 5, 1}}});
    builder.quad({{{-5, -5, -1}, {5, -5, -1}, {5, 5, -1}, {-5, 5, -1}}});
    builder.quad({{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}}});
    expect_exact(built(builder.scene()), 8);
}

TEST(bsp, an_eye_on_a_plane_an_edge_or_a_vertex_has_one_leaf)
{
    SceneBuilder builder;
    builder.box({-4, -4, -4}, {4, 4, 4}, true);
    builder.box({-1, -1, -1}, {1, 1, 1}, false);
    const Built result = built(builder.scene());
    for (const glm::dvec3& eye : {glm::dvec3(1, 2, 0), glm::dvec3(1, 1, 3), glm::dvec3(1, 1, 1), glm::dvec3(4, 4, 4)}) {
        EXPECT_EQ(leaf_at(result.build.tree, eye), rational_leaf(result.build.tree, eye));
        EXPECT_GE(leaf_at(result.build.tree, eye), 0);
    }
    EXPECT_EQ(leaf_at(result.build.tree, {4.0001, 0, 0}), -1);
}

TEST(bsp, points_a_few_ulps_from_a_slanted_plane_are_classified_exactly)
{
    const Built result = built(tangle(10, 9));
    std::mt19937_64 engine(10);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    const Grid& grid = result.build.tree.grid;
    int near_zero = 0;
    for (const BspNode& node : result.build.tree.nodes) {
        for (int i = 0; i < 50; ++i) {
            glm::dvec3 p(3.0 * share(engine), 3.0 * share(engine), 3.0 * share(engine));
            p -= node.plane.unit_normal * (node.plane.distance((p - grid.origin_world) / grid.step_m) * grid.step_m);
            ASSERT_EQ(exact_sign(grid, node.plane, p), rational_sign(grid, node.plane, p));
            near_zero += std::abs(node.plane.distance((p - grid.origin_world) / grid.step_m)) < 1e-6;
        }
    }
    EXPECT_GT(near_zero, 100);
}

TEST(bsp, a_scene_far_from_the_origin_or_of_odd_size_is_as_exact)
{
    for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        SceneBuilder builder;
        const glm::dvec3 at(1e5 * scale, -2e4 * scale, 0);
        builder.box(at - 3.0 * scale, at + 3.0 * scale, true);
        builder.box(at - 1.0 * scale, at + 1.3 * scale, false);
        expect_exact(built(builder.scene()), 11);
    }
}

TEST(structure, a_merge_never_covers_a_hole)
{
    SceneBuilder builder;  // a wall of eight panels around an opening
    for (int u = -1; u <= 1; ++u) {
        for (int v = -1; v <= 1; ++v) {
            if (u == 0 && v == 0) continue;
            const double x = 2.0 * u - 1.0, y = 2.0 * v - 1.0;
            builder.quad({{{x, y, 0}, {x + 2, y, 0}, {x + 2, y + 2, 0}, {x, y + 2, 0}}});
        }
    }
    builder.box({-3, -3, -3}, {3, 3, 3}, true);
    const Structure structure = choose_structure(builder.scene(), Level{}, {});
    double area_in_wall = 0.0;
    for (const BlockingPolygon& polygon : structure.polygons) {
        const double z = polygon.polygon.corners[0].z * structure.grid.step_m + structure.grid.origin_world.z;
        const double z1 = polygon.polygon.corners[1].z * structure.grid.step_m + structure.grid.origin_world.z;
        const double z2 = polygon.polygon.corners[2].z * structure.grid.step_m + structure.grid.origin_world.z;
        if (std::abs(z) + std::abs(z1) + std::abs(z2) < 1e-6) area_in_wall += area(polygon.polygon);
    }
    EXPECT_NEAR(area_in_wall * structure.grid.step_m * structure.grid.step_m, 32.0, 1e-6);
}

TEST(structure, coplanar_panels_of_one_wall_are_merged)
{
    SceneBuilder builder;
    for (int u = 0; u < 8; ++u) {
        for (int v = 0; v < 4; ++v) {
            const double x = u, y = v;
            builder.quad({{{x, y, 2}, {x + 1, y, 2}, {x + 1, y + 1, 2}, {x, y + 1, 2}}});
        }
    }
    builder.box({-1, -1, -1}, {9, 5, 5}, true);
    EXPECT_LE(choose_structure(builder.scene(), Level{}, {}).polygons.size(), 4u);
}

TEST(structure, mask_blend_and_animated_triangles_never_block)
{
    SceneBuilder builder;
    builder.quad({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}}, SceneBuilder::kBlend);
    builder.quad({{{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}}}, SceneBuilder::kMask);
    builder.quad({{{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}}});
    builder.scene().nodes[2].is_animated = true;
    EXPECT_TRUE(choose_structure(builder.scene(), Level{}, {}).polygons.empty());
}

TEST(structure, a_name_that_reaches_no_node_is_an_error)
{
    SceneBuilder builder;
    builder.box({0, 0, 0}, {1, 1, 1}, false);
    Level level;
    level.structure = {"Wall*"};
    EXPECT_THROW(choose_structure(builder.scene(), level, {}), Error);
}

}  // namespace
}  // namespace hw
