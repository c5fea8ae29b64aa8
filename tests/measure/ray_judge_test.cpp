// The judge of visible lines on drawings that are broken on purpose, with lengths that are known.
#include "measure/lines/ray_judge.hpp"

#include <gtest/gtest.h>

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
