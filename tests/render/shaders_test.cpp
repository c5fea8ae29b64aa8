// Every shader of the engine and of the plugins compiles as OpenGL 3.3 core and as OpenGL ES 3.0.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/gpu_program.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/render/device/program_store.hpp"
#include "tests/render/test_scenes.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;
namespace f = surface_feature;

const fs::path kEngineShaders = fs::path(HATCHWAY_SOURCE_DIR) / "scenegraph/render/shaders";
const fs::path kPlugins = fs::path(HATCHWAY_SOURCE_DIR) / "npr_plugins";
const fs::path kKit = kPlugins / "kit";

constexpr SurfaceFeatures maps_on(SurfaceFeatures uv_set)
{
    SurfaceFeatures features = 0;
    for (const int bit :
         {f::kBaseColourMapBit, f::kMetallicRoughnessMapBit, f::kNormalMapBit, f::kOcclusionMapBit, f::kEmissiveMapBit})
        features |= uv_set << bit;
    return features;
}

/// Combinations that between them switch on every feature.
const std::map<std::string, SurfaceFeatures> kCombinations = {
    {"bare", 0},
    {"lit", SurfaceFeatures(8) << f::kLightCountBit | SurfaceFeatures(2) << f::kSunCountBit | f::kSpotLights |
                f::kLightRanges | f::kParallel | f::kShadow | f::kPresence | f::kDoubleSided},
    {"textured", f::kUv0 | maps_on(1) | f::kAlphaMask | SurfaceFeatures(2) << f::kLightCountBit},
    {"second_uv", f::kUv0 | f::kUv1 | f::kTangents | f::kColours | maps_on(2) | f::kAlphaBlend | f::kDoubleSided},
    {"baked", f::kUv0 | SurfaceFeatures(1) << f::kLightmapBit | SurfaceFeatures(2) << f::kLightCountBit |
                  SurfaceFeatures(1) << f::kSunCountBit | f::kDoubleSided},
    {"baked_per_vertex",
     SurfaceFeatures(2) << f::kLightmapBit | SurfaceFeatures(1) << f::kLightCountBit | f::kDoubleSided},
    {"mapped", f::kUv0 | f::map_of(MapKind::hatch) | f::map_of(MapKind::ink) | f::map_of(MapKind::tonal) |
                   f::map_of(MapKind::ramp) | f::map_of(MapKind::image) | SurfaceFeatures(1) << f::kLightCountBit},
    {"streamed", f::kUv0 | f::kHatchUv | f::kDirection | f::kTriangleId | f::map_of(MapKind::ink) |
                     f::map_of(MapKind::hatch) | SurfaceFeatures(2) << f::kLightmapBit},
    {"streamed_without_uv",
     f::kHatchUv | f::map_of(MapKind::tonal) | f::kShadow | SurfaceFeatures(1) << f::kLightCountBit},
    {"mapped_without_uv", f::map_of(MapKind::hatch) | f::map_of(MapKind::ink) | f::map_of(MapKind::tonal) |
                              f::map_of(MapKind::image) | f::kShadow | f::kUnlit | f::kPresence},
};

std::string text_of(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// As programs name a shader: from the engine's or the plugin's folder on.
std::string shader_name(const fs::path& file)
{
    const fs::path of_engine = file.lexically_relative(kEngineShaders);
    return of_engine.string().starts_with("..") ? file.filename().string() : of_engine.string();
}

/// The vertex stage that a fragment stage goes with.
std::string vertex_file_for(const fs::path& fragment)
{
    fs::path own = fragment;
    if (fs::exists(own.replace_extension(".vert"))) return shader_name(own);
    const std::string text = text_of(fragment);
    if (text.find("line_pen.glsl") != std::string::npos) return "lines/line_quad.vert";
    return text.find("full_screen.glsl") == std::string::npos ? "surface.vert" : "full_screen.vert";
}

/// The define lines that a plugin's source gives to its programs, each with the empty one.
std::vector<std::string> defines_in(const fs::path& folder)
{
    std::vector<std::string> result{""};
    static const std::regex define(R"re("(#define \w+(?: \w+)?)\\n")re");
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
        if (file.path().extension() != ".cpp") continue;
        const std::string text = text_of(file.path());
        for (std::sregex_iterator match(text.begin(), text.end(), define), end; match != end; ++match)
            result.push_back((*match)[1].str() + "\n");
    }
    return result;
}

void compile_folder(const fs::path& folder, bool is_es, int& compiled)
{
    const std::vector<fs::path> folders{folder, kKit, kEngineShaders};
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
        if (file.path().extension() != ".frag") continue;
        const std::string fragment = shader_name(file.path());
        std::vector<std::string> defines = defines_in(folder);
        if (vertex_file_for(file.path()) == "lines/line_quad.vert") defines.push_back("#define HW_STROKE 1\n");
        if (fragment == "images/show_image.frag") defines.push_back("#define HW_WHOLE_NUMBERS 1\n");
        for (const std::string& define : defines)
            for (const auto& [name, features] : kCombinations) {
                const std::string all = feature_defines(features) + define;
                try {
                    const GpuProgram program(load_shader(vertex_file_for(file.path()), folders, all),
                                             load_shader(fragment, folders, all), is_es);
                    ++compiled;
                } catch (const Error& error) {
                    ADD_FAILURE() << fragment << " (" << name << ", " << define << "): " << error.what();
                    return;
                }
            }
    }
}

class shaders : public testing::TestWithParam<bool> {};

TEST_P(shaders, of_the_engine_and_the_plugins_compile_with_every_feature)
{
    const auto context = make_headless_context({.is_es = GetParam()});
    int compiled = 0;
    compile_folder(kEngineShaders, GetParam(), compiled);
    for (const fs::directory_entry& plugin : fs::directory_iterator(kPlugins))
        if (plugin.is_directory()) compile_folder(plugin.path(), GetParam(), compiled);
    EXPECT_GT(compiled, 50);
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
    EXPECT_LT(count_unlike(pictures[0], pictures[1], 3), count_dark(pictures[0]) / 50);
    EXPECT_GT(count_dark(pictures[0]), 300);
}

}  // namespace
}  // namespace hw::test
