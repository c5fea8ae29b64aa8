#include "hatchway/geometry/silhouettes/silhouettes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "tests/geometry/silhouettes/silhouette_checks.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

constexpr auto kRational = hw::SilhouetteOracle::Arithmetic::rational_only;

}  // namespace

TEST(silhouettes, a_box_seen_at_a_corner_has_six)
{
    const hw::Surface surface = hw::build_surface(box({0, 0, 0}, {1, 1, 1}));
    hw::SilhouetteScratch scratch;
    EXPECT_EQ(hw::all_silhouettes(surface, {glm::dvec3(3, 4, 5)}, {}, scratch).size(), 6u);
    EXPECT_EQ(hw::all_silhouettes(surface, {glm::dvec3(0.5, 0.5, 5)}, {}, scratch).size(), 4u);
}

TEST(silhouettes, an_object_without_candidates_costs_nothing)
{
    const hw::Surface surface = hw::build_surface(box({0, 0, 0}, {1, 1, 1}));
    hw::SilhouetteScratch scratch;
    EXPECT_TRUE(hw::drawn_contours(surface, {glm::dvec3(3, 4, 5)}, {.crease_rad = 0.7f}, scratch).empty());
    EXPECT_EQ(scratch.counters.objects_without_work, 1u);
    EXPECT_EQ(scratch.counters.faces_tested, 0u);
    EXPECT_EQ(scratch.counters.edges_tested, 0u);
}

TEST(silhouettes, what_is_drawn_is_a_candidate_and_a_silhouette)
{
    const hw::Surface surface = hw::build_surface(torus(48, 24));
    hw::SilhouetteScratch scratch;
    for (const glm::dvec3& eye : eyes_around(surface)) {
        const auto all = hw::all_silhouettes(surface, {eye}, {}, scratch);
        const std::vector<std::uint32_t> silhouettes(all.begin(), all.end());
        const hw::EdgeRange convex = surface.edges.group(hw::EdgeGroup::convex);
        std::vector<std::uint32_t> expected;
        for (const std::uint32_t edge : silhouettes) {
            if (edge >= convex.begin && edge < convex.end) expected.push_back(edge);
        }
        const auto drawn = hw::drawn_contours(surface, {eye}, {.crease_rad = 3.2f}, scratch);
        EXPECT_TRUE(std::is_permutation(drawn.begin(), drawn.end(), expected.begin(), expected.end()));
    }
}

TEST(silhouettes, no_call_allocates_once_the_scratch_is_warm)
{
    const hw::Surface surface = hw::build_surface(sphere(64, 32), {.cluster_from_faces = 1});
    for (const auto method : {hw::SilhouetteMethod::brute, hw::SilhouetteMethod::hierarchy}) {
        hw::SilhouetteScratch scratch;
        const auto look_around = [&] {
            for (const glm::dvec3& eye : eyes_around(surface)) {
                hw::all_silhouettes(surface, {eye}, {.method = method}, scratch);
                hw::drawn_contours(surface, {eye}, {.method = method}, scratch);
            }
            const std::array<const void*, 5> memory{scratch.facing.data(), scratch.edges.data(), scratch.front.data(),
                                                    scratch.open.data(), scratch.mixed.data()};
            return memory;
        };
        const auto before = look_around();
        EXPECT_EQ(look_around(), before);
    }
}

TEST(silhouettes, the_filter_leaves_few_faces_open)
{
    const hw::Surface surface = hw::build_surface(sphere(256, 128));
    hw::SilhouetteScratch scratch;
    for (int i = 0; i < 20; ++i) {
        hw::find_facing(surface, {glm::dvec3(std::cos(i) * 3, 0.7 * i, std::sin(i) * 3)}, hw::FacingPrecision::exact,
                        scratch);
    }
    EXPECT_LT(scratch.counters.double_stage, scratch.counters.faces_tested / 500);
    EXPECT_EQ(scratch.counters.exact_stage, 0u);
}

