#include "hatchway/render/opaque_faces.hpp"

#include <algorithm>

namespace hw {
namespace {

/// Pieces that are asked about: small enough that what is half hidden is half left out, large enough that questions
/// stay cheaper than shading.
constexpr std::uint32_t kAskedTriangles = 32;

std::vector<SurfaceItem> surface_items_of(const Frame& frame, const FaceCall& call, const VisibleSet& visible)
{
    std::vector<SurfaceItem> surface_items;
    surface_items.reserve(call.items.size());
    for (const DrawItem& item : call.items) {
        const VisibleObject& object = visible.objects[FrameItems::slot(item)];
        surface_items.push_back(
            {&item, &object, choose_maps(frame.scene.input.objects[object.object].maps, *call.named_maps)});
    }
    return surface_items;
}

/// What a style cuts out by itself, depth alone cannot know.
bool has_plain_depth(const Frame& frame, const FaceCall& call)
{
    return !frame.device.programs.discards(call.program);
}

void lay_depth(const Frame& frame, const FaceCall& call)
{
    if (has_plain_depth(frame, call))
        frame.faces().draw_depth({}, surface_items_of(frame, call, frame.view.visible), frame.view.visible.ranges);
}

PipelineState state_after_depth(const Frame& frame, const FaceCall& call)
{
    if (!has_plain_depth(frame, call)) return {};
    return {.depth_test = DepthTest::equal, .writes_depth = false};
}

/// With one sample the software renderer ends hidden fragments by itself, but not what lies at equal depth; a GPU does
/// so always.
bool asks_what_is_hidden(const Frame& frame)
{
    const FrameOptions& options = frame.view.options;
    return options.skips_hidden && (options.samples > 1 || frame.view.is_deep) &&
           frame.device.context.device().is_software;
}

/// What of the visible set has the last word in some sample: it is at the depth that the picture holds, and nothing
/// that is drawn after it is, too. So however many faces lie at one place, each sample is shaded about once.
VisibleSet ask_what_is_seen(const Frame& frame)
{
    const VisibleSet pieces = in_pieces(frame.view.visible, kAskedTriangles);
    std::vector<std::uint8_t> is_asked(pieces.objects.size(), 0);
    const PipelineState at_equal_depth{.depth_test = DepthTest::equal, .writes_depth = false, .takes_once = true};
    const std::vector<FaceCall>& calls = frame.results.opaque_faces;
    for (auto call = calls.rbegin(); call != calls.rend(); ++call) {
        if (!has_plain_depth(frame, *call)) continue;
        std::vector<SurfaceItem> items = surface_items_of(frame, *call, pieces);
        std::reverse(items.begin(), items.end());
        const auto asked = [&](const SurfaceItem& item) -> std::uint8_t& {
            return is_asked[FrameItems::slot(*item.item)];
        };
        std::erase_if(items, [&](const SurfaceItem& item) { return asked(item) != 0; });
        for (const SurfaceItem& item : items) asked(item) = 1;
        frame.faces().draw_depth(at_equal_depth, items, pieces.ranges, &frame.device.queries);
    }
    std::vector<std::uint8_t> is_seen(pieces.ranges.size(), 1);
    for (std::size_t slot = 0; slot < pieces.objects.size(); ++slot) {
        const std::uint32_t first = pieces.objects[slot].first_range;
        for (std::uint32_t i = first; is_asked[slot] != 0 && i < first + pieces.objects[slot].range_count; ++i)
            is_seen[i] = frame.device.queries.has_passed(i) ? 1 : 0;
    }
    return only_marked(pieces, is_seen);
}

}  // namespace

void draw_faces(const Frame& frame, const FaceCall& call, const PipelineState& state, Hidden hidden)
{
    const VisibleSet& visible =
        hidden == Hidden::left_out && frame.results.seen ? *frame.results.seen : frame.view.visible;
    const bool has_baked = call.needs->lightmap && frame.scene.lightmap.has_light();
    const std::uint32_t shadow = call.needs->shadow == ShadowNeed::main_light ? frame.scene.shadow.texture() : 0;
    frame.faces().draw({.program = call.program,
                        .uniforms = &call.uniforms,
                        .state = state,
                        .features = frame.scene.light_features | (shadow != 0 ? surface_feature::kShadow : 0) |
                                    (frame.view.camera.is_orthographic() ? surface_feature::kParallel : 0),
                        .time_s = frame.view.camera.time_s,
                        .shadow_texture = shadow,
                        .streams = call.needs->streams,
                        .lightmap = has_baked ? &frame.scene.lightmap : nullptr},
                       surface_items_of(frame, call, visible), visible.ranges);
}

void draw_faces_depth_first(const Frame& frame, const FaceCall& call)
{
    lay_depth(frame, call);
    draw_faces(frame, call, state_after_depth(frame, call));
}

void draw_faces_in_scene(const Frame& frame, const FaceCall& call)
{
    std::vector<SurfaceItem> scene;
    for (const DrawItem& item : frame.whole().opaque)
        scene.push_back({&item, &frame.view.visible.objects[FrameItems::slot(item)], {}});
    frame.faces().draw_depth({}, scene, frame.view.visible.ranges);
    draw_faces(frame, call, {.depth_test = DepthTest::less_equal});
}

void draw_opaque_faces(const Frame& frame)
{
    frame.view.picture.bind();
    for (const FaceCall& call : frame.results.opaque_faces) lay_depth(frame, call);
    if (asks_what_is_hidden(frame)) frame.results.seen = ask_what_is_seen(frame);
    for (const FaceCall& call : frame.results.opaque_faces)
        draw_faces(frame, call, state_after_depth(frame, call), Hidden::left_out);
    frame.device.state.apply({});
}

void lay_line_depth(const Frame& frame)
{
    GpuTarget& target =
        frame.device.pool.take({.size_px = frame.view.camera.size_px, .colours = {}, .has_depth_texture = true});
    target.bind();
    target.clear_depth();
    const FaceOffset& offset = frame.view.options.line_offset;
    const PipelineState state{.writes_colour = false, .offset_factor = offset.factor, .offset_units = offset.units};
    for (const FaceCall& call : frame.results.opaque_faces) {
        if (has_plain_depth(frame, call))
            frame.faces().draw_depth(state, surface_items_of(frame, call, frame.view.visible),
                                     frame.view.visible.ranges);
        else
            draw_faces(frame, call, state);
    }
    frame.results.line_depth_texture = target.depth().id();
    frame.view.picture.bind();
    frame.device.state.apply({});
}

}  // namespace hw
