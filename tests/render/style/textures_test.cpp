// What docs/write_a_style.md promises of textures of a style's own.
#include <gmock/gmock.h>

#include <fstream>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;

class textures : public testing::Test {
 protected:
    textures() { folder_.write("own.png", "read by the test"); }
    ~textures() override { EXPECT_THAT(context_->take_errors(), testing::IsEmpty()); }

    /// Whether a condition on the texture `own` holds.
    bool holds(const Image& texture, const std::string& condition)
    {
        ShaderFolder shaders(renderer_);
        const Program judging = shaders.surface(
            "#include \"surface.glsl\"\nuniform sampler2D own;\n"
            "void main() { hw_surface(); hw_output(" +
            condition + " ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), 1.0); }\n");
        Scene scene;
        add_object(scene, box_mesh(glm::vec3(1.0f)), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
        ScriptedStyle style;
        style.draws_surfaces = [&](Pass& pass, Items items) {
            pass.surfaces(judging, Uniforms().set("own", texture), items);
        };
        renderer_.load({.scene = &scene, .styles = {{"only", &style}}, .objects = {{.style = 0}}});
        renderer_.draw(camera_view({{0, 0, 4}, {0, 0, 0}, 60.0}, {64, 48}, scene.bounds_world), {.samples = 1});
        return renderer_.read_picture().at(32, 24)[1] == 255;
    }
    Image own() { return renderer_.program_cache(folder_.path()).texture("own.png"); }

    TemporaryFolder folder_;
    Pixels pixels_;
    std::vector<fs::path> read_;
    std::unique_ptr<Context> context_ = make_headless_context();
    Renderer renderer_{*context_, [this](const fs::path& file) {
                           read_.push_back(file);
                           return pixels_;
                       }};
};

TEST_F(textures, of_gray_are_linear_and_in_the_red_channel)
{
    pixels_ = {.width = 1, .height = 1, .channels = 1, .bytes = {128}};
    const Image texture = own();
    EXPECT_EQ(texture.format, PixelFormat::r8);
    EXPECT_TRUE(holds(texture, "distance(texture(own, vec2(0.5)), vec4(0.502, 0.0, 0.0, 1.0)) < 0.004"));
}

TEST_F(textures, of_colour_are_srgb)
{
    pixels_ = {.width = 1, .height = 1, .channels = 3, .bytes = {188, 255, 0}};
    EXPECT_TRUE(holds(own(), "distance(texture(own, vec2(0.5)), vec4(0.503, 1.0, 0.0, 1.0)) < 0.01"));
    pixels_ = {.width = 1, .height = 1, .channels = 4, .bytes = {188, 255, 0, 51}};
    folder_.write("other.png", "read by the test");
    EXPECT_TRUE(holds(renderer_.program_cache(folder_.path()).texture("other.png"),
                      "abs(texture(own, vec2(0.5)).a - 0.2) < 0.004"))
        << "opacity is not";
}

TEST_F(textures, repeat_and_have_all_levels_of_detail)
{
    pixels_ = {.width = 4, .height = 1, .channels = 1, .bytes = {0, 255, 255, 255}};
    const Image texture = own();
    EXPECT_EQ(texture.size_px, glm::ivec2(4, 1));
    EXPECT_TRUE(holds(texture, "textureLod(own, vec2(0.125, 0.5), 0.0).r == 0.0"));
    EXPECT_TRUE(holds(texture, "textureLod(own, vec2(-3.875, 7.5), 0.0).r == 0.0"));
    EXPECT_TRUE(holds(texture, "abs(textureLod(own, vec2(0.125, 0.5), 2.0).r - 0.75) < 0.02"));
}

TEST_F(textures, are_looked_for_in_the_style_s_folder_then_among_the_shared_maps)
{
    pixels_ = {.width = 1, .height = 1, .channels = 1, .bytes = {0}};
    const fs::path maps = installation_prefix() / "share/hatchway/maps";
    fs::path shared;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(maps))
        if (entry.path().extension() == ".png") shared = entry.path().lexically_relative(maps);
    ASSERT_FALSE(shared.empty());
    ProgramCache& cache = renderer_.program_cache(folder_.path());
    EXPECT_TRUE(cache.texture(shared.string()).is_valid());
    EXPECT_TRUE(fs::equivalent(read_.at(0), maps / shared));
    folder_.write(shared.string(), "read by the test");
    cache.texture(shared.string());
    EXPECT_TRUE(fs::equivalent(read_.at(1), folder_.path() / shared)) << "the style's own comes first";
    cache.texture(shared.string());
    EXPECT_EQ(read_.size(), 2u) << "each file is read once";
}

TEST_F(textures, that_are_missing_or_lead_out_of_the_folder_are_refused)
{
    pixels_ = {.width = 1, .height = 1, .channels = 1, .bytes = {0}};
    folder_.write("style/shader.frag", "");
    ProgramCache& cache = renderer_.program_cache(folder_.path() / "style");
    for (const char* file : {"nothing.png", "../own.png", ""}) EXPECT_THROW(cache.texture(file), Error) << file;
    EXPECT_THAT(read_, testing::IsEmpty());
    Renderer without_reader(*context_);
    EXPECT_THROW(without_reader.program_cache(folder_.path()).texture("own.png"), Error);
}

}  // namespace
}  // namespace hw::test
