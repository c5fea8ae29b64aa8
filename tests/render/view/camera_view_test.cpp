// The depth range of a view: what is far away, or without end, takes nothing of what is near.
#include "hatchway/render/view/camera_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "hatchway/render/view/frame_block.hpp"
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

constexpr glm::ivec2 kSize{320, 240};
const std::vector<Box> kHouse{{{0, 0, 0}, {6, 3, 4}}, {{0, 3, 0}, {6, 5, 4}}, {{6, 0, 0}, {10, 3, 4}}};
const CameraPlace kOutside{{9, 6, 12}, {0, 2, 0}}, kInside{{5, 1.7, 2}, {0, 1.7, 2}};
const CameraPlace kPlan{{5, 20, 2}, {5, 0, 2}, 60.0, 8.0};
const Box kGround{{-1e5, -1.001, -1e5}, {1e5, -1, 1e5}};

Box box_at(const glm::dvec3& place)
{
    return {place, place + 0.5};
}

const std::vector<std::vector<Box>> kFar{
    {box_at({1e3, 0, 0})},
    {box_at({1e5, 0, 0})},
    {box_at({1e7, 0, 0})},
    {box_at({-1e9, 1e9, 1e9})},
    {box_at({1e7, 0, 0}), box_at({-1e6, 0, 0}), box_at({0, 3e4, 0}), box_at({0, -1e8, 0}), box_at({2e3, 0, 2e3})},
    {kGround},
    {kGround, box_at({1e7, 0, 0})},
    {Box{{1e6, 0, 0}, {1e6 + 10, 5, 4}}}};

std::vector<Box> scaled(std::vector<Box> boxes, double factor)
{
    for (Box& box : boxes) box = {factor * box.min, factor * box.max};
    return boxes;
}

float near_plane(const CameraPlace& camera, const std::vector<Box>& boxes)
{
    return depth_range(camera_view(camera, kSize, boxes)).x;
}

}  // namespace

TEST(depth_range_of_a_view, is_that_of_what_is_near_whatever_lies_far_away)
{
    for (const CameraPlace& camera : {kOutside, kInside})
        for (const std::vector<Box>& far : kFar) {
            std::vector<Box> boxes = kHouse;
            boxes.insert(boxes.end(), far.begin(), far.end());
            const bool is_at_ground = camera.eye_world == kOutside.eye_world && far[0].min.x == kGround.min.x;
            const float alone = near_plane(camera, kHouse);
            EXPECT_FLOAT_EQ(near_plane(camera, boxes), is_at_ground ? std::min(alone, 3.5f) : alone) << far[0].max.x;
            std::ranges::reverse(boxes);
            EXPECT_FLOAT_EQ(near_plane(camera, boxes), is_at_ground ? std::min(alone, 3.5f) : alone) << far[0].max.x;
        }
}

TEST(depth_range_of_a_view, is_that_of_a_scene_of_millimetres_with_a_stray_a_metre_away)
{
    const CameraPlace camera{1e-3 * kOutside.eye_world, 1e-3 * kOutside.target_world};
    std::vector<Box> boxes = scaled(kHouse, 1e-3);
    const float alone = near_plane(camera, boxes);
    boxes.push_back(box_at({1, 0, 0}));
    EXPECT_FLOAT_EQ(near_plane(camera, boxes), alone);
}

TEST(depth_range_of_a_view, is_that_of_the_cluster_where_the_eye_is)
{
    std::vector<Box> boxes = kHouse;
    for (const Box& box : kHouse) boxes.push_back({box.min + glm::dvec3(1e6, 0, 0), box.max + glm::dvec3(1e6, 0, 0)});
    const CameraPlace there{kOutside.eye_world + glm::dvec3(1e6, 0, 0), kOutside.target_world + glm::dvec3(1e6, 0, 0)};
    EXPECT_FLOAT_EQ(near_plane(kOutside, boxes), near_plane(kOutside, kHouse));
    EXPECT_FLOAT_EQ(near_plane(there, boxes), near_plane(kOutside, kHouse));
}

TEST(depth_range_of_a_view, holds_what_is_far_away_also_in_floats)
{
    for (double distance = 1e3; distance < 1e10; distance *= 1.7) {
        std::vector<Box> boxes = kHouse;
        boxes.push_back(box_at({distance, 0, 0}));
        const View view = camera_view({{9, 6, 12}, {distance, 6, 12}}, kSize, boxes);
        const glm::vec4 clip = view.clip_from_view * glm::vec4(0.0f, 0.0f, -static_cast<float>(distance), 1.0f);
        EXPECT_LT(clip.z, clip.w) << distance;
        EXPECT_GT(depth_range(view).y, distance);
    }
}

