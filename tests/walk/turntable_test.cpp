#include "walk/turntable.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "render/camera_view.hpp"
#include "world/camera_path.hpp"

namespace {

hw::Box long_hall()
{
    hw::Box box;
    box.add(glm::dvec3(0, 0, 0));
    box.add(glm::dvec3(30, 4, 10));
    return box;
}

}  // namespace

TEST(turntable, ends_where_it_began)
{
    const hw::CameraPath path = hw::turntable(long_hall(), 1.5);
    EXPECT_EQ(path.keys.front().position, path.keys.back().position);
    EXPECT_EQ(hw::path_frame_count(path), 251);
}

TEST(turntable, keeps_the_whole_scene_in_every_frame)
{
    const hw::Box box = long_hall();
    const hw::CameraPath path = hw::turntable(box, 1.5);
    for (double t_s = 0.0; t_s < 10.0; t_s += 0.4) {
        const hw::Camera camera = hw::camera_at(path, t_s);
        const hw::View view =
            hw::camera_view({camera.eye_world, camera.target_world, camera.fov_deg}, {1500, 1000}, box);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec4 p((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                              (corner & 4) ? box.max.z : box.min.z, 1.0f);
            const glm::vec4 clip = view.clip_from_view * view.view_from_world * p;
            EXPECT_LT(std::abs(clip.x), clip.w) << t_s;
            EXPECT_LT(std::abs(clip.y), clip.w) << t_s;
        }
    }
}

TEST(turntable, an_empty_scene_has_one_too) { EXPECT_EQ(hw::turntable({}, 1.0).keys.size(), 25u); }
