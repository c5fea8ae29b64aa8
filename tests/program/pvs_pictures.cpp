#include "tests/program/pvs_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/stage/stage.hpp"
#include "hatchway/stage/whole_scene.hpp"
#include "measure/picture_difference.hpp"
#include "tests/program/run_program.hpp"
#include "tests/shared_data.hpp"

namespace hw::test {
namespace fs = std::filesystem;
namespace {

constexpr glm::ivec2 kSize(320, 180);

glm::dvec3 random_place(const Box& box, std::mt19937& random)
{
    std::uniform_real_distribution<double> share(0.0, 1.0);
    return box.min + glm::dvec3(share(random), share(random), share(random)) * box.size();
}

int count_unlike(const Pixels& a, const Pixels& b)
{
    return static_cast<int>(std::lround(measure::unlike_share(a, b) * a.width * a.height));
}

}  // namespace

PvsDifference compare_with_pvs(const fs::path& level, const std::string& style, int eyes,
                               const std::optional<ImageKey>& shown)
{
    const auto context = make_headless_context();
    StageOptions options;
    options.file = level;
    options.style_overrides = {"*=" + style};
    Stage stage(*context, options);

    PvsDifference result{.eyes = eyes};
    std::mt19937 random(20011);
    const Box& bounds = stage.scene().bounds_world;
    stage.draw(camera_view(whole_scene_camera(stage.scene(), 1.0), kSize, bounds), {});  // shadow maps are made once
    const Pixels paper{kSize.x, kSize.y, 3, std::vector<std::uint8_t>(3 * kSize.x * kSize.y, 255)};
    double drawn = 0.0;
    double all = 0.0;
    for (int i = 0; i < eyes; ++i) {
        const CameraPlace camera{random_place(bounds, random), random_place(bounds, random), 60.0};
        const View view = camera_view(camera, kSize, bounds);
        FrameOptions options_of_frame{.samples = 1, .use_pvs = true};
        options_of_frame.shown_image = shown;
        const FrameStats with = stage.draw(view, options_of_frame);
        const Pixels picture = stage.renderer().read_picture();
        options_of_frame.use_pvs = false;
        const FrameStats without = stage.draw(view, options_of_frame);
        const int unlike = count_unlike(picture, stage.renderer().read_picture());
        result.unlike_pictures += unlike > 0;
        result.unlike_pixels += unlike;
        result.inked_pixels += count_unlike(picture, paper);
        drawn += static_cast<double>(with.triangles);
        all += static_cast<double>(without.triangles);
        if (unlike > result.most_unlike_pixels) {
            result.most_unlike_pixels = unlike;
            result.worst_view =
                fmt::format("--eye {},{},{} --target {},{},{}", camera.eye_world.x, camera.eye_world.y,
                            camera.eye_world.z, camera.target_world.x, camera.target_world.y, camera.target_world.z);
        }
    }
    result.drawn_share = drawn / std::max(all, 1.0);
    return result;
}

std::vector<fs::path> pvs_scenes()
{
    std::vector<fs::path> scenes{kContent / "levels" / "hall.level.json"};
    EXPECT_TRUE(fs::exists(kSharedData / "scenes") || !is_set("HATCHWAY_REQUIRE_DATA"));
    if (fs::exists(kSharedData / "scenes"))
        for (const auto& entry : fs::directory_iterator(kSharedData / "scenes"))
            if (entry.path().extension() == ".glb") scenes.push_back(entry.path());
    std::sort(scenes.begin() + 1, scenes.end());
    return scenes;
}

}  // namespace hw::test
