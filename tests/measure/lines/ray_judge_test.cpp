// The judge of visible lines on drawings that are broken on purpose, with lengths that are known.
#include "measure/lines/ray_judge.hpp"

#include <gtest/gtest.h>

#include <array>
#include <glm/trigonometric.hpp>

#include "tests/world/scene_builder.hpp"

using namespace hw;

namespace {

constexpr double kCrease = 0.7;

/// Looks along -z at a cube of 2 m, whose front face is 4 m away: the face is a square of 180 pixels.
const JudgeCamera kCamera{.eye_world = {0.0, 0.0, 5.0},
                          .target_world = {0.0, 0.0, 0.0},
                          .fov_rad = 2.0 * std::atan(0.5),
                          .size_px = {360, 360}};

Scene cube()
{
    test::SceneBuilder builder;
    builder.box({-1, -1, -1}, {1, 1, 1}, false);
    return builder.scene();
}

std::vector<JudgedLine> square(double from, double to)
{
    return {{{{from, from}, {to, from}, {to, to}, {from, to}, {from, from}}}};
}

RayVerdict verdict_of(const std::vector<JudgedLine>& found, const std::vector<JudgedLine>& drawn)
{
    const Scene scene = cube();
    return RayJudge(scene, kCrease).judge(kCamera, found, drawn);
}

}  // namespace

TEST(ray_judge, the_right_drawing_of_a_cube_has_nothing_missed_thinned_or_extra)
{
    const RayVerdict verdict = verdict_of(square(90, 270), square(90, 270));
    EXPECT_NEAR(verdict.visible_px, 720.0, 8.0);
    EXPECT_NEAR(verdict.found_px, 720.0, 1e-6);
    EXPECT_EQ(verdict.missed_px, 0.0);
    EXPECT_EQ(verdict.thinned_px, 0.0);
    EXPECT_EQ(verdict.extra_px, 0.0);
}

TEST(ray_judge, a_side_that_is_not_found_is_missed)
{
    const std::vector<JudgedLine> three{{{{90, 90}, {270, 90}, {270, 270}, {90, 270}}}};
    EXPECT_NEAR(verdict_of(three, three).missed_px, 180.0, 6.0);
    EXPECT_NEAR(verdict_of({}, {}).missed_px, 720.0, 8.0);
}

TEST(ray_judge, a_side_that_is_found_and_not_drawn_is_thinned_and_not_missed)
{
    const std::vector<JudgedLine> three{{{{90, 90}, {270, 90}, {270, 270}, {90, 270}}}};
    const RayVerdict verdict = verdict_of(square(90, 270), three);
    EXPECT_EQ(verdict.missed_px, 0.0);
    EXPECT_NEAR(verdict.thinned_px, 180.0, 6.0);
}

TEST(ray_judge, hidden_edges_and_inventions_are_extra)
{
    std::vector<JudgedLine> found = square(90, 270);
    const double back = 180.0 * 4.0 / 6.0 / 2.0;  // half the side of the hidden face
    for (const JudgedLine& line : square(180.0 - back, 180.0 + back)) found.push_back(line);
    EXPECT_NEAR(verdict_of(found, found).extra_px, 8.0 * back, 10.0);
    found = square(90, 270);
    found.push_back({{{20, 20}, {60, 20}}});
    EXPECT_NEAR(verdict_of(found, found).extra_px, 40.0, 1e-6);
    found.back().is_intersection = true;
    EXPECT_NEAR(verdict_of(found, found).unjudged_px, 40.0, 1e-6);
    EXPECT_EQ(verdict_of(found, found).extra_px, 0.0);
}

TEST(ray_judge, a_line_that_crosses_an_edge_does_not_stand_for_it)
{
    std::vector<JudgedLine> found{{{{90, 90}, {270, 90}, {270, 270}, {90, 270}}}};
    for (double y = 91.0; y < 270.0; y += 2.0) found.push_back({{{80, y}, {100, y}}});
    EXPECT_NEAR(verdict_of(found, found).missed_px, 180.0, 6.0);
}

TEST(ray_judge, an_edge_with_a_line_where_objects_go_through_each_other_is_told_apart)
{
    std::vector<JudgedLine> found = square(90, 270);
    found[0].is_intersection = true;
    const RayVerdict verdict = verdict_of(found, found);
    EXPECT_NEAR(verdict.crossed_px, 720.0, 8.0);
    EXPECT_NEAR(verdict.missed_px, 0.0, 8.0);
    EXPECT_EQ(verdict.found_px, 0.0);
    // Across the edge it stands for nothing.
    found = {{{{90, 90}, {270, 90}, {270, 270}, {90, 270}}}};
    for (double y = 91.0; y < 270.0; y += 2.0) found.push_back({{{80, y}, {100, y}}, true});
    EXPECT_NEAR(verdict_of(found, found).missed_px, 180.0, 6.0);
}

TEST(ray_judge, tells_how_much_of_the_found_lines_would_be_missed)
{
    EXPECT_NEAR(verdict_of(square(90, 270), {}).noticed_px, 720.0, 8.0);
    // A second square beside the first one would hide the loss of either.
    std::vector<JudgedLine> twice = square(90, 270);
    twice.push_back(square(90.2, 269.8)[0]);
    EXPECT_EQ(verdict_of(twice, twice).noticed_px, 0.0);
    // Of four lines each is left out in turn.
    const std::vector<JudgedLine> sides{
        {{{90, 90}, {270, 90}}}, {{{270, 90}, {270, 270}}}, {{{270, 270}, {90, 270}}}, {{{90, 270}, {90, 90}}}};
    double missed_px = 0.0;
    for (std::size_t left_out = 0; left_out < sides.size(); ++left_out) {
        std::vector<JudgedLine> kept = sides;
        kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(left_out));
        missed_px += verdict_of(kept, kept).missed_px;
    }
    EXPECT_NEAR(verdict_of(sides, sides).noticed_px, missed_px, 8.0);
}

