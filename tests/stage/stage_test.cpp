#include "hatchway/stage/stage.hpp"
#include "hatchway/gl/headless_context.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/io/compiled/lightmap_file.hpp"
#include "hatchway/io/gltf/import.hpp"
#include "hatchway/stage/level_light.hpp"
#include "hatchway/stage/whole_scene.hpp"
#include "hatchway/world/light/bake.hpp"

namespace {
namespace fs = std::filesystem;

constexpr const char* kLevel = R"({"format": "hatchway-level/1", "scene": "prism.glb",
    "styles": {"drawn": {"plugin": "pen_and_ink", "crease_deg": 60}}, "assign": [{"nodes": "*", "style": "STYLE"}]})";

/// A level in a folder of its own, opened headless.
class stage : public testing::Test {
 protected:
    stage() : folder_(fs::temp_directory_path() / ("hatchway_stage_" + std::to_string(::getpid())))
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        fs::copy_file(fs::path(HATCHWAY_SOURCE_DIR) / "content" / "models" / "prism.glb", folder_ / "prism.glb");
        write_level("photoreal");
        context_ = hw::make_headless_context();
        stage_ = std::make_unique<hw::Stage>(*context_, hw::StageOptions{.file = folder_ / "a.level.json"});
    }
    ~stage() override { fs::remove_all(folder_); }

    void write(const std::string& text) { std::ofstream(folder_ / "a.level.json") << text; }
    void write_level(const std::string& style)
    {
        std::string text = kLevel;
        write(text.replace(text.find("STYLE"), 5, style));
    }
    std::vector<std::uint8_t> picture()
    {
        const hw::CameraPlace camera = hw::whole_scene_camera(stage_->scene(), 1.0);
        stage_->draw(hw::camera_view(camera, {64, 64}, stage_->scene().bounds_world), {.samples = 1});
        return stage_->renderer().read_picture().bytes;
    }
    hw::Reload reload()
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(260));
        return stage_->reload_changed();
    }

    fs::path folder_;
    std::unique_ptr<hw::Context> context_;
    std::unique_ptr<hw::Stage> stage_;
};

hw::AssignRule all_in(const std::string& style)
{
    hw::AssignRule rule;
    rule.style = style;
    return rule;
}

}  // namespace

TEST_F(stage, a_saved_level_shows)
{
    const auto before = picture();
    EXPECT_EQ(reload(), hw::Reload::nothing);
    write_level("drawn");
    EXPECT_EQ(reload(), hw::Reload::looks);
    EXPECT_NE(picture(), before);
    write_level("photoreal");
    reload();
    EXPECT_EQ(picture(), before);
}

TEST_F(stage, a_change_of_a_style_shows_in_those_that_are_like_it)
{
    const auto level = [](const char* colour) {
        return std::string(R"({"format": "hatchway-level/1", "scene": "prism.glb", "styles": {
            "drawn": {"plugin": "pen_and_ink", "paper_colour": ")") +
               colour + R"("},
            "fine": {"like": "drawn", "line_width_px": 1}}, "assign": [{"nodes": "*", "style": "fine"}]})";
    };
    write(level("#ffffff"));
    reload();
    const auto before = picture();
    write(level("#80ffff"));
    EXPECT_EQ(reload(), hw::Reload::looks);
    EXPECT_NE(picture(), before);
}

TEST_F(stage, a_wrong_level_keeps_the_last_good_picture_and_watching_goes_on)
{
    const auto before = picture();
    for (const char* text : {"{", R"({"format": "hatchway-level/1", "scene": "none.glb"})"}) {
        write(text);
        EXPECT_EQ(reload(), hw::Reload::nothing) << text;
        ASSERT_EQ(stage_->messages().size(), 1u) << text;
        EXPECT_NE(stage_->messages()[0].find("a.level.json"), std::string::npos);
        EXPECT_EQ(picture(), before) << text;
    }
    write_level("crayon");
    reload();
    EXPECT_NE(stage_->messages().at(0).find("crayon"), std::string::npos);
    EXPECT_EQ(picture(), before);
    write_level("drawn");
    EXPECT_EQ(reload(), hw::Reload::looks);
    EXPECT_TRUE(stage_->messages().empty());
    EXPECT_NE(picture(), before);
}

TEST_F(stage, a_saved_model_opens_a_new_world)
{
    fs::last_write_time(folder_ / "prism.glb", fs::file_time_type::clock::now());
    EXPECT_EQ(reload(), hw::Reload::world);
}

TEST_F(stage, baked_light_shows_as_soon_as_it_is_written)
{
    const auto before = picture();
    const hw::Scene scene = hw::import_gltf(folder_ / "prism.glb", folder_);
    const hw::LightSources sources = hw::light_sources_of(stage_->level(), scene);
    hw::write_lightmap(hw::lightmap_path(folder_ / "a.level.json"),
                       hw::bake_lightmap(scene, sources, {.luxels_per_m = 1.0, .samples = 4}));
    EXPECT_EQ(reload(), hw::Reload::world);
    EXPECT_NE(picture(), before);
}