TEST(depth_range_of_a_view, far_from_the_origin_misses_nothing_that_is_shown)
{
    for (const glm::dvec3& origin : {glm::dvec3(0.0), glm::dvec3(4194304, 0, -2097152), glm::dvec3(-12958095, 0, 0)}) {
        const Box boxes{origin + glm::dvec3(-2, 0, -2), origin + glm::dvec3(2, 1.5, 2)};
        const CameraPlace camera{origin + glm::dvec3(7, 4, 9), origin + glm::dvec3(0, 1, 0), 60.0, 9.0};
        const View view = camera_view(camera, kSize, std::span(&boxes, 1));
        EXPECT_FALSE(is_beyond(view, boxes)) << origin.x;
    }
}

TEST(depth_range_of_a_view, of_a_plan_is_fine_whatever_lies_beside_or_far_below_it)
{
    const glm::vec2 alone = depth_range(camera_view(kPlan, kSize, kHouse));
    for (const Box& far : {box_at({1e7, 0, 0}), box_at({0, -1e7, 0}), box_at({1e6, -1e6, 1e5})}) {
        std::vector<Box> boxes = kHouse;
        boxes.push_back(far);
        const View view = camera_view(kPlan, kSize, boxes);
        EXPECT_NEAR(depth_range(view).x, alone.x, 0.01);
        EXPECT_NEAR(depth_range(view).y, alone.y, 0.01);
        EXPECT_EQ(is_beyond(view, far), far.min.x == 0.0) << "what is below the house is told, not what is beside it";
    }
    std::vector<Box> boxes = kHouse;
    boxes.push_back(box_at({4, -1000, 0}));
    const View view = camera_view(kPlan, kSize, boxes);
    EXPECT_GT(depth_range(view).y, 1020.0f) << "what does not make depth coarse is shown";
    EXPECT_FALSE(is_beyond(view, boxes.back()));
}

namespace {

class far_away : public RendererTest {
 protected:
    Pixels seen(const glm::dvec3& eye, const glm::dvec3& target)
    {
        load(style_);
        std::vector<Box> boxes;
        for (const Object& object : scene_.objects) boxes.push_back(object.bounds_world);
        return draw(camera_view({eye, target, 60.0}, kSize, boxes), {.samples = 1});
    }
    void box(const glm::dvec3& at, double size)
    {
        add_object(scene_, box_mesh(glm::vec3(static_cast<float>(size))), glm::translate(glm::dmat4(1.0), at),
                   painted(glm::vec3(0.8f)));
    }
    /// A floor with a block on it, in the sun.
    void lit_block(const glm::dvec3& at)
    {
        style_.fragment_file = "test_shadow.frag";
        style_.shadow = ShadowNeed::main_light;
        input_.lights = {{.type = LightType::sun, .intensity = 50'000.0f, .direction_world = {-0.5, -0.5, 0.2}}};
        add_object(scene_, floor_mesh(12.0f), glm::translate(glm::dmat4(1.0), at), painted(glm::vec3(0.6f)));
        box(at + glm::dvec3(0, 1, 0), 2.0);
    }
    TestStyle style_{glm::vec3(0.0f)};
};

}  // namespace

TEST_F(far_away, strays_change_no_pixel_where_they_are_not_seen)
{
    box({0, 0, 0}, 2.0);
    const Pixels alone = seen({3, 2, 4}, {0, 0, 0});
    for (const glm::dvec3& at : {glm::dvec3(1e7, 0, 0), glm::dvec3(-1e6, 0, 0), glm::dvec3(0, 1e9, 0)}) box(at, 0.5);
    EXPECT_EQ(seen({3, 2, 4}, {0, 0, 0}).bytes, alone.bytes);
}

TEST_F(far_away, strays_and_other_places_change_no_shadow)
{
    const glm::dvec3 eye(6, 5, 2), there(1e6, 0, 0);
    style_ = TestStyle(glm::vec3(0.9f));
    lit_block({0, 0, 0});
    const Pixels alone = seen(eye, {0, 0, 0});
    EXPECT_GT(count_dark(alone, 60), 200) << "the shadow";
    for (const glm::dvec3& at : {glm::dvec3(1e3, 0, 0), glm::dvec3(-1e6, 0, 0), glm::dvec3(0, 1e9, 0)}) box(at, 0.5);
    EXPECT_EQ(seen(eye, {0, 0, 0}).bytes, alone.bytes);
    lit_block(there);
    EXPECT_EQ(seen(eye, {0, 0, 0}).bytes, alone.bytes);
    EXPECT_LE(share_unlike(alone, seen(there + eye, there), 3), 0.002);
}

TEST_F(far_away, a_stray_that_is_large_enough_is_seen)
{
    box({0, 0, 0}, 2.0);
    box({1e7, 0, 0}, 1e6);
    EXPECT_GT(count_dark(seen({3, 0, 0}, {1e7, 0, 0})), 300);
}

}  // namespace hw::test
