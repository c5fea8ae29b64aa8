#include "tests/render/assembled_programs.hpp"

#include <map>
#include <random>
#include <regex>
#include <set>
#include <vector>

#include "hatchway/core/files/files.hpp"
#include "hatchway/render/device/program_store.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;
namespace f = surface_feature;

const fs::path kSource = HATCHWAY_SOURCE_DIR;
const fs::path kEngineShaders = kSource / "scenegraph/render/shaders";
const fs::path kKit = kSource / "npr_plugins/kit";
constexpr int kRandomCombinations = 12;

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

/// A combination that a scene may have: no map without its coordinates, not more suns than lights.
SurfaceFeatures random_combination(std::mt19937& random)
{
    const auto any_of = [&](unsigned count) { return SurfaceFeatures(random() % count); };
    SurfaceFeatures features = 0;
    for (const SurfaceFeatures flag :
         {f::kUv0, f::kTangents, f::kColours, f::kDoubleSided, f::kPresence, f::kSpotLights, f::kLightRanges,
          f::kParallel, f::kHatchUv, f::kDirection, f::kTriangleId})
        features |= flag * any_of(2);
    if (features & f::kUv0) features |= f::kUv1 * any_of(2);
    const SurfaceFeatures uv_sets = (features & f::kUv1) != 0 ? 2 : (features & f::kUv0) != 0 ? 1 : 0;
    for (const int bit :
         {f::kBaseColourMapBit, f::kMetallicRoughnessMapBit, f::kNormalMapBit, f::kOcclusionMapBit, f::kEmissiveMapBit})
        features |= any_of(static_cast<unsigned>(uv_sets) + 1) << bit;
    for (std::size_t kind = 0; kind < kMapKindCount; ++kind)
        features |= f::map_of(static_cast<MapKind>(kind)) * any_of(2);
    const SurfaceFeatures lights = any_of(9);
    features |= lights << f::kLightCountBit | any_of(static_cast<unsigned>(lights) + 1) << f::kSunCountBit;
    features |= any_of(3) << f::kLightmapBit | f::kUnlit * (any_of(6) == 0) | f::kShadow * (lights > 0 ? any_of(2) : 0);
    const SurfaceFeatures alpha[] = {0, f::kAlphaMask, f::kAlphaBlend};
    return features | alpha[any_of(3)];
}

std::string text_of(const fs::path& file)
{
    return read_text_file(file, 1 << 20);
}

/// As programs name a shader: from the engine's or the plugin's folder on.
std::string shader_name(const fs::path& file)
{
    const fs::path of_engine = file.lexically_relative(kEngineShaders);
    return of_engine.string().starts_with("..") ? file.filename().string() : of_engine.string();
}

/// The vertex stage that a fragment stage goes with; `text`: with all that it includes.
std::string vertex_file_for(const fs::path& fragment, const std::string& text)
{
    fs::path own = fragment;
    if (fs::exists(own.replace_extension(".vert"))) return shader_name(own);
    if (text.find("HwLine hw_line()") != std::string::npos) return "lines/line_quad.vert";
    return text.find("in vec2 hw_v_uv;") == std::string::npos ? "surface.vert" : "full_screen.vert";
}

/// The define lines that the C++ of a folder and of the kit gives to this shader: none, each, and each two of them.
std::set<std::string> defines_for(const std::string& shader, const fs::path& folder)
{
    static const std::regex quoted(R"re("((?:#define \w+(?: \w+)?\\n)+)")re");
    std::set<std::string> single;
    std::vector<fs::path> sources;
    for (const fs::path& from : {folder, kKit})
        for (const fs::directory_entry& file : fs::recursive_directory_iterator(from))
            if (file.path().extension() == ".cpp" || file.path().extension() == ".hpp") sources.push_back(file.path());
    for (const fs::path& source : sources) {
        const std::string text = text_of(source);
        for (std::sregex_iterator match(text.begin(), text.end(), quoted), end; match != end; ++match) {
            const std::string lines = std::regex_replace((*match)[1].str(), std::regex(R"(\\n)"), "\n");
            const std::string word = lines.substr(8, lines.find_first_of(" \n", 8) - 8);
            if (shader.find(word) != std::string::npos) single.insert(lines);
        }
    }
    std::set<std::string> result{""};
    for (const std::string& one : single)
        for (const std::string& other : single) result.insert(one < other ? one + other : one);
    return result;
}

/// Named #define lines of what a program of this vertex stage is compiled for.
std::map<std::string, std::string> features_for(const std::string& vertex_file)
{
    const std::string bare = feature_defines(0);
    if (vertex_file.starts_with("lines/")) {
        const std::string presence = feature_defines(f::kPresence), stroke = "#define HW_STROKE 1\n";
        if (vertex_file == "lines/line_quad.vert")
            return {{"bare", bare}, {"presence", presence}, {"stroke", bare + stroke}, {"both", presence + stroke}};
        const std::string round = "#define HW_ROUND_POINT 1\n";
        return {{"bare", bare}, {"presence", presence}, {"round", bare + round}, {"both", presence + round}};
    }
    if (vertex_file != "surface.vert") return {{"bare", bare}};
    std::map<std::string, std::string> all;
    for (const auto& [name, features] : kCombinations) all[name] = feature_defines(features);
    std::mt19937 random(20011);
    for (int i = 0; i < kRandomCombinations; ++i)
        all["random " + std::to_string(i)] = feature_defines(random_combination(random));
    return all;
}

/// The programs of all fragment shaders in a folder and below; `source` is the folder of the C++ that names defines.
void take_folder(const fs::path& folder, const fs::path& source,
                 const std::function<void(const AssembledProgram&)>& take)
{
    const std::vector<fs::path> folders{folder, kKit, kEngineShaders};
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder)) {
        if (file.path().extension() != ".frag") continue;
        const std::string fragment = shader_name(file.path());
        const std::string text = load_shader(fragment, folders, {}).text;
        const std::string vertex = vertex_file_for(file.path(), text);
        // A pen always knows its stroke.
        const bool is_pen = vertex == "lines/line_quad.vert" && folder != kEngineShaders;
        for (const auto& [name, features] : features_for(vertex)) {
            if (is_pen && features.find("HW_STROKE") == std::string::npos) continue;
            for (const std::string& defines : defines_for(text, source))
                take({.name = fragment + " (" + name + ", " + defines + ")",
                      .vertex = load_shader(vertex, folders, features + defines),
                      .fragment = load_shader(fragment, folders, features + defines)});
        }
    }
}

}  // namespace

void for_each_program(const std::function<void(const AssembledProgram&)>& take)
{
    take_folder(kEngineShaders, kSource / "scenegraph/render", take);
    take_folder(kSource / "tests/render/shaders", kSource / "tests/render", take);
    take_folder(kSource / "tests/plugin_host/shaders", kSource / "tests/plugin_host", take);
    for (const fs::path& folder : {kSource / "npr_plugins", kSource / "docs/examples"})
        for (const fs::directory_entry& plugin : fs::directory_iterator(folder))
            if (plugin.is_directory()) take_folder(plugin.path(), plugin.path(), take);
}

}  // namespace hw::test
