// Parallel projections, cameras turned about their line of sight, and scenes far from the origin, on the device.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

class parallel_view : public RendererTest {
 protected:
    void add(MeshData mesh, const glm::dvec3& place)
    {
        add_object(scene_, std::move(mesh), glm::translate(glm::dmat4(1.0), place), painted(glm::vec3(0.8f)));
    }
    Pixels seen(const CameraPlace& camera)
    {
        return draw(camera_view(camera, {320, 240}, scene_.bounds_world), {.samples = 1});
    }
    TestStyle style_{glm::vec3(0.0f)};
};

class turned_view : public parallel_view {};

/// Columns and rows that a picture has dark pixels in.
glm::ivec2 dark_extent(const Pixels& pixels)
{
    glm::ivec2 low(pixels.width, pixels.height), high(-1);
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            if (pixels.bytes[3 * (static_cast<std::size_t>(y) * pixels.width + x)] > 100) continue;
            low = glm::min(low, glm::ivec2(x, y));
            high = glm::max(high, glm::ivec2(x, y));
        }
    return high - low + 1;
}

}  // namespace

TEST_F(parallel_view, things_are_as_large_as_they_are_however_far_away)
{
    for (const double distance : {2.0, 20.0, 2000.0}) {
        scene_ = {};
        add(box_mesh({2.0f, 1.0f, 1.0f}), {0.25, 0.0, -distance});
        load(style_);
        // 240 pixels for 6 metres: 40 for one.
        EXPECT_EQ(dark_extent(seen({{0, 0, 0}, {0, 0, -1}, 60.0, 6.0})), glm::ivec2(80, 40)) << distance;
    }
}

TEST_F(parallel_view, what_is_behind_the_eye_is_not_seen)
{
    add(box_mesh({1.0f, 1.0f, 1.0f}), {0.0, 0.0, 3.0});
    load(style_);
    EXPECT_EQ(count_dark(seen({{0, 0, 0}, {0, 0, -1}, 60.0, 6.0})), 0);
    EXPECT_GT(count_dark(seen({{0, 0, 6}, {0, 0, 5}, 60.0, 6.0})), 1000);
}

TEST_F(turned_view, is_the_upright_one_turned)
{
    add(box_mesh({2.0f, 1.0f, 1.0f}), {0.25, 0.5, -3.0});
    load(style_);
    for (const glm::dvec3& target : {glm::dvec3(0, 0, -1), glm::dvec3(0.2, 0.1, -1)}) {
        const auto square = [&](double roll_deg) {
            return draw(camera_view({{0, 0, 0}, target, 60.0, {}, roll_deg}, {240, 240}, scene_.bounds_world),
                        {.samples = 1});
        };
        // Counter-clockwise goes the camera, clockwise what it shows: what was to the right is below.
        const Pixels upright = square(0.0), left = square(90.0), over = square(180.0);
        int unlike = 0;
        for (int y = 0; y < 240; ++y)
            for (int x = 0; x < 240; ++x) {
                const auto at = [](const Pixels& p, int u, int v) { return p.bytes[3 * (240 * v + u)] > 100; };
                unlike += at(upright, x, y) != at(left, 239 - y, x);
                unlike += at(upright, x, y) != at(over, 239 - x, 239 - y);
            }
        EXPECT_GT(count_dark(upright), 2000);
        EXPECT_LE(unlike, 20) << "edges of faces may fall a pixel beside";
    }
}

TEST_F(parallel_view, silhouettes_go_by_the_direction_alone)
{
    style_ = TestStyle(glm::vec3(1.0f));
    style_.look.emplace();
    add(sphere_mesh(1.0f, 16), {3.0, 0.0, 0.0});
    load(style_);
    const Pixels beside = seen({{0, 0, 10}, {0, 0, 0}, 60.0, 12.0});
    scene_ = {};
    add(sphere_mesh(1.0f, 16), {-3.0, 0.0, 0.0});
    load(style_);
    const Pixels other = seen({{0, 0, 10}, {0, 0, 0}, 60.0, 12.0});
    // Six metres apart are 120 pixels: the same lines in perspective would not be.
    int unlike = 0;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 200; ++x)
            unlike += std::abs(beside.bytes[3 * (static_cast<std::size_t>(y) * 320 + x + 120)] -
                               other.bytes[3 * (static_cast<std::size_t>(y) * 320 + x)]) > 8;
    EXPECT_GT(count_dark(beside), 100);
    EXPECT_LE(unlike, 4);
}

namespace {

/// A floor, two boxes and a sun, as far away as `place`.
void build_site(Scene& scene, const glm::dmat4& place)
{
    const Material grey = painted(glm::vec3(0.6f));
    const auto at = [&](double x, double y, double z) {
        return place * glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
    };
    add_object(scene, floor_mesh(12.0f), at(0, 0, 0), grey);
    add_object(scene, box_mesh({2.0f, 3.0f, 1.0f}), at(-1, 1.5, 0), grey);
    add_object(scene, box_mesh({1.0f, 1.0f, 1.0f}), at(1.5, 0.5, 1), grey);
}

}  // namespace

TEST_F(parallel_view, a_place_on_the_globe_is_lit_as_one_at_the_origin_is)
{
    style_.fragment_file = "test_shadow.frag";
    style_.shadow = ShadowNeed::main_light;
    input_.lights = {{.type = LightType::sun, .intensity = 50'000.0f, .direction_world = {-0.5, -0.7, -0.4}}};
    input_.exposure_ev = 15.0f;
    const auto picture = [&](const glm::dvec3& offset) {
        scene_ = {};
        build_site(scene_, glm::translate(glm::dmat4(1.0), offset));
        load(style_);
        return seen({offset + glm::dvec3(4, 3, 6), offset + glm::dvec3(0, 1, 0), 50.0, {}});
    };
    const Pixels near = picture({0, 0, 0});
    EXPECT_GT(count_dark(near, 60), 200) << "the shadow";
    for (const glm::dvec3& offset :
         {glm::dvec3(12'958'095.0, 0.0, -4'865'499.5), glm::dvec3(1e6, 8e6, 2e5), glm::dvec3(0.0, 6'378'137.0, 0.0)})
        EXPECT_LE(share_unlike(near, picture(offset), 3), 0.002) << offset.x << " " << offset.y << " " << offset.z;
}

}  // namespace hw::test
