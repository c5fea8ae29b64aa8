// The view that a mirror shows, and where in the picture the mirror is.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/render/view/mirror_view.hpp"

namespace hw::test {
namespace {

const Box kBounds{{-5, 0, -5}, {5, 4, 5}};
const MirrorPlane kPlane{glm::normalize(glm::dvec3(1.0, 0.2, 0.3)), -2.0};

glm::dvec4 clip_of(const View& view, const glm::dvec3& place)
{
    return glm::dmat4(view.clip_from_view) * glm::dmat4(view.view_from_world) * glm::dvec4(place, 1.0);
}

class mirror_view : public testing::TestWithParam<CameraPlace> {};

TEST_P(mirror_view, shows_places_where_their_reflections_are_and_ends_at_the_mirror)
{
    const View view = camera_view(GetParam(), {400, 300}, kBounds);
    const View mirrored = reflected_view(view, kPlane, {}, kBounds);
    EXPECT_TRUE(mirrored.is_mirrored);
    EXPECT_EQ(mirrored.is_orthographic(), view.is_orthographic());
    int before = 0, behind = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 place(-5 + i % 10, i / 10 % 10 * 0.4, -5 + i / 100);
        const glm::dvec4 clip = clip_of(mirrored, place);
        const glm::dvec4 direct = clip_of(view, kPlane.reflected(place));
        EXPECT_NEAR(clip.w, direct.w, 1e-4);
        EXPECT_NEAR(clip.x, direct.x, 1e-4);
        EXPECT_NEAR(clip.y, direct.y, 1e-4);
        const double height = kPlane.height(place);
        if (std::abs(height) < 1e-3 || clip.w <= 0.0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w)
            continue;
        EXPECT_EQ(clip.z > -clip.w, height > 0.0) << i;
        EXPECT_LT(clip.z, clip.w) << "nothing is too far away";
        ++(height > 0.0 ? before : behind);
    }
    EXPECT_GT(before, 50);
    EXPECT_GT(behind, 5);
}

TEST_P(mirror_view, keeps_the_order_of_depth_along_a_line_of_sight_and_is_the_view_again_when_mirrored_back)
{
    const View view = camera_view(GetParam(), {400, 300}, kBounds);
    const View mirrored = reflected_view(view, kPlane, {}, kBounds);
    const glm::dvec3 way = glm::dvec3(-0.6, -0.05, 0.1);
    double last = -2.0;
    for (int i = 1; i < 40; ++i) {
        // Beyond the mirror as the eye sees it, so before the mirror in its world.
        const glm::dvec4 clip = clip_of(mirrored, kPlane.reflected(view.eye_world + (7.5 + 0.3 * i) * way));
        EXPECT_GT(clip.z / clip.w, last);
        last = clip.z / clip.w;
    }
    const View back = reflected_view(mirrored, kPlane.turned(), {}, kBounds);
    EXPECT_FALSE(back.is_mirrored);
    EXPECT_LT(glm::length(back.eye_world - view.eye_world), 1e-12);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(back.view_from_world[i][k], view.view_from_world[i][k], 1e-6);
}

INSTANTIATE_TEST_SUITE_P(cameras, mirror_view,
                         testing::Values(CameraPlace{{3, 2, 1}, {-3, 1.5, 0}, 70.0},
                                         CameraPlace{{3, 2, 1}, {-3, 1.5, 0}, 60.0, 5.0}));

TEST(mirror_window, is_the_part_of_the_picture_that_holds_the_polygon)
{
    const View view = camera_view({{0, 0, 5}, {0, 0, 0}, 90.0}, {400, 400}, kBounds);
    const std::vector<glm::dvec3> square{{-1, -2, 0}, {3, -2, 0}, {3, 1, 0}, {-1, 1, 0}};
    const std::optional<PictureWindow> seen = window_of(square, view, {});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->min.x, -0.2, 1e-6);
    EXPECT_NEAR(seen->max.x, 0.6, 1e-6);
    EXPECT_NEAR(seen->min.y, -0.4, 1e-6);
    EXPECT_NEAR(seen->max.y, 0.2, 1e-6);
    const std::optional<PictureWindow> part = window_of(square, view, {{0.0, -1.0}, {0.5, 0.0}});
    ASSERT_TRUE(part);
    EXPECT_EQ(part->min.x, 0.0);
    EXPECT_EQ(part->max.x, 0.5);
    EXPECT_FALSE(window_of(square, view, {{0.7, -1.0}, {1.0, 1.0}})) << "it is beside the window";
    std::vector<glm::dvec3> behind = square;
    for (glm::dvec3& corner : behind) corner.z = 9.0;
    EXPECT_FALSE(window_of(behind, view, {})) << "it is behind the eye";
    const std::vector<glm::dvec3> beside{{-1, -1, 40}, {1, -1, -40}, {1, 3, -40}, {-1, 3, 40}};
    ASSERT_TRUE(window_of(beside, view, {})) << "it goes past the eye";
}

}  // namespace
}  // namespace hw::test
