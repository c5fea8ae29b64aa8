#include "render/style_pass.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/log.hpp"

namespace hw {
namespace {

constexpr PipelineState kBehindLines{.offset_factor = kFaceOffsetFactor, .offset_units = kFaceOffsetUnits};

TextureFormat texture_format(PixelFormat format)
{
    switch (format) {
        case PixelFormat::r8:
            return TextureFormat::r8;
        case PixelFormat::rg8:
            return TextureFormat::rg8;
        case PixelFormat::rgba8:
            return TextureFormat::rgba8;
        case PixelFormat::rgba16f:
            return TextureFormat::rgba16f;
        case PixelFormat::r32f:
            return TextureFormat::r32f;
        case PixelFormat::rgba32f:
            break;
    }
    return TextureFormat::rgba32f;
}

PipelineState picture_state(PassStage stage, bool has_lines)
{
    // Blended faces come after the lines and are tested against the depth that those were.
    PipelineState state = stage == PassStage::blended && has_lines ? kBehindLines : PipelineState{};
    if (stage == PassStage::over) {
        state.depth_test = DepthTest::equal;
        state.writes_depth = false;
        state.blending = Blending::over;
    }
    if (stage == PassStage::blended) {
        state.depth_test = DepthTest::less_equal;
        state.writes_depth = false;
        state.blending = Blending::over;
    }
    return state;
}

std::vector<SurfaceItem> surface_items_of(const FrameParts& frame, std::span<const DrawItem> items,
                                          const std::map<MapKind, int>& style_maps)
{
    std::vector<SurfaceItem> surface_items;
    surface_items.reserve(items.size());
    for (const DrawItem& item : items) {
        const VisibleObject& object = frame.visible->objects[item.slot];
        surface_items.push_back({&item, &object, choose_maps((*frame.looks)[object.object].maps, style_maps)});
    }
    return surface_items;
}

}  // namespace

StylePass::StylePass(FrameParts& frame, PassStage stage, const StyleLight& light, const std::map<MapKind, int>& maps)
    : frame_(frame), stage_(stage), light_(light), style_maps_(maps)
{
}

Image StylePass::image(const ImageKey& key) const
{
    const auto found = frame_.images.find(key);
    return found == frame_.images.end() ? Image() : found->second;
}

GpuTarget* StylePass::transient(const TargetDesc& target)
{
    const glm::vec2 size = glm::vec2(frame_.view->size_px) * std::clamp(target.scale, 0.01f, 4.0f);
    const bool is_float = target.format >= PixelFormat::rgba16f;
    try {
        GpuTarget& made = frame_.pool->take({.size_px = glm::max(glm::ivec2(glm::ceil(size)), glm::ivec2(1)),
                                             .colours = {texture_format(target.format)},
                                             .has_depth = target.has_depth,
                                             .filter = is_float ? FilterMode::nearest : FilterMode::linear});
        ++frame_.transient_targets;
        made.bind();
        frame_.state->apply({});
        made.clear(target.clear);
        return &made;
    } catch (const Error& error) {
        log_error(error.what());
        return nullptr;
    }
}

Image StylePass::render(const TargetDesc& target, Program program, const Uniforms& uniforms,
                        std::span<const DrawItem> items)
{
    GpuTarget* made = transient(target);
    if (made == nullptr) return {};
    PipelineState state;
    if (!target.has_depth) state.depth_test = DepthTest::off;
    draw_surfaces(program, uniforms, items, state);
    frame_.picture->bind();
    return {made->colour().id(), made->desc().size_px};
}

Image StylePass::filter(const TargetDesc& target, Program program, const Uniforms& uniforms)
{
    const LinkedProgram* linked = frame_.programs->full_screen(program);
    if (linked == nullptr) return {};
    TargetDesc flat = target;
    flat.has_depth = false;
    GpuTarget* made = transient(flat);
    if (made == nullptr) return {};
    frame_.state->use(linked->gpu);
    set_uniforms(linked->gpu, uniforms, *frame_.state);
    frame_.state->apply({.depth_test = DepthTest::off, .writes_depth = false, .culling = Culling::off});
    frame_.state->bind(*frame_.no_vertices);
    frame_.state->draw(Primitive::triangles, 0, 3);
    frame_.picture->bind();
    return {made->colour().id(), made->desc().size_px};
}

void StylePass::surfaces(Program program, const Uniforms& uniforms, std::span<const DrawItem> items)
{
    if (stage_ == PassStage::images) return;
    draw_surfaces(program, uniforms, items, picture_state(stage_, frame_.has_lines));
    if (stage_ == PassStage::base && frame_.has_lines)
        frame_.drawn_faces.push_back({program, uniforms, {items.begin(), items.end()}, &style_maps_});
}

void StylePass::draw_surfaces(Program program, const Uniforms& uniforms, std::span<const DrawItem> items,
                              const PipelineState& state)
{
    const std::vector<SurfaceItem> surface_items = surface_items_of(frame_, items, style_maps_);
    PipelineState face_state = state;
    // Depth first, so that every pixel is shaded once. What a style cuts out by itself, depth cannot know; and with
    // several samples the software renderer shades what fails the depth test all the same.
    const bool is_sampled = stage_ != PassStage::images && frame_.line_frame.samples > 1;
    if (state.writes_depth && state.depth_test == DepthTest::less && !is_sampled &&
        !frame_.programs->discards(program)) {
        frame_.surfaces->draw_depth(state, surface_items, frame_.visible->ranges);
        face_state.depth_test = DepthTest::equal;
        face_state.writes_depth = false;
    }
    const bool has_shadow = light_.uses_shadow && frame_.shadow_texture != 0;
    frame_.surfaces->draw({.program = program,
                           .uniforms = &uniforms,
                           .state = face_state,
                           .features = frame_.scene_features | (has_shadow ? surface_feature::kShadow : 0),
                           .time_s = frame_.view->time_s,
                           .shadow_texture = has_shadow ? frame_.shadow_texture : 0,
                           .lightmap = light_.uses_lightmap ? frame_.lightmap : nullptr},
                          surface_items, frame_.visible->ranges);
}

void StylePass::lines(const LineLook& look, std::span<const DrawItem> items)
{
    if (stage_ == PassStage::images) return;
    std::vector<LineItem> line_items;
    for (const DrawItem& item : items) line_items.push_back({&item, &frame_.visible->objects[item.slot]});
    frame_.lines->draw(frame_.line_frame, look, line_items, *frame_.edges);
}

void lay_line_depth(FrameParts& frame)
{
    frame.picture->clear_depth();
    PipelineState state = kBehindLines;
    state.writes_colour = false;
    for (const DrawnFaces& faces : frame.drawn_faces) {
        const std::vector<SurfaceItem> items = surface_items_of(frame, faces.items, *faces.style_maps);
        if (frame.programs->discards(faces.program))
            frame.surfaces->draw({.program = faces.program,
                                  .uniforms = &faces.uniforms,
                                  .state = state,
                                  .features = frame.scene_features,
                                  .time_s = frame.view->time_s},
                                 items, frame.visible->ranges);
        else
            frame.surfaces->draw_depth(state, items, frame.visible->ranges);
    }
    frame.state->apply({});
}

}  // namespace hw
