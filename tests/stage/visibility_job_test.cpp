#include "hatchway/stage/visibility_job.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/compiled/write.hpp"
#include "hatchway/stage/stage.hpp"
#include "hatchway/stage/whole_scene.hpp"

namespace {
namespace fs = std::filesystem;

const fs::path kContent = fs::path(HATCHWAY_SOURCE_DIR) / "content";

/// Asks the stage until it has what it compiles. A job of the lowest priority has no time of its own on a busy machine.
void wait_for_visibility(hw::Stage& stage)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(10);
    while (stage.visibility() == nullptr && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        stage.reload_changed();
    }
}

std::size_t vertex_count(const hw::Scene& scene)
{
    std::size_t count = 0;
    for (const hw::MeshData& mesh : scene.meshes) count += mesh.positions.size();
    return count;
}

}  // namespace

TEST(visibility_job, is_taken_over_when_it_is_done_and_changes_no_pixel)
{
    const auto context = hw::make_headless_context();
    hw::Stage stage(*context, {.file = kContent / "models" / "hall.glb",
                               .visibility_use = hw::VisibilityUse::in_background,
                               .visibility = {.max_structure_polygons = 400, .max_cells = 40, .flow_seconds = 0.1}});
    const hw::View view =
        hw::camera_view({.eye_world = {0, 1.7, 9.6}, .target_world = {0, 3, -9}}, {96, 64}, stage.scene().bounds_world);
    EXPECT_EQ(stage.visibility(), nullptr);
    EXPECT_NE(stage.activity(), "");
    const hw::FrameStats before = stage.draw(view, {.samples = 1});
    const auto without = stage.renderer().read_picture().bytes;
    EXPECT_EQ(before.leaves_total, 0);

    wait_for_visibility(stage);
    ASSERT_NE(stage.visibility(), nullptr);
    EXPECT_EQ(stage.activity(), "");
    EXPECT_GT(stage.draw(view, {.samples = 1}).leaves_visible, 0);
    EXPECT_EQ(stage.renderer().read_picture().bytes, without);
}

TEST(visibility_job, ends_with_its_stage)
{
#ifdef __SANITIZE_ADDRESS__
    constexpr std::chrono::seconds kLongest(300);
#else
    constexpr std::chrono::seconds kLongest(30);
#endif
    const auto start = std::chrono::steady_clock::now();
    {
        const auto context = hw::make_headless_context();
        const hw::Stage stage(*context, {.file = kContent / "models" / "hall.glb",
                                         .visibility_use = hw::VisibilityUse::in_background,
                                         .visibility = {.flow_seconds = 0}});
        EXPECT_NE(stage.activity(), "");
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, kLongest);
}

// A lightmap copies vertices and turns indices before a late compiler sees them.
TEST(visibility_job, compiles_the_same_bytes_beside_a_lightmap)
{
    const hw::Level level = hw::read_level_with(kContent / "levels" / "hall.level.json", {});
    const auto plain = hw::open_world(level), lit = hw::open_world(level, hw::BakedLight::if_there);
    ASSERT_TRUE(lit->lightmap.has_value());
    ASSERT_GT(vertex_count(lit->scene), vertex_count(plain->scene));
    const hw::VisibilityOptions options{
        .max_structure_polygons = 400, .max_detail_polygons = 400, .max_cells = 40, .flow_seconds = 0.1};
    hw::CompiledLevel a = hw::compile_world(level, *plain, options), b = hw::compile_world(level, *lit, options);
    EXPECT_EQ(a.key, b.key);
    a.visibility.stats.seconds = b.visibility.stats.seconds = 0.0;
    EXPECT_EQ(hw::compiled_level_bytes(a, plain->chunks), hw::compiled_level_bytes(b, lit->chunks));
}
