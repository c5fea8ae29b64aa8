#include "hatchway/render/device/surface_drawer.hpp"

#include "hatchway/render/device/presence_uniforms.hpp"

namespace hw {
namespace {

SurfaceFeatures map_features(const ItemMaps& maps)
{
    SurfaceFeatures features = 0;
    for (std::size_t kind = 0; kind < kMapKindCount; ++kind)
        if (maps[kind] != kNone) features |= surface_feature::map_of(static_cast<MapKind>(kind));
    return features;
}

/// Baked light holds its shadows.
void add_lightmap_feature(const GpuLightmap& lightmap, ObjectId object, SurfaceFeatures& features)
{
    const SurfaceFeatures kind = lightmap.feature(object);
    if (kind == 0) return;
    features &= ~surface_feature::kShadow;
    features |= kind << surface_feature::kLightmapBit;
}

/// The features that decide where an alpha mask cuts, and no other: what depth alone needs.
SurfaceFeatures mask_features(const GpuMesh& mesh, const GpuMaterial& material)
{
    namespace f = surface_feature;
    if ((material.features & f::kAlphaMask) == 0) return 0;
    const SurfaceFeatures maps = static_cast<SurfaceFeatures>(3) << f::kBaseColourMapBit;
    return (mesh.features & (f::kUv0 | f::kUv1 | f::kColours)) | (material.features & (f::kAlphaMask | maps));
}

}  // namespace

ItemMaps choose_maps(const std::map<MapKind, int>& of_object, const std::map<MapKind, int>& of_style)
{
    ItemMaps chosen;
    chosen.fill(kNone);
    for (const auto* maps : {&of_style, &of_object})
        for (const auto& [kind, index] : *maps)
            if (index != kNone) chosen[static_cast<std::size_t>(kind)] = index;
    return chosen;
}

void set_uniforms(const GpuProgram& program, const Uniforms& uniforms, GpuState& state)
{
    for (const Uniforms::Entry& entry : uniforms.entries()) {
        if (const auto* image = std::get_if<Image>(&entry.value)) {
            state.bind_texture(program.unit(entry.name), image->id);
            continue;
        }
        const int location = program.location(entry.name);
        std::visit(
            [&](const auto& value) {
                if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, Image>) GpuProgram::set(location, value);
            },
            entry.value);
    }
}

void SurfaceDrawer::draw(const SurfaceRun& run, std::span<const SurfaceItem> items, std::span<const IndexRange> ranges)
{
    const LinkedProgram* last = nullptr;
    const GpuMaterial* last_material = nullptr;
    for (const SurfaceItem& item : items) {
        if (item.object->range_count == 0) continue;
        const StreamMesh streamed = scene_.mesh_of(item.object->object, run.streams);
        const GpuMesh& mesh = *streamed.mesh;
        const GpuMaterial& gpu_material = scene_.material_of(item.object->object);
        SurfaceFeatures features = run.features | streamed.features | gpu_material.features | map_features(item.maps);
        if (has_presence(*item.item)) features |= surface_feature::kPresence;
        if (run.lightmap != nullptr) add_lightmap_feature(*run.lightmap, item.object->object, features);
        const LinkedProgram* program = programs_.surface(run.program, features);
        if (program == nullptr) return;
        state_.use(program->gpu);
        if (program != last) {
            if (run.uniforms != nullptr) set_uniforms(program->gpu, *run.uniforms, state_);
            state_.bind_texture(program->at.unit_shadow, run.shadow_texture);
            last = program;
            last_material = nullptr;
        }
        apply_faces(run.state, item);
        state_.bind(mesh.array);
        set_object(*program, item, run.time_s);
        GpuProgram::set(program->at.first_triangle, scene_.first_triangle(item.object->object));
        GpuProgram::set(program->at.hatch_scale, glm::vec2(mesh.metres_per_uv, 1.0f) * item.object->scale);
        if (&gpu_material != last_material) set_material(*program, gpu_material);
        last_material = &gpu_material;
        set_maps(*program, item);
        set_lightmap(*program, run.lightmap, item.object->object);
        draw_ranges(item, ranges);
    }
}

