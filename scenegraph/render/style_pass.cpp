#include "hatchway/render/style_pass.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hatchway/core/error.hpp"
#include "hatchway/render/opaque_faces.hpp"

namespace hw {
namespace {

TextureFormat texture_format(PixelFormat format)
{
    static constexpr std::array kFormats{TextureFormat::r8,      TextureFormat::rg8,    TextureFormat::rgba8,
                                         TextureFormat::rgba16f, TextureFormat::r32f,   TextureFormat::rgba32f,
                                         TextureFormat::r32ui,   TextureFormat::rg32ui, TextureFormat::rgba32ui};
    return kFormats[static_cast<std::size_t>(format)];
}

TargetColour target_colour(const TargetOutput& output)
{
    static constexpr std::array kWraps{WrapMode::clamp, WrapMode::repeat, WrapMode::mirrored_repeat};
    const bool is_unfiltered = output.format >= PixelFormat::r32f || output.filter == PixelFilter::nearest;
    return {texture_format(output.format), is_unfiltered ? FilterMode::nearest : FilterMode::linear,
            kWraps[static_cast<std::size_t>(output.wrap)]};
}

Images images_of(const GpuTarget& target, const TargetDesc& desc)
{
    Images images;
    for (std::size_t i = 0; i < desc.outputs.size(); ++i)
        images.add({target.colour(static_cast<int>(i)).id(), target.desc().size_px, desc.outputs[i].format});
    return images;
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

Image StylePass::image(const ImageKey& key, std::size_t output) const
{
    const auto found = frame_.results.images.find(key);
    const bool is_needed =
        std::find(drawer_.needs.images.begin(), drawer_.needs.images.end(), key) != drawer_.needs.images.end();
    if (is_needed && found != frame_.results.images.end()) return found->second[output];
    frame_.device.tell_once(drawer_.who + " reads the image \"" + key.pass +
                            "\", which its needs do not name or nobody made");
    return {};
}

DepthRange StylePass::depth_range(const ImageKey& key) const
{
    const auto found = frame_.scene.images.find(key);
    return found == frame_.scene.images.end() ? DepthRange() : depth_range_of(found->second, frame_.scene.input, view_);
}

GpuTarget* StylePass::transient(const TargetDesc& target, bool has_depth)
{
    const float scale = target.scale > 0.01f ? std::min(target.scale, 4.0f) : 0.01f;  // NaN is small, too
    const glm::vec2 size = glm::vec2(frame_.view.camera.size_px) * scale;
    GpuTargetDesc desc{.size_px = glm::max(glm::ivec2(glm::ceil(size)), glm::ivec2(1)), .has_depth = has_depth};
    for (const TargetOutput& output : target.outputs) desc.colours.push_back(target_colour(output));
    try {
        if (target.outputs.empty() || target.outputs.size() > kMaxTargetOutputs)
            throw Error({.what = "a pass into " + std::to_string(target.outputs.size()) + " outputs",
                         .expected = "1 to " + std::to_string(kMaxTargetOutputs)});
        GpuTarget& made = frame_.device.pool.take(desc);
        ++frame_.results.transient_targets;
        made.bind();
        frame_.device.state.apply({});
        // All is cleared: filters look around.
        frame_.device.state.set_scissor({});
        for (std::size_t i = 0; i < target.outputs.size(); ++i)
            made.clear_colour(static_cast<int>(i), target.outputs[i].clear);
        made.clear_depth();
        if (desc.size_px == frame_.view.camera.size_px) frame_.device.state.set_scissor(frame_.view.scissor);
        return &made;
    } catch (const Error& error) {
        frame_.device.tell_once(error.what());
        return nullptr;
    }
}

void StylePass::return_to_picture() const
{
    frame_.view.picture.bind();
    frame_.device.state.set_scissor(frame_.view.scissor);
}

Images StylePass::render(const TargetDesc& target, Program program, const Uniforms& uniforms, Items items)
{
    if (frame_.device.programs.surface(program, 0) == nullptr) return {};
    GpuTarget* made = transient(target, target.depth != TargetDepth::none);
    if (made == nullptr) return {};
    const FaceCall call = call_of(program, uniforms, items);
    if (target.depth == TargetDepth::own) draw_faces_depth_first(frame_, call);
    if (target.depth == TargetDepth::scene) draw_faces_in_scene(frame_, call);
    if (target.depth == TargetDepth::none) draw_faces(frame_, call, {.depth_test = DepthTest::off});
    return_to_picture();
    return images_of(*made, target);
}

Images StylePass::filter(const TargetDesc& target, Program program, const Uniforms& uniforms)
{
    const LinkedProgram* linked = frame_.device.programs.full_screen(program);
    if (linked == nullptr) return {};
    remark_unheard(program, uniforms);
    GpuTarget* made = transient(target, false);
    if (made == nullptr) return {};
    draw_full_screen(frame_.device, linked->gpu, uniforms);
    return_to_picture();
    return images_of(*made, target);
}

void StylePass::remark_unheard(Program program, const Uniforms& uniforms) const
{
    if (!frame_.view.options.is_rehearsal) return;
    for (const Uniforms::Entry& entry : uniforms.entries())
        if (!frame_.device.programs.is_named(program, entry.name.substr(0, entry.name.find('['))))
            frame_.device.tell_once(drawer_.who + " sets \"" + entry.name +
                                    "\", a uniform that none of its shaders has");
}

FaceCall StylePass::call_of(Program program, const Uniforms& uniforms, Items items) const
{
    remark_unheard(program, uniforms);
    return {program, uniforms, of_this_frame(items), &drawer_.needs, &drawer_.maps};
}

std::vector<DrawItem> StylePass::of_this_frame(Items items) const
{
    std::vector<DrawItem> known;
    for (const DrawItem& item : items)
        if (frame_.view.plan.items.has_made(item)) known.push_back(item);
    if (known.size() < items.size())
        frame_.device.tell_once(drawer_.who + " draws items that are not of this frame: left out");
    return known;
}

void StylePass::surfaces(Program program, const Uniforms& uniforms, Items items)
{
    if (stage_ == PassStage::images || stage_ == PassStage::lines) return;
    FaceCall call = call_of(program, uniforms, items);
    if (stage_ == PassStage::base)
        frame_.results.opaque_faces.push_back(std::move(call));
    else
        draw_faces(frame_, call, picture_state(stage_), Hidden::left_out);
}

void StylePass::lines(const LineLook& look, Items items)
{
    draw_lines({}, look, items);
}

void StylePass::lines(Program pen, const Uniforms& uniforms, const LineLook& look, Items items)
{
    if (frame_.device.programs.line(pen, 0) == nullptr) return;
    remark_unheard(pen, uniforms);
    draw_lines({pen, &uniforms}, look, items);
}

void StylePass::cover(Program program, const Uniforms& uniforms)
{
    const LinkedProgram* linked = frame_.device.programs.full_screen(program);
    if (linked == nullptr || stage_ != PassStage::lines) return;
    remark_unheard(program, uniforms);
    draw_full_screen(frame_.device, linked->gpu, uniforms, Blending::over);
}

void StylePass::draw_lines(const LinePen& pen, const LineLook& look, Items items)
{
    if (stage_ == PassStage::images || !drawer_.needs.edges) return;
    const std::vector<DrawItem> known = of_this_frame(items);
    std::vector<LineItem> line_items;
    for (const DrawItem& item : known)
        line_items.push_back({&item, &frame_.view.visible.objects[FrameItems::slot(item)]});
    const LineFrame line_frame{frame_.view.camera, frame_.view.options.line_path, frame_.results.line_depth_texture};
    frame_.device.lines.draw(line_frame, {look, drawer_.needs.edges->crease_rad, line_items, pen}, frame_.scene.edges);
}

}  // namespace hw
