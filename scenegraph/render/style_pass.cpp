#include "hatchway/render/style_pass.hpp"

#include <algorithm>
#include <cmath>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/render/opaque_faces.hpp"

namespace hw {
namespace {

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

PipelineState picture_state(PassStage stage)
{
    PipelineState state;
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

}  // namespace

StylePass::StylePass(const Frame& frame, PassStage stage, const StyleReads& reads, const std::map<MapKind, int>& maps)
    : frame_(frame), stage_(stage), reads_(reads), style_maps_(maps)
{
}

Image StylePass::image(const ImageKey& key) const
{
    const auto found = frame_.results.images.find(key);
    return found == frame_.results.images.end() ? Image() : found->second;
}

GpuTarget* StylePass::transient(const TargetDesc& target)
{
    const glm::vec2 size = glm::vec2(frame_.view.camera.size_px) * std::clamp(target.scale, 0.01f, 4.0f);
    const bool is_float = target.format >= PixelFormat::rgba16f;
    try {
        GpuTarget& made = frame_.device.pool.take({.size_px = glm::max(glm::ivec2(glm::ceil(size)), glm::ivec2(1)),
                                                   .colours = {texture_format(target.format)},
                                                   .has_depth = target.has_depth,
                                                   .filter = is_float ? FilterMode::nearest : FilterMode::linear});
        ++frame_.results.transient_targets;
        made.bind();
        frame_.device.state.apply({});
        made.clear(target.clear);
        return &made;
    } catch (const Error& error) {
        log_error(error.what());
        return nullptr;
    }
}

Image StylePass::render(const TargetDesc& target, Program program, const Uniforms& uniforms, Items items)
{
    GpuTarget* made = transient(target);
    if (made == nullptr) return {};
    const FaceCall call = call_of(program, uniforms, items);
    if (target.has_depth)
        draw_faces_depth_first(frame_, call);
    else
        draw_faces(frame_, call, {.depth_test = DepthTest::off});
    frame_.view.picture.bind();
    return {made->colour().id(), made->desc().size_px};
}

Image StylePass::filter(const TargetDesc& target, Program program, const Uniforms& uniforms)
{
    const LinkedProgram* linked = frame_.device.programs.full_screen(program);
    if (linked == nullptr) return {};
    TargetDesc flat = target;
    flat.has_depth = false;
    GpuTarget* made = transient(flat);
    if (made == nullptr) return {};
    frame_.device.state.use(linked->gpu);
    set_uniforms(linked->gpu, uniforms, frame_.device.state);
    frame_.device.state.apply({.depth_test = DepthTest::off, .writes_depth = false, .culling = Culling::off});
    frame_.device.state.bind(frame_.device.no_vertices);
    frame_.device.state.draw(Primitive::triangles, 0, 3);
    frame_.view.picture.bind();
    return {made->colour().id(), made->desc().size_px};
}

FaceCall StylePass::call_of(Program program, const Uniforms& uniforms, Items items) const
{
    return {program, uniforms, of_this_frame(items), reads_, &style_maps_};
}

std::vector<DrawItem> StylePass::of_this_frame(Items items) const
{
    std::vector<DrawItem> known;
    for (const DrawItem& item : items)
        if (frame_.view.plan.items.has_made(item)) known.push_back(item);
    if (known.size() < items.size() && frame_.scene.refused_styles.insert(std::string(reads_.name)).second)
        log_error("the style \"" + std::string(reads_.name) + "\" draws items that are not of this frame: left out");
    return known;
}

void StylePass::surfaces(Program program, const Uniforms& uniforms, Items items)
{
    if (stage_ == PassStage::images) return;
    FaceCall call = call_of(program, uniforms, items);
    if (stage_ == PassStage::base)
        frame_.results.opaque_faces.push_back(std::move(call));
    else
        draw_faces(frame_, call, picture_state(stage_), Hidden::left_out);
}

void StylePass::lines(const LineLook& look, Items items)
{
    if (stage_ == PassStage::images || !reads_.edges) return;
    const std::vector<DrawItem> known = of_this_frame(items);
    std::vector<LineItem> line_items;
    for (const DrawItem& item : known)
        line_items.push_back({&item, &frame_.view.visible.objects[FrameItems::slot(item)]});
    const LineFrame line_frame{frame_.view.camera, frame_.view.options.line_path, frame_.results.line_depth_texture};
    frame_.device.lines.draw(line_frame, {look, reads_.edges->crease_rad, line_items}, frame_.scene.edges);
}

}  // namespace hw
