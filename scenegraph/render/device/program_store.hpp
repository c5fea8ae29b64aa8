#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "hatchway/gl/gpu_program.hpp"
#include "hatchway/param/map_kind.hpp"
#include "hatchway/render/device/texture_store.hpp"
#include "hatchway/style/program_cache.hpp"

namespace hw {

/// What a surface program is compiled for: bits, and small numbers at the places named below. A program of a style is
/// compiled once for each combination that occurs.
using SurfaceFeatures = std::uint64_t;
namespace surface_feature {
inline constexpr SurfaceFeatures kUv0 = 1u << 0;
inline constexpr SurfaceFeatures kUv1 = 1u << 1;
inline constexpr SurfaceFeatures kTangents = 1u << 2;
inline constexpr SurfaceFeatures kColours = 1u << 3;
inline constexpr SurfaceFeatures kAlphaMask = 1u << 4;
inline constexpr SurfaceFeatures kAlphaBlend = 1u << 5;
inline constexpr SurfaceFeatures kDoubleSided = 1u << 6;
inline constexpr SurfaceFeatures kUnlit = 1u << 7;
inline constexpr SurfaceFeatures kPresence = 1u << 11;
inline constexpr SurfaceFeatures kShadow = 1u << 12;
inline constexpr SurfaceFeatures kSpotLights = 1u << 13;
inline constexpr SurfaceFeatures kLightRanges = 1u << 14;
inline constexpr SurfaceFeatures kParallel = 1u << 15;
/// Two bits each: 0 no map, 1 on uv0, 2 on uv1.
inline constexpr int kBaseColourMapBit = 16;
inline constexpr int kMetallicRoughnessMapBit = 18;
inline constexpr int kNormalMapBit = 20;
inline constexpr int kOcclusionMapBit = 22;
inline constexpr int kEmissiveMapBit = 24;
/// Four bits each: how many lights, and how many of them are suns.
inline constexpr int kLightCountBit = 26;
inline constexpr int kSunCountBit = 30;
/// Two bits: 0 no baked light, 1 in charts, 2 per vertex.
inline constexpr int kLightmapBit = 34;
inline constexpr SurfaceFeatures kHatchUv = SurfaceFeatures(1) << 37;
inline constexpr SurfaceFeatures kDirection = SurfaceFeatures(1) << 38;
inline constexpr SurfaceFeatures kTriangleId = SurfaceFeatures(1) << 39;
/// One bit for each kind of map, in the order of kMapKinds.
inline constexpr int kMapBit = 40;
constexpr SurfaceFeatures map_of(MapKind kind)
{
    return SurfaceFeatures(1) << (kMapBit + static_cast<int>(kind));
}
}  // namespace surface_feature

/// Where a surface program's uniforms stand; -1 where the program does not use one.
struct SurfaceLocations {
    int clip_from_object, relative_from_object, normal_from_object;
    int certainty, handedness, hatch_scale, base_colour_factor, mean_colour, material_factors, emissive_normal;
    int presence_height, presence_inverted;
    int base_colour_uv, metallic_roughness_uv, normal_uv, occlusion_uv, emissive_uv;
    int unit_base_colour, unit_metallic_roughness, unit_normal, unit_occlusion, unit_emissive;
    int unit_shadow, unit_lightmap;
    int lightmap_place;
    int object_id, first_triangle;
    std::array<int, kMapKindCount> map_info, unit_map;  ///< By kind of map.
};

struct LinkedProgram {
    GpuProgram gpu;
    SurfaceLocations at{};
};

/// The stages of a program, as they were compiled.
struct ProgramText {
    ShaderText vertex;
    ShaderText fragment;
};

/// All programs of a renderer: styles' and the engine's own. Ids stay valid when files are read anew.
class ProgramStore {
 public:
    /// `engine_folder` holds the engine's shaders, `kit_folder` what styles share beside: each style's shaders find
    /// both. `read_image` decodes textures of styles.
    ProgramStore(std::filesystem::path engine_folder, std::filesystem::path kit_folder, bool is_es,
                 ImageReader read_image);
    ~ProgramStore();

    const std::filesystem::path& engine_folder() const { return engine_folder_; }
    /// Lives as long as the store.
    ProgramCache& cache(const std::filesystem::path& style_folder);

    /// The program for these features, compiled on first use. Null for an invalid id; a combination that does not
    /// compile is logged once and gives the plain program instead.
    const LinkedProgram* surface(Program program, SurfaceFeatures features);
    /// Whether the fragment stage discards by itself, beside the alpha mask of hw_material().
    bool discards(Program program) const;
    const LinkedProgram* full_screen(Program program);
    /// A pen; of the features presence alone counts. Null as above.
    const LinkedProgram* line(Program program, SurfaceFeatures features);
    /// A program of the engine from files of its own folder. Throws hw::Error.
    const LinkedProgram& engine(std::string_view vertex_file, std::string_view fragment_file,
                                std::string_view defines = {});

    /// Compiles everything anew from the files. A program that fails keeps what it had; the first failure is thrown
    /// when all have been tried.
    void reload();
    /// Whether a fragment stage of the same folder as the program's names this word, such as a uniform: a style may
    /// share its uniforms among its programs.
    bool is_named(Program program, std::string_view word) const;
    /// Every combination that has been compiled, of programs that are not the engine's own.
    std::vector<ProgramText> style_shaders() const;
    int compiled_count() const { return compiled_count_; }

 private:
    struct Family;
    class FolderCache;

    Program add(const std::filesystem::path& folder, std::string_view vertex_file, std::string_view fragment_file,
                std::string_view defines);
    ProgramText text_of(const Family& family, SurfaceFeatures features) const;
    std::unique_ptr<LinkedProgram> compile(const Family& family, SurfaceFeatures features);
    const LinkedProgram* variant(Family& family, SurfaceFeatures features);
    /// Null for an invalid id or one that was made with another vertex stage.
    Family* family_of(Program program, std::string_view vertex_file) const;

    std::filesystem::path engine_folder_;
    std::filesystem::path kit_folder_;
    TextureStore textures_;
    bool is_es_;
    int compiled_count_ = 0;
    std::vector<std::unique_ptr<Family>> families_;  ///< Program id - 1 -> family.
    std::map<std::string, std::uint32_t> family_of_key_;
    std::map<std::filesystem::path, std::unique_ptr<ProgramCache>> caches_;
    Program plain_;
};

/// The #define lines of a combination.
std::string feature_defines(SurfaceFeatures features);

}  // namespace hw