namespace {

/// A roof whose ridge runs along z in the picture's middle, folded by less than a crease, over three quads a side.
/// `split` tells at which of the five inner edges, from left to right, the model's own normals differ.
Scene roof_with_split_normals(const std::array<bool, 5>& split)
{
    constexpr double kFoldRad = 0.2;
    MeshData mesh;
    mesh.has_own_normals = true;
    glm::dvec2 at(-0.9, 0.0);
    double slope = 2.5 * kFoldRad;
    glm::vec3 normal(0.0f);
    for (std::size_t strip = 0; strip < 6; ++strip, slope -= kFoldRad) {
        const glm::dvec2 next = at + 0.3 * glm::dvec2(std::cos(slope), std::sin(slope));
        if (strip == 0 || split[strip - 1]) normal = glm::vec3(-std::sin(slope), 0.0, std::cos(slope));
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec2& p : {at, next})
            for (const double y : {-1.0, 1.0}) mesh.positions.emplace_back(p.x, y, p.y);
        for (int i = 0; i < 4; ++i) mesh.normals.push_back(normal);
        for (const std::uint32_t i : {0u, 2u, 1u, 1u, 2u, 3u}) mesh.indices.push_back(first + i);
        at = next;
    }
    test::SceneBuilder builder;
    builder.add(std::move(mesh), test::SceneBuilder::kSingle);
    return builder.scene();
}

double visible_px(const Scene& scene)
{
    return RayJudge(scene, kCrease).judge(kCamera, {}, {}).visible_px;
}

}  // namespace

TEST(ray_judge, small_folds_are_lines_where_the_normals_split_but_not_all_of_them_do)
{
    const double outline = visible_px(roof_with_split_normals({}));
    const double one = visible_px(roof_with_split_normals({false, false, true})) - outline;
    EXPECT_GT(one, 150.0);
    EXPECT_NEAR(visible_px(roof_with_split_normals({false, true, true})) - outline, 2.0 * one, 0.1 * one);
    EXPECT_NEAR(visible_px(roof_with_split_normals({true, true, true, true, true})), outline, 1.0);
}

TEST(ray_judge, a_line_along_a_joint_in_one_plane_is_extra_though_edges_are_there)
{
    test::SceneBuilder builder;
    for (const double left : {-0.5, 0.5}) builder.box({left, -1.0, -1.0}, {left + 1.0, 1.0, 0.0}, false);
    const std::vector<JudgedLine> joint{{{{216.0, 112.0}, {216.0, 248.0}}}};
    const Scene scene = builder.scene();
    EXPECT_NEAR(RayJudge(scene, kCrease).judge(kCamera, joint, joint).extra_px, 136.0, 1e-6);
    const std::vector<JudgedLine> outline{{{{144.0, 112.0}, {144.0, 248.0}}}};
    EXPECT_EQ(RayJudge(scene, kCrease).judge(kCamera, outline, outline).extra_px, 0.0);
}

TEST(ray_judge, the_rim_of_a_gap_of_a_twentieth_of_a_pixel_is_not_extra)
{
    test::SceneBuilder builder;
    const double gap = 0.05 / 72.0;
    builder.box({-0.5, -1.0, -1.0}, {0.5, 1.0, 0.0}, false);
    builder.box({0.5 + gap, -1.0, -1.0}, {1.5, 1.0, 0.0}, false);
    const std::vector<JudgedLine> rim{{{{216.0, 112.0}, {216.0, 248.0}}}};
    EXPECT_EQ(RayJudge(builder.scene(), kCrease).judge(kCamera, rim, rim).extra_px, 0.0);
}

TEST(ray_judge, a_found_edge_of_three_faces_is_unsure)
{
    MeshData mesh;
    mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}};
    mesh.indices = {0, 1, 2, 0, 3, 1, 0, 1, 4};
    test::SceneBuilder builder;
    builder.add(std::move(mesh), test::SceneBuilder::kSingle);
    const Scene scene = builder.scene();
    const std::vector<JudgedLine> middle{{{{110.0, 180.0}, {250.0, 180.0}}}};
    const RayVerdict verdict = RayJudge(scene, kCrease).judge(kCamera, middle, middle);
    EXPECT_NEAR(verdict.unsure_px + verdict.extra_px, 140.0, 2.0);
    EXPECT_EQ(verdict.noticed_px, 0.0);
}

TEST(ray_judge, a_joint_beside_a_step_of_less_than_a_pixel_is_no_line)
{
    // Of two slabs side by side the left one ends after 1.8 pixels.
    const auto slabs = [](std::vector<std::array<double, 2>> ends) {
        test::SceneBuilder builder;
        for (const auto& [left, right] : ends) builder.box({left, -1.0, -1.0}, {right, 1.0, 0.0}, false);
        return builder.scene();
    };
    const double left = 0.5 - 1.8 / 72.0;
    EXPECT_NEAR(visible_px(slabs({{left, 0.5}, {0.5, 1.0}})), visible_px(slabs({{left, 1.0}})), 3.0);
}
