#include "hatchway/render/device/program_store.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSurfaceVertexFile = "surface.vert";
constexpr const char* kFullScreenVertexFile = "full_screen.vert";
constexpr const char* kLineVertexFile = "lines/line_quad.vert";
constexpr const char* kStrokeDefine = "#define HW_STROKE 1\n";

SurfaceLocations locations_of(const GpuProgram& program)
{
    const auto at = [&](const char* name) { return program.location(name); };
    const auto unit = [&](const char* name) { return program.unit(name); };
    SurfaceLocations found{.clip_from_object = at("hw_clip_from_object"),
                           .relative_from_object = at("hw_relative_from_object"),
                           .normal_from_object = at("hw_normal_from_object"),
                           .certainty = at("hw_certainty"),
                           .handedness = at("hw_handedness"),
                           .hatch_scale = at("hw_hatch_scale"),
                           .base_colour_factor = at("hw_base_colour_factor"),
                           .mean_colour = at("hw_mean_colour"),
                           .material_factors = at("hw_material_factors"),
                           .emissive_normal = at("hw_emissive_normal"),
                           .presence_height = at("hw_presence_height"),
                           .presence_inverted = at("hw_presence_inverted"),
                           .base_colour_uv = at("hw_base_colour_uv"),
                           .metallic_roughness_uv = at("hw_metallic_roughness_uv"),
                           .normal_uv = at("hw_normal_uv"),
                           .occlusion_uv = at("hw_occlusion_uv"),
                           .emissive_uv = at("hw_emissive_uv"),
                           .unit_base_colour = unit("hw_base_colour_map"),
                           .unit_metallic_roughness = unit("hw_metallic_roughness_map"),
                           .unit_normal = unit("hw_normal_map"),
                           .unit_occlusion = unit("hw_occlusion_map"),
                           .unit_emissive = unit("hw_emissive_map"),
                           .unit_shadow = unit("hw_shadow_map"),
                           .unit_lightmap = unit("hw_lightmap"),
                           .lightmap_place = at("hw_lightmap_place"),
                           .object_id = at("hw_object_id"),
                           .first_triangle = at("hw_first_triangle")};
    for (std::size_t kind = 0; kind < kMapKindCount; ++kind) {
        const std::string name = "hw_" + std::string(kMapKinds[kind].name);
        found.map_info[kind] = program.location(name + "_info");
        found.unit_map[kind] = program.unit(name + "_map");
    }
    return found;
}

/// HW_INK_MAP
std::string map_define(std::string_view kind)
{
    std::string name = "HW_" + std::string(kind) + "_MAP";
    for (char& c : name)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return name;
}

/// surface.glsl holds one discard, that of the alpha mask.
bool has_own_discard(const ShaderText& fragment)
{
    int count = 0;
    for (std::size_t at = 0; (at = fragment.text.find("discard;", at)) != std::string::npos; ++at) ++count;
    return count > 1;
}

bool is_word_part(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool has_word(const std::string& text, std::string_view word)
{
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_word_part(text[at - 1])) && (end == text.size() || !is_word_part(text[end]))) return true;
    }
    return false;
}

}  // namespace