TEST(level_light, is_looked_at_from_the_start_all_cameras_and_the_keys_of_paths)
{
    hw::Level level;
    level.start = hw::StartPlace{.position = {1, 0, 0}};
    level.cameras = {{.name = "hall", .eye_world = {2, 0, 0}}};
    level.paths = {{.keys = {{.position = {3, 0, 0}}, {.t_s = 1.0, .position = {4, 0, 0}}}}};
    hw::Scene scene;
    scene.cameras = {{.name = "of the model", .eye_world = {5, 0, 0}}};
    double sum = 0.0;
    for (const glm::dvec3& eye : hw::light_sources_of(level, scene).eyes_world) sum += eye.x;
    EXPECT_EQ(sum, 15.0) << "each once";
}

TEST_F(stage, rules_that_are_tried_out_come_last_and_go_again)
{
    const auto before = picture();
    stage_->set_extra_rules({all_in("drawn")});
    EXPECT_EQ(stage_->looks()[0].style, "drawn");
    EXPECT_NE(picture(), before);
    stage_->set_extra_rules({});
    EXPECT_EQ(picture(), before);
}

TEST_F(stage, a_rule_that_does_not_work_changes_nothing)
{
    const auto before = picture();
    EXPECT_THROW(stage_->set_extra_rules({all_in("crayon")}), hw::Error);
    EXPECT_EQ(picture(), before);
}

TEST_F(stage, an_object_hidden_while_walking_is_as_one_that_the_level_hides)
{
    const auto hidden = [](bool is_hidden) {
        return std::string(R"({"format": "hatchway-level/1", "scene": "prism.glb", "assign": [)") +
               (is_hidden ? R"({"nodes": "*", "visible": false})" : "") + "]}";
    };
    const hw::CameraPlace camera = hw::whole_scene_camera(stage_->scene(), 1.0);
    const auto seen = [&] {
        stage_->draw(hw::camera_view(camera, {64, 64}, stage_->scene().bounds_world), {.samples = 1});
        return stage_->renderer().read_picture().bytes;
    };
    write(hidden(false));
    reload();
    const auto shown = seen();
    ASSERT_NE(stage_->visibility(), nullptr);
    hw::AssignRule rule;
    rule.visible = false;
    stage_->set_extra_rules({rule});
    const auto empty = seen();
    EXPECT_NE(empty, shown);
    EXPECT_EQ(stage_->visibility(), nullptr) << "made while the object was there";
    stage_->set_extra_rules({});
    EXPECT_EQ(seen(), shown);
    EXPECT_NE(stage_->visibility(), nullptr);
    write(hidden(true));
    EXPECT_EQ(reload(), hw::Reload::looks);
    EXPECT_EQ(seen(), empty);

    stage_ = std::make_unique<hw::Stage>(*context_, hw::StageOptions{.file = folder_ / "a.level.json"});
    EXPECT_NE(stage_->visibility(), nullptr) << "made without the object";
    EXPECT_EQ(seen(), empty);
    write(hidden(false));
    reload();
    EXPECT_EQ(seen(), shown) << "what was hidden when the level was opened can be shown";
}

TEST_F(stage, a_rule_that_hides_and_does_not_work_hides_nothing)
{
    const auto before = picture();
    hw::AssignRule rule = all_in("crayon");
    rule.visible = false;
    EXPECT_THROW(stage_->set_extra_rules({rule}), hw::Error);
    EXPECT_TRUE(stage_->scene().hidden.empty());
    EXPECT_EQ(picture(), before);
}

TEST_F(stage, names_the_styles_that_there_are)
{
    const std::vector<std::string> names = stage_->style_names();
    EXPECT_EQ(names.front(), "drawn");
    EXPECT_NE(std::find(names.begin(), names.end(), "pen_and_ink"), names.end());
}

TEST_F(stage, a_wrong_map_is_named_by_its_place_although_nothing_uses_it)
{
    const std::pair<const char*, const char*> cases[] = {
        {R"("assign": [{"nodes": "none", "maps": {"hatch": "zzz"}}])", "/assign/0/maps/hatch: there is no map"},
        {R"("styles": {"a": {"plugin": "pen_and_ink", "tone": "shaded", "hatch": "zzz"}})",
         "/styles/a/hatch: there is no map"}};
    for (const auto& [keys, expected] : cases) {
        write(R"({"format": "hatchway-level/1", "scene": "prism.glb", )" + std::string(keys) + "}");
        reload();
        ASSERT_EQ(stage_->messages().size(), 1u) << keys;
        EXPECT_NE(stage_->messages()[0].find(expected), std::string::npos) << stage_->messages()[0];
    }
}
