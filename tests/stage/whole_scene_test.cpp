#include "hatchway/stage/whole_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "hatchway/world/camera_path.hpp"

namespace {

constexpr glm::ivec2 kSize(1500, 1000);

/// A scene of one object whose vertices are these.
hw::Scene scene_of(const std::vector<glm::vec3>& positions)
{
    hw::Scene scene;
    scene.nodes.emplace_back();
    scene.materials.emplace_back();
    scene.meshes.emplace_back();
    scene.meshes[0].positions = positions;
    scene.objects.push_back({.node = 0, .mesh = 0, .material = 0});
    for (const glm::vec3& position : positions) scene.bounds_world.add(glm::dvec3(position));
    scene.objects[0].bounds_world = scene.bounds_world;
    return scene;
}

hw::Scene box_scene(const glm::vec3& size)
{
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(size * glm::vec3((i & 1) ? 1.0f : 0.0f, (i & 2) ? 1.0f : 0.0f, (i & 4) ? 1.0f : 0.0f));
    return scene_of(corners);
}

/// How far the scene reaches in the picture: -1 to 1 in each direction.
struct Reach {
    glm::vec2 min{10.0f};
    glm::vec2 max{-10.0f};
};

Reach reach_of(const hw::Scene& scene, const hw::CameraPlace& camera)
{
    const hw::View view = hw::camera_view(camera, kSize, scene.bounds_world);
    Reach reach;
    for (const glm::vec3& position : scene.meshes[0].positions) {
        const glm::vec4 clip = view.clip_from_view * view.view_from_world * glm::vec4(position, 1.0f);
        EXPECT_LT(std::abs(clip.z), clip.w);
        reach.min = glm::min(reach.min, glm::vec2(clip) / clip.w);
        reach.max = glm::max(reach.max, glm::vec2(clip) / clip.w);
    }
    return reach;
}

}  // namespace

TEST(whole_scene, fills_the_picture_and_stands_in_its_middle)
{
    for (const glm::vec3& size : {glm::vec3(1), glm::vec3(100, 2, 60), glm::vec3(1, 50, 1), glm::vec3(1e-5f)}) {
        const hw::Scene scene = box_scene(size);
        const Reach reach = reach_of(scene, hw::whole_scene_camera(scene, 1.5));
        const float widest = std::max({reach.max.x, reach.max.y, -reach.min.x, -reach.min.y});
        EXPECT_NEAR(widest, 1.0f / 1.06f, 0.002f) << size.x;
        EXPECT_TRUE(std::abs(reach.min.x + reach.max.x) < 0.2f && std::abs(reach.min.y + reach.max.y) < 0.2f) << size.x;
    }
}

TEST(whole_scene, a_point_and_an_empty_scene_have_cameras_too)
{
    for (const hw::Scene& scene : {scene_of({{5, 5, 5}}), hw::Scene()}) {
        const hw::CameraPlace camera = hw::whole_scene_camera(scene, 1.5);
        EXPECT_NEAR(glm::distance(camera.eye_world, camera.target_world), 1.0, 1e-9);
    }
    EXPECT_EQ(hw::turntable(hw::Scene(), 1.0).keys.size(), 25u);
}

TEST(turntable, ends_where_it_began)
{
    const hw::CameraPath path = hw::turntable(box_scene({30, 4, 10}), 1.5);
    EXPECT_EQ(path.keys.front().position, path.keys.back().position);
    EXPECT_EQ(hw::path_frame_count(path), 251);
}

TEST(turntable, keeps_the_whole_scene_in_every_frame)
{
    const hw::Scene scene = box_scene({30, 4, 10});
    const hw::CameraPath path = hw::turntable(scene, 1.5);
    for (double t_s = 0.0; t_s < 10.0; t_s += 0.4) {
        const hw::Camera camera = hw::camera_at(path, t_s);
        const Reach reach = reach_of(scene, {camera.eye_world, camera.target_world, camera.fov_deg});
        EXPECT_GT(std::min(reach.min.x, reach.min.y), -1.0f) << t_s;
        EXPECT_LT(std::max(reach.max.x, reach.max.y), 1.0f) << t_s;
    }
}