std::string feature_defines(SurfaceFeatures features)
{
    namespace f = surface_feature;
    static constexpr std::array<std::pair<SurfaceFeatures, const char*>, 16> kFlags = {{
        {f::kUv0, "HW_HAS_UV0"},
        {f::kUv1, "HW_HAS_UV1"},
        {f::kTangents, "HW_HAS_TANGENTS"},
        {f::kColours, "HW_HAS_COLOURS"},
        {f::kAlphaMask, "HW_ALPHA_MASK"},
        {f::kAlphaBlend, "HW_ALPHA_BLEND"},
        {f::kDoubleSided, "HW_DOUBLE_SIDED"},
        {f::kUnlit, "HW_UNLIT"},
        {f::kPresence, "HW_PRESENCE"},
        {f::kShadow, "HW_SHADOW"},
        {f::kSpotLights, "HW_SPOT_LIGHTS"},
        {f::kLightRanges, "HW_LIGHT_RANGES"},
        {f::kParallel, "HW_PARALLEL"},
        {f::kHatchUv, "HW_HAS_HATCH_UV"},
        {f::kDirection, "HW_HAS_DIRECTION"},
        {f::kTriangleId, "HW_HAS_TRIANGLE_ID"},
    }};
    static constexpr std::array<std::pair<int, const char*>, 6> kMaps = {{
        {f::kBaseColourMapBit, "HW_BASE_COLOUR_MAP"},
        {f::kMetallicRoughnessMapBit, "HW_METALLIC_ROUGHNESS_MAP"},
        {f::kNormalMapBit, "HW_NORMAL_MAP"},
        {f::kOcclusionMapBit, "HW_OCCLUSION_MAP"},
        {f::kEmissiveMapBit, "HW_EMISSIVE_MAP"},
        {f::kLightmapBit, "HW_LIGHTMAP"},
    }};
    std::string text;
    for (const auto& [bit, name] : kFlags)
        if (features & bit) text += std::string("#define ") + name + " 1\n";
    for (std::size_t kind = 0; kind < kMapKindCount; ++kind)
        if (features & f::map_of(static_cast<MapKind>(kind)))
            text += "#define " + map_define(kMapKinds[kind].name) + " 1\n";
    for (const auto& [shift, name] : kMaps)
        if (const auto set = (features >> shift) & 3; set != 0)
            text += std::string("#define ") + name + " " + std::to_string(set) + "\n";
    text += "#define HW_LIGHT_COUNT " + std::to_string((features >> f::kLightCountBit) & 15) + "\n";
    return text + "#define HW_SUN_COUNT " + std::to_string((features >> f::kSunCountBit) & 15) + "\n";
}

/// One fragment shader of one folder, and its compiled combinations. A null combination failed.
struct ProgramStore::Family {
    std::vector<fs::path> folders;
    std::string vertex_file;
    std::string fragment_file;
    std::string defines;
    bool discards = false;
    std::unordered_map<SurfaceFeatures, std::unique_ptr<LinkedProgram>> variants;
};

class ProgramStore::FolderCache final : public ProgramCache {
 public:
    FolderCache(ProgramStore& store, fs::path folder) : store_(store), folder_(std::move(folder)) {}
    Program surface(std::string_view fragment_file, std::string_view defines) override
    {
        return store_.add(folder_, kSurfaceVertexFile, fragment_file, defines);
    }
    Program full_screen(std::string_view fragment_file, std::string_view defines) override
    {
        return store_.add(folder_, kFullScreenVertexFile, fragment_file, defines);
    }
    Program line(std::string_view fragment_file, std::string_view defines) override
    {
        return store_.add(folder_, kLineVertexFile, fragment_file, kStrokeDefine + std::string(defines));
    }
    Image texture(std::string_view file) override { return store_.textures_.texture(folder_, file); }

 private:
    ProgramStore& store_;
    fs::path folder_;
};

ProgramStore::ProgramStore(fs::path engine_folder, fs::path kit_folder, bool is_es, ImageReader read_image)
    : engine_folder_(std::move(engine_folder)),
      kit_folder_(std::move(kit_folder)),
      textures_(std::move(read_image)),
      is_es_(is_es)
{
    plain_ = add(engine_folder_, kSurfaceVertexFile, "plain.frag", {});
}

ProgramStore::~ProgramStore() = default;

ProgramCache& ProgramStore::cache(const fs::path& style_folder)
{
    std::unique_ptr<ProgramCache>& found = caches_[style_folder];
    if (found == nullptr) found = std::make_unique<FolderCache>(*this, style_folder);
    return *found;
}

Program ProgramStore::add(const fs::path& folder, std::string_view vertex_file, std::string_view fragment_file,
                          std::string_view defines)
{
    std::string key = folder.string();
    for (const std::string_view part : {vertex_file, fragment_file, defines}) key.append("\n").append(part);
    if (const auto found = family_of_key_.find(key); found != family_of_key_.end()) return {found->second};

    auto family = std::make_unique<Family>();
    family->folders = {folder, kit_folder_, engine_folder_};
    family->vertex_file = vertex_file;
    family->fragment_file = fragment_file;
    family->defines = defines;
    family->discards = has_own_discard(load_shader(fragment_file, family->folders, {}));
    // Compiled at once without features: a style's mistakes show when it is prepared, not when it draws.
    family->variants[0] = compile(*family, 0);
    families_.push_back(std::move(family));
    const auto id = static_cast<std::uint32_t>(families_.size());
    family_of_key_[key] = id;
    return {id};
}

