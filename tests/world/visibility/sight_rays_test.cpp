// Rays by brute force in double against the rows: shares no source with the code that makes them.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <random>

#include "tests/world/scene_builder.hpp"

namespace hw {
namespace {

using test::compile;
using test::Compiled;
using test::SceneBuilder;

struct RayTriangle {
    glm::dvec3 a, b, c;
    ObjectId object;
    bool is_double_sided;
};

std::vector<RayTriangle> triangles_of(const Scene& scene)
{
    std::vector<RayTriangle> result;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const MeshData& mesh = scene.meshes[static_cast<std::size_t>(scene.objects[id].mesh)];
        const bool both = scene.materials[static_cast<std::size_t>(scene.objects[id].material)].is_double_sided;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            result.push_back({glm::dvec3(mesh.positions[mesh.indices[i]]),
                              glm::dvec3(mesh.positions[mesh.indices[i + 1]]),
                              glm::dvec3(mesh.positions[mesh.indices[i + 2]]), id, both});
        }
    }
    return result;
}

/// The first object that the ray hits from a drawn side, if it does so clearly inside a triangle.
std::optional<ObjectId> first_hit(const std::vector<RayTriangle>& triangles, const glm::dvec3& from,
                                  const glm::dvec3& way)
{
    constexpr double kClear = 1e-4;  // a ray nearer to an edge proves nothing
    double nearest = 1e300;
    std::optional<ObjectId> result;
    bool is_clear = true;
    for (const RayTriangle& t : triangles) {
        const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
        const double slope = glm::dot(normal, way);
        if (slope >= 0.0 && !t.is_double_sided) continue;
        if (slope == 0.0) continue;
        const double along = glm::dot(normal, t.a - from) / slope;
        if (along <= 0.0 || along >= nearest) continue;
        const glm::dvec3 p = from + along * way;
        const double size = glm::dot(normal, normal);
        const double u = glm::dot(glm::cross(t.b - t.a, p - t.a), normal) / size;
        const double v = glm::dot(glm::cross(t.c - t.b, p - t.b), normal) / size;
        const double w = glm::dot(glm::cross(t.a - t.c, p - t.c), normal) / size;
        const double inside = std::min({u, v, w});
        if (inside < -kClear) continue;
        nearest = along;
        result = t.object;
        is_clear = inside > kClear;
    }
    return is_clear ? result : std::nullopt;
}

void expect_nothing_hidden(Scene& scene, int rays, std::uint64_t seed)
{
    const Compiled compiled = compile(scene);
    const std::vector<RayTriangle> triangles = triangles_of(scene);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> normal;
    int met = 0;
    for (int i = 0; i < rays; ++i) {
        const Box& box = scene.bounds_world;
        const glm::dvec3 eye = box.min + box.size() * glm::dvec3(share(engine), share(engine), share(engine));
        const glm::dvec3 way(normal(engine), normal(engine), normal(engine));
        const auto object = first_hit(triangles, eye, way);
        if (!object) continue;
        ++met;
        ASSERT_TRUE(compiled.sees(eye, *object)) << "eye " << eye.x << ' ' << eye.y << ' ' << eye.z << " way " << way.x
                                                 << ' ' << way.y << ' ' << way.z << " object " << *object;
    }
    EXPECT_GT(met, rays / 8);
}

TEST(sight_rays, a_maze_hides_nothing_that_a_ray_meets)
{
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        SceneBuilder builder;
        std::mt19937_64 engine(seed);
        builder.box({0, 0, 0}, {12, 3, 12}, true);
        for (int i = 1; i < 6; ++i) {
            for (int k = 0; k < 6; ++k) {  // walls between cells, a third of them with a gap
                const double at = 2.0 * i, from = 2.0 * k, gap = engine() % 3 == 0 ? 0.7 : 0.0;
                builder.box({at - 0.1, 0, from}, {at + 0.1, 3, from + 2.0 - gap}, false);
                builder.box({from + gap, 0, at - 0.1}, {from + 2.0, 3, at + 0.1}, false);
            }
        }
        expect_nothing_hidden(builder.scene(), 4000, seed);
    }
}

TEST(sight_rays, slits_hide_nothing_that_a_ray_meets)
{
    SceneBuilder builder;
    builder.box({-10, -5, -5}, {10, 5, 5}, true);
    int wall = 0;
    for (const double width : {0.5, 0.1, 0.05, 0.01}) {
        const double x = -6.0 + 4.0 * wall++;
        builder.box({x - 0.1, -5, -5}, {x + 0.1, 5, -width}, false);
        builder.box({x - 0.1, -5, width}, {x + 0.1, 5, 5}, false);
    }
    expect_nothing_hidden(builder.scene(), 20000, 4);
}

TEST(sight_rays, a_tangle_of_one_and_two_sided_quads_hides_nothing_that_a_ray_meets)
{
    for (const std::uint64_t seed : {5u, 6u, 7u, 8u}) {
        SceneBuilder builder;
        std::mt19937_64 engine(seed);
        std::uniform_real_distribution<double> place(-4.0, 4.0);
        for (int i = 0; i < 25; ++i) {
            const glm::dvec3 corner(place(engine), place(engine), place(engine));
            const glm::dvec3 u(place(engine), place(engine), place(engine));
            const glm::dvec3 v(place(engine), place(engine), place(engine));
            builder.quad({{corner, corner + u, corner + u + v, corner + v}}, i % 2);
        }
        expect_nothing_hidden(builder.scene(), 8000, seed);
    }
}

TEST(sight_rays, turned_boxes_hide_nothing_that_a_ray_meets)
{
    SceneBuilder builder;
    std::mt19937_64 engine(9);
    std::uniform_real_distribution<double> place(-6.0, 6.0);
    builder.box({-8, -8, -8}, {8, 8, 8}, true);
    for (int i = 0; i < 12; ++i) {
        const double angle = place(engine);
        const glm::dvec3 at(place(engine), 0.3 * place(engine), place(engine));
        const glm::dvec3 u(std::cos(angle) * 3.0, 0, std::sin(angle) * 3.0),
            w(-std::sin(angle) * 0.2, 0, std::cos(angle) * 0.2);
        const glm::dvec3 v(0, 5, 0);
        builder.quad({{at, at + v, at + v + u, at + u}});
        builder.quad({{at + w, at + w + u, at + w + v + u, at + w + v}});
        builder.quad({{at, at + w, at + w + v, at + v}});
        builder.quad({{at + u, at + u + v, at + u + w + v, at + u + w}});
    }
    expect_nothing_hidden(builder.scene(), 20000, 9);
}

}  // namespace
}  // namespace hw