TEST(silhouettes, the_hierarchy_finds_what_brute_force_finds)
{
    const hw::MeshData flat = moved(torus(96, 48), glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 1e-3f, 20.0f)));
    hw::MeshData moebius = moebius_strip(3000);
    for (const hw::MeshData& mesh : {torus(96, 48), sphere(128, 64, 1e-6f), flat, moebius, klein_bottle(64, 48)}) {
        const hw::Surface surface = hw::build_surface(mesh, {.is_solid = false, .cluster_from_faces = 1});
        ASSERT_FALSE(surface.clusters.is_empty());
        hw::SilhouetteScratch scratch;
        std::vector<hw::Viewpoint> views;
        for (const glm::dvec3& eye : eyes_around(surface)) views.push_back({eye});
        for (int i = 0; i < 27; ++i) views.push_back({glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), true});
        for (const hw::Viewpoint& view : views) {
            for (const auto find : {hw::all_silhouettes, hw::drawn_contours}) {
                const auto brute = find(surface, view, {.method = hw::SilhouetteMethod::brute}, scratch);
                std::vector<std::uint32_t> expected(brute.begin(), brute.end());
                const auto found = find(surface, view, {.method = hw::SilhouetteMethod::hierarchy}, scratch);
                std::vector<std::uint32_t> sorted(found.begin(), found.end());
                std::sort(sorted.begin(), sorted.end());
                ASSERT_EQ(sorted, expected);
            }
        }
    }
}

TEST(silhouettes, the_hierarchy_looks_at_few_faces_of_a_fine_mesh)
{
    const hw::Surface surface = hw::build_surface(sphere(512, 256), {.cluster_from_faces = 1});
    hw::SilhouetteScratch scratch;
    hw::all_silhouettes(surface, {glm::dvec3(2.0, 1.5, 2.5)}, {}, scratch);
    EXPECT_LT(scratch.counters.faces_tested, surface.faces.size() / 8);
    EXPECT_LT(scratch.counters.edges_tested, surface.edges.size() / 8);
}

TEST(silhouettes, the_hierarchy_finds_what_brute_force_finds_at_every_grazing_eye)
{
    // Eyes that lie in planes of faces, or a hair beside them, are where a box that is too sure would go wrong.
    const hw::Surface surface = hw::build_surface(sphere(48, 24), {.cluster_from_faces = 1});
    hw::SilhouetteScratch scratch;
    std::mt19937 random(17);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    for (const auto& corners : surface.faces) {
        const glm::dvec3 a = surface.positions[corners[0]], b = surface.positions[corners[1]],
                         c = surface.positions[corners[2]];
        const glm::dvec3 hair = 1e-5 * glm::dvec3(part(random), part(random), part(random));
        const hw::Viewpoint view{a + 20.0 * part(random) * (b - a) + 20.0 * part(random) * (c - a) + hair};
        const auto brute = hw::all_silhouettes(surface, view, {.method = hw::SilhouetteMethod::brute}, scratch);
        const std::vector<std::uint32_t> expected(brute.begin(), brute.end());
        const auto found = hw::all_silhouettes(surface, view, {.method = hw::SilhouetteMethod::hierarchy}, scratch);
        std::vector<std::uint32_t> sorted(found.begin(), found.end());
        std::sort(sorted.begin(), sorted.end());
        ASSERT_EQ(sorted, expected);
    }
}

TEST(silhouettes, are_exact_for_ten_thousand_random_eyes)
{
    const hw::Surface surface = hw::build_surface(torus(16, 10), {.cluster_from_faces = 1});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces);
    hw::SilhouetteScratch scratch;
    for (int i = 0; i < 10000; ++i) {
        const hw::Viewpoint viewpoint{glm::dvec3(place(random), place(random), place(random))};
        ASSERT_EQ(wrong_edges(surface, viewpoint, oracle, scratch), 0u) << "eye " << i;
    }
}

TEST(silhouettes, are_exact_at_every_offset_and_scale)
{
    for (const float offset : {0.0f, 1e3f, 1e5f, 1e6f}) {
        for (const float scale : {1e-6f, 1.0f, 1e6f}) {
            const glm::mat4 matrix = glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(offset)), glm::vec3(scale));
            const hw::Surface surface = hw::build_surface(moved(torus(24, 12), matrix), {.cluster_from_faces = 1});
            // Of a torus of two micrometres a kilometre away, floats leave one point.
            const bool is_one_point = scale == 1e-6f && offset > 0.0f;
            ASSERT_EQ(surface.faces.empty(), is_one_point);
            if (is_one_point) continue;
            EXPECT_EQ(wrong_edges_in_all_views(surface), 0u) << "offset " << offset << ", scale " << scale;
        }
    }
}

