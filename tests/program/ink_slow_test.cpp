// How much ink pen and ink puts on paper: six cameras in each scene, three that see all of it and three inside. Less
// than 2 % is a drawing that lost its lines, more than 25 % one that turned black.
#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/stage/stage.hpp"
#include "measure/lines/line_error.hpp"
#include "tests/program/run_program.hpp"
#include "tests/shared_data.hpp"

namespace hw::test {
namespace {

constexpr double kLeastInk = 0.02;
constexpr double kMostInk = 0.25;
constexpr glm::ivec2 kSize(1280, 720);

struct Place {
    glm::dvec3 eye;
    glm::dvec3 target;
};

struct InkScene {
    const char* file;
    std::array<Place, 6> cameras;
};

const std::array<InkScene, 4> kScenes{{{"city_kaykit_9x9.glb",
                                        {{{{20, 8, 22}, {8, 0, 8}},
                                          {{-3, 9, -2}, {8, 0, 8}},
                                          {{8, 15, 19}, {8, 0, 9}},
                                          {{6, 0.25, 6}, {0, 0.6, 0}},
                                          {{8, 0.25, 8}, {16, 0.8, 8}},
                                          {{12, 0.25, 12}, {4, 0.8, 0}}}}},
                                       {"dungeon_kaykit_9x7.glb",
                                        {{{{38, 16, 36}, {16, 0, 12}},
                                          {{-12, 22, -14}, {16, 0, 12}},
                                          {{16, 40, 36}, {16, 0, 12}},
                                          {{2, 1.7, 2}, {9, 1.7, 9}},
                                          {{14, 1.7, 14}, {22, 1.5, 9}},
                                          {{30, 1.7, 22}, {20, 1.7, 20}}}}},
                                       {"japanese_temple.glb",
                                        {{{{30, 24, 44}, {0, 16, 0}},
                                          {{-44, 30, -20}, {0, 16, 0}},
                                          {{4, 46, 26}, {0, 16, 0}},
                                          {{3, 1.7, 17}, {0, 9, 0}},
                                          {{8.5, 5.2, 8}, {-4, 5.5, 8}},
                                          {{-8.6, 4.6, -8}, {-3, 6, 8}}}}},
                                       {"oa_oa_dm1.glb",
                                        {{{{50, 30, 0}, {7, 0, -34}},
                                          {{-30, 30, -66}, {7, 0, -34}},
                                          {{7, 52, -14}, {7, 0, -33}},
                                          {{0, 0, -34}, {14, 0, -34}},
                                          {{-14, -2, -46}, {4, -2, -34}},
                                          {{26, 0, -24}, {8, -1, -36}}}}}}};

}  // namespace

TEST(ink_slow, covers_between_two_and_twenty_five_percent_at_six_cameras_of_every_scene)
{
    HATCHWAY_NEEDS_DATA(std::filesystem::exists(kSharedData / "scenes"), "scenes beside the project");
    for (const InkScene& scene : kScenes) {
        const auto context = make_headless_context();
        StageOptions options;
        options.file = kSharedData / "scenes" / scene.file;
        options.style_overrides = {"*=pen_and_ink"};
        options.visibility_use = VisibilityUse::none;
        Stage stage(*context, options);
        for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
            const CameraPlace camera{scene.cameras[i].eye, scene.cameras[i].target, 60.0};
            stage.draw(camera_view(camera, kSize, stage.scene().bounds_world), {.samples = 4});
            const double share = ink_share(ink_of(stage.renderer().read_picture()));
            std::cout << scene.file << " camera " << i << ": " << 100.0 * share << " % ink\n";
            EXPECT_GE(share, kLeastInk) << scene.file << " camera " << i;
            EXPECT_LE(share, kMostInk) << scene.file << " camera " << i;
        }
    }
}

}  // namespace hw::test
