// Every shader compiles as OpenGL 3.3 core and as OpenGL ES 3.0.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/gpu_program.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "tests/render/assembled_programs.hpp"
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;

const fs::path kEngineShaders = fs::path(HATCHWAY_SOURCE_DIR) / "scenegraph/render/shaders";
const fs::path kPlugins = fs::path(HATCHWAY_SOURCE_DIR) / "npr_plugins";

std::string text_of(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

class shaders : public testing::TestWithParam<bool> {};

TEST_P(shaders, compile_with_every_feature)
{
    const auto context = make_headless_context({.is_es = GetParam()});
    int compiled = 0;
    for_each_program([&](const AssembledProgram& program) {
        try {
            const GpuProgram linked(program.vertex, program.fragment, GetParam());
            ++compiled;
        } catch (const Error& error) {
            ADD_FAILURE() << program.name << ": " << error.what();
        }
    });
    EXPECT_GT(compiled, 500);
    EXPECT_THAT(context->take_errors(), testing::IsEmpty());
}

std::string language_name(const testing::TestParamInfo<bool>& info)
{
    return info.param ? "es_300" : "core_330";
}
INSTANTIATE_TEST_SUITE_P(glsl, shaders, testing::Bool(), language_name);

TEST(shaders, use_nothing_that_es_3_lacks)
{
    for (const fs::path& folder : {kEngineShaders, kPlugins})
        for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
            const std::string extension = file.path().extension().string();
            if (extension != ".frag" && extension != ".vert" && extension != ".glsl") continue;
            const std::string text = text_of(file.path());
            for (const char* word :
                 {"sampler1D", "gl_ClipDistance", "gl_PrimitiveID;", "noperspective", "double ", "#version"})
                EXPECT_EQ(text.find(word), std::string::npos) << file.path() << " names " << word;
        }
}

TEST(es_3, draws_the_same_picture_as_the_desktop)
{
    Scene scene;
    add_object(scene, sphere_mesh(1.0f, 16), glm::dmat4(1.0), painted({0.8f, 0.4f, 0.2f}));
    add_object(scene, floor_mesh(6.0f), glm::dmat4(1.0), painted(glm::vec3(0.7f)));
    std::vector<Pixels> pictures;
    for (const bool is_es : {false, true}) {
        const auto context = make_headless_context({.is_es = is_es});
        Renderer renderer(*context);
        TestStyle style(glm::vec3(1.0f));
        style.look = LineLook{};
        style.shadow = ShadowNeed::main_light;
        style.fragment_file = "test_shadow.frag";
        style.prepare(renderer.program_cache(HATCHWAY_SOURCE_DIR "/tests/render/shaders"));
        Light sun;
        sun.type = LightType::sun;
        sun.direction_world = glm::normalize(glm::dvec3(-1, -2, -1));
        SceneInput input;
        input.scene = &scene;
        input.styles = {{"only", &style}};
        input.objects.assign(scene.objects.size(), StyledObject{.style = 0});
        input.lights = {sun};
        renderer.load(input);
        renderer.draw(camera_view({{2, 1.5, 3}, {0, 0, 0}, 60.0}, {320, 240}, scene.bounds_world), {.samples = 4});
        pictures.push_back(renderer.read_picture());
        EXPECT_THAT(context->take_errors(), testing::IsEmpty());
    }
    // Edges of lines may fall to another sample.
    EXPECT_LT(share_unlike(pictures[0], pictures[1], 3), 0.01);
    EXPECT_GT(count_dark(pictures[0]), 300);
}

}  // namespace
}  // namespace hw::test
