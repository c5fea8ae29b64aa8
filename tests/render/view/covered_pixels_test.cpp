#include "hatchway/render/view/covered_pixels.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

using namespace hw;

namespace {

constexpr glm::ivec2 kSize{640, 480};

glm::mat4 clip_from(const glm::vec3& eye, const glm::vec3& target)
{
    return glm::perspective(1.0f, 640.0f / 480.0f, 0.1f, 1000.0f) * glm::lookAt(eye, target, glm::vec3(0, 1, 0));
}

MeshData triangles(const std::vector<glm::vec3>& corners)
{
    MeshData mesh;
    mesh.positions = corners;
    for (std::uint32_t i = 0; i < corners.size(); ++i) mesh.indices.push_back(i);
    return mesh;
}

double covered(const MeshData& mesh, const glm::mat4& clip, float facing = 0.0f)
{
    const IndexRange all{0, static_cast<std::uint32_t>(mesh.indices.size())};
    return covered_pixels(mesh, {&all, 1}, clip, facing, kSize);
}

}  // namespace

TEST(covered_pixels, of_a_triangle_are_its_area)
{
    const MeshData mesh = triangles({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    const glm::mat4 clip = clip_from({0, 0, 8}, {0, 0, 0});
    const double px_per_m = 240.0 / std::tan(0.5) / 8.0;
    EXPECT_NEAR(covered(mesh, clip), 2.0 * px_per_m * px_per_m, 1.0);
    EXPECT_EQ(covered(mesh, clip, 1.0f), covered(mesh, clip));
    EXPECT_EQ(covered(mesh, clip, -1.0f), 0.0);
}

// Of thousands of faces around an eye hundreds reach behind it, far beside the picture.
TEST(covered_pixels, what_reaches_behind_the_eye_beside_the_picture_covers_none)
{
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 1000; ++i)
        for (const float x : {-3.0f, 3.0f}) {
            const float y = 0.01f * static_cast<float>(i) - 5.0f;
            corners.insert(corners.end(), {{x, y, -0.5f}, {x, y + 0.01f, 0.5f}, {x, y, 0.5f}});
        }
    EXPECT_LT(covered(triangles(corners), clip_from({0, 0, 0}, {0, 0, -1})), 1.0);
    const MeshData floor = triangles({{-50, -1, 50}, {50, -1, 50}, {0, -1, -50}});
    const double of_floor = covered(floor, clip_from({0, 0, 0}, {0, 0, -1}));
    EXPECT_GT(of_floor, 0.2 * 640 * 480);
    EXPECT_LE(of_floor, 0.55 * 640 * 480);
}

TEST(covered_pixels, are_never_more_than_area_and_bounds_allow)
{
    std::mt19937 random(5);
    const auto number = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() / 4294967296.0);
    };
    int tried = 0;
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 30; ++i) corners.emplace_back(number(-2, 2), number(-2, 2), number(-2, 2));
        const MeshData mesh = triangles(corners);
        Box bounds;
        double area = 0.0;
        for (const glm::vec3& p : corners) bounds.add(glm::dvec3(p));
        for (std::size_t i = 0; i < corners.size(); i += 3)
            area += 0.5 * glm::length(glm::cross(glm::dvec3(corners[i + 1] - corners[i]),
                                                 glm::dvec3(corners[i + 2] - corners[i])));
        const glm::mat4 clip = clip_from({number(-6, 6), number(-6, 6), number(3, 9)}, {number(-3, 3), 0, 0});
        const double most = most_covered_pixels(area, bounds, clip, kSize);
        if (std::isinf(most)) continue;
        ++tried;
        EXPECT_LE(covered(mesh, clip), most);
    }
    EXPECT_GT(tried, 100);
}
