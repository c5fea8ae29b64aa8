#include "hatchway/geometry/lines/line_crowding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

/// Upright lines in a plane, from -extent to extent.
std::vector<hw::CrowdingLine> hatched(float spacing, float extent)
{
    std::vector<hw::CrowdingLine> lines;
    const int count = static_cast<int>(extent / spacing);
    for (int i = -count; i <= count; ++i) {
        const float x = spacing * static_cast<float>(i) + 0.013f;
        lines.push_back({{glm::vec3(x, -extent, 0.1f), glm::vec3(x, extent, 0.1f)}, 1.0f});
    }
    return lines;
}

float share_at(const hw::LineCrowding& crowding, const glm::vec3& place, float window)
{
    return hw::crowded_share(crowding.at(place), window / crowding.window());
}

}  // namespace

TEST(line_crowding, a_line_alone_is_drawn_in_full_at_any_distance_that_shows_it)
{
    const std::vector<hw::CrowdingLine> line{{{glm::vec3(-3, -1, 2), glm::vec3(4, 2, 0)}, 1.0f}};
    const hw::LineCrowding crowding(line);
    for (const float t : {0.05f, 0.3f, 0.5f, 0.77f}) {
        const glm::vec3 place = glm::mix(line[0].ends[0], line[0].ends[1], t);
        for (const float window : {0.001f, 0.05f, 0.4f, 1.5f})
            EXPECT_GT(share_at(crowding, place, window), 0.85f) << t << ' ' << window;
    }
}

TEST(line_crowding, parallel_lines_get_the_ink_of_lines_a_full_spacing_apart)
{
    for (const float spacing : {0.02f, 0.05f}) {
        const hw::LineCrowding crowding(hatched(spacing, 1.0f));
        const glm::vec3 place(0.013f, 0.05f, 0.1f);
        for (const float crowded : {2.0f, 4.0f, 8.0f, 16.0f}) {
            const float window = crowded * spacing / hw::kFullSpacingInWindows;
            if (window > 0.35f) continue;
            EXPECT_NEAR(share_at(crowding, place, window) * crowded, 1.0f, 0.25f) << spacing << ' ' << crowded;
        }
        EXPECT_GT(share_at(crowding, place, 0.4f * spacing / hw::kFullSpacingInWindows), 0.8f);
    }
}

TEST(line_crowding, four_lines_in_one_place_get_the_ink_of_two)
{
    std::vector<hw::CrowdingLine> bundle;
    for (const float y : {0.0f, 0.01f, 0.02f, 0.03f})
        bundle.push_back({{glm::vec3(-2, y, 0), glm::vec3(2, y, 0)}, 1.0f});
    const hw::LineCrowding crowding(bundle);
    EXPECT_NEAR(share_at(crowding, {0.1f, 0.0f, 0.0f}, 0.5f), 0.5f, 0.06f);
    EXPECT_NEAR(share_at(crowding, {0.1f, 0.03f, 0.0f}, 0.5f), 0.5f, 0.06f);
}

TEST(line_crowding, falls_steadily_with_the_distance_and_without_a_step)
{
    const hw::Surface ball = hw::build_surface(sphere(48, 24));
    const hw::LineCrowding crowding(hw::crowding_lines(ball, 0.7f, nullptr, {}));
    const glm::vec4 here = crowding.at(ball.positions[100]);
    float before = 1.0f;
    for (float windows = 0.01f; windows < 4000.0f; windows *= 1.02f) {
        const float share = hw::crowded_share(here, windows);
        EXPECT_LE(share, before * 1.0001f);
        EXPECT_GT(share, before * 0.95f) << windows;
        before = share;
    }
    EXPECT_LT(before, 0.02f);
}

TEST(line_crowding, is_a_continuous_function_of_the_place)
{
    const hw::Surface ring = hw::build_surface(torus(48, 24));
    const hw::LineCrowding crowding(hw::crowding_lines(ring, 0.2f, nullptr, {}));
    const glm::vec3 from = ring.positions[0], to = ring.positions[200];
    glm::vec4 before = crowding.at(from);
    for (int i = 1; i <= 4000; ++i) {
        const glm::vec4 here = crowding.at(glm::mix(from, to, static_cast<float>(i) / 4000.0f));
        for (int scale = 0; scale < 4; ++scale) EXPECT_NEAR(here[scale], before[scale], 0.15f) << i;
        before = here;
    }
}

TEST(line_crowding, of_a_sphere_thins_its_outline_when_it_is_as_small_as_the_window)
{
    const hw::Surface ball = hw::build_surface(sphere(64, 32));  // of radius 1
    const hw::LineCrowding crowding(hw::crowding_lines(ball, 0.7f, nullptr, {}));
    const glm::vec3 place = ball.positions[ball.faces[700][0]];
    EXPECT_GT(share_at(crowding, place, 0.3f), 0.9f);
    EXPECT_LT(share_at(crowding, place, 4.0f), 0.7f);
}

TEST(line_crowding, is_the_same_where_it_is_asked_for_whether_or_not_it_was_told_where)
{
    for (hw::MeshData mesh : {torus(48, 24), box({-1, -1, -1}, {1, 1, 1})}) {
        for (glm::vec3& p : mesh.positions) p += glm::vec3(3, 1, -2);
        const hw::Surface surface = hw::build_surface(mesh);
        const std::vector<hw::CrowdingLine> lines = hw::crowding_lines(surface, 0.2f, nullptr, {});
        ASSERT_FALSE(lines.empty());
        std::vector<glm::vec3> places;
        for (std::size_t i = 0; i < lines.size(); i += 7) {
            places.push_back(lines[i].ends[0]);
            places.push_back(0.5f * (lines[i].ends[0] + lines[i].ends[1]));
        }
        const hw::LineCrowding anywhere(lines), there(lines, places);
        EXPECT_LT(there.bytes(), anywhere.bytes());
        const std::vector<glm::vec4> expected = anywhere.at(places), found = there.at(places);
        for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(found[i], expected[i]);
    }
}

TEST(line_crowding, does_not_depend_on_the_unit_of_length)
{
    const hw::Surface ring = hw::build_surface(torus(32, 16));
    const hw::LineCrowding one(hw::crowding_lines(ring, 0.2f, nullptr, {}));
    for (const float scale : {1e-5f, 1e4f}) {
        const hw::Surface scaled =
            hw::build_surface(moved(torus(32, 16), glm::scale(glm::mat4(1.0f), glm::vec3(scale))));
        const hw::LineCrowding other(hw::crowding_lines(scaled, 0.2f, nullptr, {}));
        EXPECT_NEAR(other.window() / scale, one.window(), 1e-4f * one.window());
        const glm::vec4 a = one.at(ring.positions[7]), b = other.at(scale * ring.positions[7]);
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 0.05f) << scale;
    }
}

TEST(line_crowding, without_lines_says_that_nothing_is_crowded)
{
    const hw::LineCrowding none({});
    EXPECT_EQ(none.at(glm::vec3(3.0f)), glm::vec4(0.0f));
    EXPECT_GT(none.window(), 0.0f);
}