void SurfaceDrawer::draw_depth(const PipelineState& state, std::span<const SurfaceItem> items,
                               std::span<const IndexRange> ranges, GpuQueries* queries)
{
    PipelineState depth_state = state;
    depth_state.writes_colour = false;
    for (const SurfaceItem& item : items) {
        const GpuMesh& mesh = scene_.mesh_of(item.object->object);
        const GpuMaterial& gpu_material = scene_.material_of(item.object->object);
        const SurfaceFeatures features = mask_features(mesh, gpu_material);
        const LinkedProgram& program = programs_.engine("surface.vert", "depth.frag", feature_defines(features));
        state_.use(program.gpu);
        apply_faces(depth_state, item);
        state_.bind(mesh.array);
        GpuProgram::set(program.at.clip_from_object, item.object->clip_from_object);
        if (features != 0) set_material(program, gpu_material);
        if (queries != nullptr)
            ask_ranges(item, ranges, *queries);
        else
            draw_ranges(item, ranges);
    }
}

void SurfaceDrawer::apply_faces(PipelineState state, const SurfaceItem& item)
{
    state.is_front_clockwise = item.object->facing < 0.0f;
    if (scene_.material_of(item.object->object).facts->is_double_sided) state.culling = Culling::off;
    state_.apply(state);
}

void SurfaceDrawer::draw_ranges(const SurfaceItem& item, std::span<const IndexRange> ranges)
{
    for (const IndexRange& range : ranges.subspan(item.object->first_range, item.object->range_count))
        state_.draw_indexed(Primitive::triangles, range.first, range.count);
}

void SurfaceDrawer::ask_ranges(const SurfaceItem& item, std::span<const IndexRange> ranges, GpuQueries& queries)
{
    const std::uint32_t first = item.object->first_range;
    for (std::uint32_t i = first + item.object->range_count; i-- > first;) {
        queries.begin(i);
        state_.draw_indexed(Primitive::triangles, ranges[i].first, ranges[i].count);
        queries.end();
    }
}

void SurfaceDrawer::set_object(const LinkedProgram& program, const SurfaceItem& item, double time_s)
{
    const SurfaceLocations& at = program.at;
    GpuProgram::set(at.clip_from_object, item.object->clip_from_object);
    GpuProgram::set(at.relative_from_object, item.object->relative_from_object);
    GpuProgram::set(at.normal_from_object, item.object->normal_from_object);
    GpuProgram::set(at.handedness, item.object->handedness);
    GpuProgram::set(at.object_id, static_cast<int>(item.object->object) + 1);
    GpuProgram::set(at.certainty, item.item->certainty());
    set_presence(at.presence_height, at.presence_inverted, *item.item, time_s);
}

void SurfaceDrawer::set_material(const LinkedProgram& program, const GpuMaterial& gpu_material)
{
    const SurfaceLocations& at = program.at;
    const Material& material = *gpu_material.facts;
    GpuProgram::set(at.base_colour_factor, material.base_colour);
    GpuProgram::set(at.mean_colour, gpu_material.mean_colour);
    GpuProgram::set(at.material_factors, glm::vec4(material.metallic, material.roughness, material.alpha_cutoff,
                                                   material.occlusion_strength));
    GpuProgram::set(at.emissive_normal, glm::vec4(material.emissive, material.normal_scale));
    const auto map = [&](int unit, std::uint32_t texture, int uv, const TextureUse& use) {
        if (unit < 0) return;
        state_.bind_texture(unit, texture);
        GpuProgram::set(uv, use.uv_transform);
    };
    map(at.unit_base_colour, gpu_material.base_colour, at.base_colour_uv, material.base_colour_texture);
    map(at.unit_metallic_roughness, gpu_material.metallic_roughness, at.metallic_roughness_uv,
        material.metallic_roughness_texture);
    map(at.unit_normal, gpu_material.normal, at.normal_uv, material.normal_texture);
    map(at.unit_occlusion, gpu_material.occlusion, at.occlusion_uv, material.occlusion_texture);
    map(at.unit_emissive, gpu_material.emissive, at.emissive_uv, material.emissive_texture);
}

void SurfaceDrawer::set_lightmap(const LinkedProgram& program, const GpuLightmap* lightmap, ObjectId object)
{
    if (program.at.unit_lightmap < 0 || lightmap == nullptr || lightmap->feature(object) == 0) return;
    state_.bind_texture(program.at.unit_lightmap, lightmap->texture());
    GpuProgram::set(program.at.lightmap_place, lightmap->place(object));
}

void SurfaceDrawer::set_maps(const LinkedProgram& program, const SurfaceItem& item)
{
    for (std::size_t kind = 0; kind < kMapKindCount; ++kind) {
        if (program.at.unit_map[kind] < 0 || item.maps[kind] == kNone) continue;
        const GpuMap& map = scene_.map(item.maps[kind]);
        state_.bind_texture(program.at.unit_map[kind], map.texture.id());
        GpuProgram::set(program.at.map_info[kind], map.info);
    }
}

}  // namespace hw
