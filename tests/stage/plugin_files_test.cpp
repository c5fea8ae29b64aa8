// The files of a plugin from outside and of a level that uses it: shaders that change, images that the level states.
#include <gmock/gmock.h>

#include <thread>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/stage/stage.hpp"
#include "hatchway/stage/whole_scene.hpp"
#include "tests/temporary_folder.hpp"

namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

/// A project with a level in the style on_paper of the manual, whose paper is an image that its parameters name, and
/// the plugin in a folder beside the project.
class plugin_files : public testing::Test {
 protected:
    plugin_files()
    {
        hw::set_log_level(hw::LogLevel::off);
        folder_.write("project/hatchway.project", "");
        fs::create_directories(folder_.path() / "project/levels");
        fs::create_directories(folder_.path() / "plugins");
        fs::copy_file(fs::path(HATCHWAY_SOURCE_DIR) / "content/models/prism.glb", folder_.path() / "project/prism.glb");
        fs::copy_file(HATCHWAY_BUILD_DIR "/tests/stage/on_paper.so", folder_.path() / "plugins/on_paper.so");
        fs::copy(fs::path(HATCHWAY_SOURCE_DIR) / "docs/examples/on_paper", folder_.path() / "plugins/on_paper");
        for (const auto& [name, gray] : {std::pair("project/white.png", 255), {"project/black.png", 0}, {"out.png", 0}})
            hw::write_png(folder_.path() / name, {2, 2, 1, std::vector<std::uint8_t>(4, std::uint8_t(gray))});
    }
    ~plugin_files() override { stage_.reset(); }

    /// `paper` is JSON.
    fs::path write_level(const std::string& paper)
    {
        return folder_.write("project/levels/a.level.json",
                             R"({"format": "hatchway-level/1", "scene": "../prism.glb",
                                 "styles": {"printed": {"plugin": "on_paper", "grain": 1, "paper": )" +
                                 paper + R"(}}, "assign": [{"style": "printed"}]})");
    }
    void open(const std::string& paper, bool has_plugin = true)
    {
        hw::StageOptions options{.file = write_level(paper)};
        if (has_plugin) options.plugin_dirs = {folder_.path() / "plugins"};
        stage_ = std::make_unique<hw::Stage>(*context_, std::move(options));
    }
    std::string refusal(const std::string& paper, bool has_plugin = true)
    {
        try {
            open(paper, has_plugin);
        } catch (const hw::Error& error) {
            return error.what();
        }
        return "";
    }
    hw::Reload reload()
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(260));
        return stage_->reload_changed();
    }
    /// Pixels of the picture that are black.
    int black_pixels()
    {
        const hw::CameraPlace camera = hw::whole_scene_camera(stage_->scene(), 1.0);
        stage_->draw(hw::camera_view(camera, {64, 64}, stage_->scene().bounds_world), {.samples = 1});
        const hw::Pixels picture = stage_->renderer().read_picture();
        int count = 0;
        for (std::size_t i = 0; i < picture.bytes.size(); i += 3)
            count += picture.bytes[i] + picture.bytes[i + 1] + picture.bytes[i + 2] == 0 ? 1 : 0;
        return count;
    }

    TemporaryFolder folder_;
    std::unique_ptr<hw::Context> context_ = hw::make_headless_context();
    std::unique_ptr<hw::Stage> stage_;
};

}  // namespace

TEST_F(plugin_files, an_image_that_a_level_states_is_a_texture_of_the_style)
{
    open(R"("../white.png")");
    EXPECT_EQ(black_pixels(), 0);
    write_level(R"("../black.png")");
    EXPECT_EQ(reload(), hw::Reload::looks);
    EXPECT_GT(black_pixels(), 200);
    write_level(R"("paper.png")");
    EXPECT_EQ(reload(), hw::Reload::nothing) << "the style's own files are not the level's";
    EXPECT_THAT(stage_->messages().at(0), HasSubstr("/styles/printed/paper: there is no file \"paper.png\""));
    EXPECT_GT(black_pixels(), 200) << "the last good ones stay";
}

TEST_F(plugin_files, an_image_that_a_level_states_wrongly_is_refused_by_its_place)
{
    fs::create_symlink(folder_.path() / "out.png", folder_.path() / "project/levels/link.png");
    const std::string outside = (folder_.path() / "out.png").string();
    for (const std::string& wrong :
         {std::string("\"../none.png\""), std::string("\"../../out.png\""), '"' + outside + '"',
          std::string("\"link.png\""), std::string("\"..\""), std::string("12")}) {
        const std::string message = refusal(wrong);
        EXPECT_THAT(message, HasSubstr("a.level.json: /styles/printed/paper: ")) << wrong;
    }
    EXPECT_THAT(refusal("12"), HasSubstr("expected an image file (.png, .jpg), relative to the level file"));
    folder_.write("project/broken.png", "no image");
    EXPECT_THAT(refusal(R"("../broken.png")"), HasSubstr("broken.png"));
}

TEST_F(plugin_files, a_saved_shader_shows_and_one_that_does_not_compile_is_told_with_its_line)
{
    open(R"("../white.png")");
    const auto save = [&](const std::string& colour) {
        folder_.write("plugins/on_paper/on_paper.frag",
                      "#include \"surface.glsl\"\nvoid main()\n{\n    hw_surface();\n"
                      "    hw_output(vec3(" +
                          colour + "), 1.0);\n}\n");
    };
    save("0.0");
    EXPECT_EQ(reload(), hw::Reload::looks);
    EXPECT_GT(black_pixels(), 200);
    save("oops");
    reload();
    ASSERT_FALSE(stage_->messages().empty());
    EXPECT_THAT(stage_->messages()[0], HasSubstr("on_paper.frag:5"));
    EXPECT_GT(black_pixels(), 200) << "the last good picture stays";
    save("1.0");
    reload();
    EXPECT_THAT(stage_->messages(), testing::IsEmpty());
    EXPECT_EQ(black_pixels(), 0);
}

TEST_F(plugin_files, a_library_that_lies_beside_a_level_is_not_loaded)
{
    for (const char* place : {"project/levels", "project", "project/levels/plugins", "project/plugins"}) {
        fs::create_directories(folder_.path() / place);
        fs::copy_file(folder_.path() / "plugins/on_paper.so", folder_.path() / place / "on_paper.so");
    }
    EXPECT_THAT(refusal(R"("../white.png")", false),
                HasSubstr("/styles/printed/plugin: there is no style plugin \"on_paper\""));
}