TEST(silhouettes, are_those_of_exact_world_space_where_a_node_turns_the_object_and_moves_it_far_away)
{
    const hw::Surface surface = hw::build_surface(torus(96, 48), {.cluster_from_faces = 1});
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces);
    hw::SilhouetteScratch scratch;
    std::size_t edges = 0, wrong = 0;
    for (const double offset : {0.0, 1e3, 1e5, 1e7}) {
        const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), glm::dvec3(offset));
        const glm::dmat4 world = glm::rotate(moved, 0.7, glm::normalize(glm::dvec3(3, 4, 5)));
        for (int i = 0; i < 40; ++i) {
            const glm::dvec3 eye_world(world * glm::dvec4(3.1 * std::cos(i), 0.07 * i - 1.3, 3.1 * std::sin(i), 1.0));
            const auto found = found_edges(surface, hw::in_object({eye_world}, world), scratch, {});
            const auto errors = oracle.judge(found, oracle.silhouettes_in_world(eye_world, world));
            edges += found.size();
            wrong += errors.false_positives + errors.false_negatives + errors.odd_vertices;
        }
    }
    EXPECT_GT(edges, 160u * 100u);
    EXPECT_EQ(wrong, 0u);
}

TEST(silhouette_oracle, sees_what_an_eye_in_floats_gets_wrong_far_from_the_origin)
{
    const hw::Surface surface = hw::build_surface(torus(96, 48));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces);
    hw::SilhouetteScratch scratch;
    const glm::dmat4 world = glm::translate(glm::dmat4(1.0), glm::dvec3(1e5));
    const glm::dvec3 eye_world(1e5 + 3.1234, 1e5 + 1.4321, 1e5 + 0.7171);
    const auto expected = oracle.silhouettes_in_world(eye_world, world);
    const hw::Viewpoint rounded = hw::in_object({glm::dvec3(glm::vec3(eye_world))}, world);
    const auto errors = oracle.judge(found_edges(surface, rounded, scratch, {}), expected);
    EXPECT_GT(errors.false_positives + errors.false_negatives, 0u);
}

TEST(silhouettes, are_exact_under_non_uniform_scale_and_one_ulp_of_noise)
{
    hw::MeshData mesh = moved(sphere(24, 16), glm::scale(glm::mat4(1.0f), glm::vec3(1e-4f, 1.0f, 1e4f)));
    EXPECT_EQ(wrong_edges_in_all_views(hw::build_surface(mesh, {.cluster_from_faces = 1})), 0u);
    std::mt19937 random(5);
    for (glm::vec3& p : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = std::nextafter(p[axis], random() % 2 ? 1e9f : -1e9f);
    }
    EXPECT_EQ(wrong_edges_in_all_views(hw::build_surface(mesh, {.cluster_from_faces = 1})), 0u);
}

TEST(silhouettes, are_exact_in_orthographic_views_also_parallel_to_faces)
{
    const hw::Surface surface = hw::build_surface(prism(8));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces, kRational);
    hw::SilhouetteScratch scratch;
    for (int i = 0; i < 27; ++i) {
        const hw::Viewpoint viewpoint{glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), true};
        EXPECT_EQ(wrong_edges(surface, viewpoint, oracle, scratch), 0u) << "direction " << i;
    }
}

TEST(silhouettes, floats_alone_are_wrong_where_the_exact_mode_is_right)
{
    const glm::mat4 far_away = glm::translate(glm::mat4(1.0f), glm::vec3(1e5f));
    const hw::Surface surface = hw::build_surface(moved(sphere(96, 48), far_away));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces);
    hw::SilhouetteScratch scratch;
    std::size_t wrong = 0;
    for (const glm::dvec3& eye : eyes_around(surface)) {
        wrong += wrong_edges(surface, {eye}, oracle, scratch, hw::FacingPrecision::single_only);
        EXPECT_EQ(wrong_edges(surface, {eye}, oracle, scratch), 0u);
    }
    EXPECT_GT(wrong, 0u);
}

TEST(silhouette_oracle, counts_one_edge_too_few_and_one_too_many)
{
    const hw::Surface surface = hw::build_surface(box({0, 0, 0}, {1, 1, 1}));
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces, kRational);
    const auto expected = oracle.silhouettes(glm::dvec3(3, 4, 5));
    ASSERT_EQ(expected.size(), 6u);
    const auto right = oracle.judge(expected, expected);
    EXPECT_EQ(right.false_positives + right.false_negatives + right.odd_vertices, 0u);

    auto found = expected;
    found.erase(found.begin() + 2);
    const auto too_few = oracle.judge(found, expected);
    EXPECT_EQ(too_few.false_positives, 0u);
    EXPECT_EQ(too_few.false_negatives, 1u);
    EXPECT_EQ(too_few.odd_vertices, 2u);

    found = expected;
    found.push_back({6, 7});  // the last of all in order, and no silhouette here
    const auto too_many = oracle.judge(std::span(found).first(7), expected);
    EXPECT_EQ(too_many.false_positives, 1u);
}