ProgramText ProgramStore::text_of(const Family& family, SurfaceFeatures features) const
{
    const std::string defines = feature_defines(features) + family.defines;
    const fs::path engine[] = {engine_folder_};
    return {load_shader(family.vertex_file, engine, defines),
            load_shader(family.fragment_file, family.folders, defines)};
}

std::unique_ptr<LinkedProgram> ProgramStore::compile(const Family& family, SurfaceFeatures features)
{
    const ProgramText text = text_of(family, features);
    auto linked = std::make_unique<LinkedProgram>();
    linked->gpu = GpuProgram(text.vertex, text.fragment, is_es_);
    linked->at = locations_of(linked->gpu);
    ++compiled_count_;
    return linked;
}

const LinkedProgram* ProgramStore::variant(Family& family, SurfaceFeatures features)
{
    const auto found = family.variants.find(features);
    if (found != family.variants.end()) return found->second.get();
    std::unique_ptr<LinkedProgram>& made = family.variants[features];
    try {
        made = compile(family, features);
    } catch (const Error& error) {
        log_error(error.what());
    }
    return made.get();
}

ProgramStore::Family* ProgramStore::family_of(Program program, std::string_view vertex_file) const
{
    if (!program.is_valid() || program.id > families_.size()) return nullptr;
    Family& family = *families_[program.id - 1];
    return family.vertex_file == vertex_file ? &family : nullptr;
}

const LinkedProgram* ProgramStore::surface(Program program, SurfaceFeatures features)
{
    Family* family = family_of(program, kSurfaceVertexFile);
    if (family == nullptr) return nullptr;
    const LinkedProgram* linked = variant(*family, features);
    return linked != nullptr || program.id == plain_.id ? linked : surface(plain_, features);
}

bool ProgramStore::is_named(Program program, std::string_view word) const
{
    if (!program.is_valid() || program.id > families_.size()) return false;
    const fs::path& folder = families_[program.id - 1]->folders.front();
    return std::ranges::any_of(families_, [&](const std::unique_ptr<Family>& family) {
        return family->folders.front() == folder &&
               has_word(load_shader(family->fragment_file, family->folders, {}).text, word);
    });
}

std::vector<ProgramText> ProgramStore::style_shaders() const
{
    std::vector<ProgramText> texts;
    for (const std::unique_ptr<Family>& family : families_) {
        if (family->folders.front() == engine_folder_) continue;
        for (const auto& [features, program] : family->variants) texts.push_back(text_of(*family, features));
    }
    return texts;
}

bool ProgramStore::discards(Program program) const
{
    const Family* family = family_of(program, kSurfaceVertexFile);
    return family != nullptr && family->discards;
}

const LinkedProgram* ProgramStore::full_screen(Program program)
{
    Family* family = family_of(program, kFullScreenVertexFile);
    return family == nullptr ? nullptr : variant(*family, 0);
}

const LinkedProgram* ProgramStore::line(Program program, SurfaceFeatures features)
{
    Family* family = family_of(program, kLineVertexFile);
    return family == nullptr ? nullptr : variant(*family, features & surface_feature::kPresence);
}

const LinkedProgram& ProgramStore::engine(std::string_view vertex_file, std::string_view fragment_file,
                                          std::string_view defines)
{
    const Program program = add(engine_folder_, vertex_file, fragment_file, defines);
    return *families_[program.id - 1]->variants.at(0);
}

void ProgramStore::reload()
{
    std::optional<Error> failure;
    // The program in use may be among the replaced ones: they go when nothing is compiled any more.
    std::vector<decltype(Family::variants)> replaced;
    for (const std::unique_ptr<Family>& family : families_) {
        auto fresh = decltype(family->variants)();
        try {
            for (const auto& [features, ignored] : family->variants) fresh[features] = compile(*family, features);
            replaced.push_back(std::exchange(family->variants, std::move(fresh)));
        } catch (const Error& error) {
            if (!failure) failure = error;
        }
    }
    if (failure) throw *failure;
}

}  // namespace hw
