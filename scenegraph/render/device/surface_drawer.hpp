#pragma once

#include <span>

#include "hatchway/gl/gpu_queries.hpp"
#include "hatchway/gl/gpu_state.hpp"
#include "hatchway/render/device/gpu_lightmap.hpp"
#include "hatchway/render/device/gpu_scene.hpp"
#include "hatchway/render/device/program_store.hpp"
#include "hatchway/render/view/scene_input.hpp"
#include "hatchway/render/view/visible_set.hpp"
#include "hatchway/style/pass.hpp"

namespace hw {

/// The maps of an item by kind: indices into SceneInput::maps, or kNone.
using ItemMaps = std::array<int, kMapKindCount>;

/// What an object's look names, and where it names none of a kind, what its style does.
ItemMaps choose_maps(const std::map<MapKind, int>& of_object, const std::map<MapKind, int>& of_style);

/// An object whose faces are drawn, as which item, where it stands, and its maps.
struct SurfaceItem {
    const DrawItem* item = nullptr;  ///< May be null for depth alone.
    const VisibleObject* object = nullptr;
    ItemMaps maps;
};

/// What a run of items shares.
struct SurfaceRun {
    Program program;
    const Uniforms* uniforms = nullptr;
    PipelineState state;
    SurfaceFeatures features = 0;  ///< Added to those of meshes, materials and maps.
    double time_s = 0.0;
    std::uint32_t shadow_texture = 0;
    Streams streams;                        ///< Beside the meshes' own.
    const GpuLightmap* lightmap = nullptr;  ///< Null: the run reads no baked light.
};

/// Draws objects' faces, the one way for all: styles, depth, shadow maps and images.
class SurfaceDrawer {
 public:
    SurfaceDrawer(ProgramStore& programs, GpuState& state, GpuScene& scene)
        : programs_(programs), state_(state), scene_(scene)
    {
    }

    void draw(const SurfaceRun& run, std::span<const SurfaceItem> items, std::span<const IndexRange> ranges);
    /// Depth alone, at the depths of draw(); alpha masks cut holes. `state` tells what faces; colours are not written.
    /// With `queries`, the question of a range's own number is whether the range leaves anything; an object's last
    /// range is then asked about first.
    void draw_depth(const PipelineState& state, std::span<const SurfaceItem> items, std::span<const IndexRange> ranges,
                    GpuQueries* queries = nullptr);

 private:
    void apply_faces(PipelineState state, const SurfaceItem& item);
    void draw_ranges(const SurfaceItem& item, std::span<const IndexRange> ranges);
    void ask_ranges(const SurfaceItem& item, std::span<const IndexRange> ranges, GpuQueries& queries);
    void set_object(const LinkedProgram& program, const SurfaceItem& item, double time_s);
    void set_material(const LinkedProgram& program, const GpuMaterial& gpu_material);
    void set_lightmap(const LinkedProgram& program, const GpuLightmap* lightmap, ObjectId object);
    void set_maps(const LinkedProgram& program, const SurfaceItem& item);

    ProgramStore& programs_;
    GpuState& state_;
    GpuScene& scene_;
};

/// Gives a program a style's own uniforms and images. The program must be in use.
void set_uniforms(const GpuProgram& program, const Uniforms& uniforms, GpuState& state);

}  // namespace hw
