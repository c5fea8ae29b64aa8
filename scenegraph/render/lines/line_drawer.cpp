#include "hatchway/render/lines/line_drawer.hpp"

#include <algorithm>
#include <cmath>

#include "hatchway/render/device/presence_uniforms.hpp"
#include "hatchway/render/device/surface_drawer.hpp"
#include "hatchway/render/view/frame_block.hpp"

namespace hw {
namespace {

constexpr float kWholeFold = 1.5707963f;
constexpr std::array kFoldedClasses{LineClass::ridge, LineClass::valley, LineClass::artist};  // or silhouettes, by view
constexpr PipelineState kLineState{
    .depth_test = DepthTest::off, .writes_depth = false, .blending = Blending::over, .culling = Culling::off};

Viewpoint viewpoint_of(const View& view)
{
    if (!view.is_orthographic()) return {view.eye_world, false};
    return {view.to_viewer_world, true};
}

/// The eye, or with w 0 the direction to the viewer.
glm::vec4 eye_object(const View& view, const VisibleObject& object)
{
    const glm::mat4 object_from_relative = glm::inverse(object.relative_from_object);
    if (!view.is_orthographic()) return object_from_relative[3];
    return object_from_relative * glm::vec4(glm::vec3(glm::normalize(view.to_viewer_world)), 0.0f);
}

float width_px(const View& view, const LineLook& look, LineClass line_class)
{
    const Pen& pen = look[line_class];
    return pen.is_drawn ? std::max(pen.width_px, 0.0f) * view.px_scale : 0.0f;
}

}  // namespace

/// Lines that one draw call draws.
struct LineDrawer::Stretch {
    std::uint32_t first_line = 0;
    std::uint32_t count = 0;
    float width_px = 0.0f;
};

/// A program and what it draws of each line.
struct LineDrawer::LineProgram {
    const GpuProgram* gpu = nullptr;
    Primitive primitive = Primitive::triangles;
    int clip_from_object, relative_from_object, eye_object, fade, stroke_scale, presence_height, presence_inverted;
};

LineDrawer::LineDrawer(const DeviceInfo& device, ProgramStore& programs, GpuState& state, LineIndices& indices)
    : device_(device), programs_(programs), state_(state), indices_(indices), stream_(make_line_buffer(indices))
{
}

LinePath LineDrawer::path_for(const LineFrame& frame, const LineRun& run) const
{
    const LineLook& look = run.look;
    // Quads have the width that is asked for, with any number of samples, and need no state of their own: see
    // `measure lines`. GL_LINES are the way of 2001, for who wants it.
    const bool is_plain = look.depth_taper <= 0.0f && look.stroke.is_ruled() && !run.pen.program.is_valid();
    // A fold is as wide as a silhouette where it is one, and all GL_LINES of a call are equally wide.
    const auto is_as_wide = [&](LineClass folded) {
        return width_px(frame.view, look, folded) == width_px(frame.view, look, LineClass::silhouette);
    };
    if (frame.path != LinePath::native || !is_plain || !std::ranges::all_of(kFoldedClasses, is_as_wide))
        return LinePath::quads;
    float widest = 0.0f;
    for (const Pen& pen : look.pens) widest = std::max(widest, pen.width_px * frame.view.px_scale);
    const bool fits = widest <= device_.max_line_width_px && widest + 1.0f <= device_.max_point_size_px;
    return fits ? LinePath::native : LinePath::quads;
}

std::vector<std::uint32_t> LineDrawer::stream_silhouettes(const LineFrame& frame, const LineRun& run,
                                                          const EdgeStore& edges)
{
    std::vector<std::uint32_t> first_lines;
    vertices_.clear();
    const Viewpoint viewpoint = viewpoint_of(frame.view);
    for (const LineItem& item : run.items) {
        first_lines.push_back(static_cast<std::uint32_t>(vertices_.size() / 4));
        const Surface* surface = edges.surface(item.object->object);
        const LineMesh* lines = edges.lines(item.object->object, run.crease_rad);
        if (lines == nullptr || width_px(frame.view, run.look, LineClass::silhouette) <= 0.0f) continue;
        const std::uint64_t idle = scratch_.counters.objects_without_work;
        const Viewpoint here = in_object(viewpoint, edges.world_from_object(item.object->object));
        const auto contours = drawn_contours(*surface, here, {.crease_rad = run.crease_rad}, scratch_);
        if (scratch_.counters.objects_without_work == idle) ++counters_.silhouette_extractions;
        counters_.silhouette_edges += contours.size();
        for (const std::uint32_t edge : contours) {
            const auto ends = edge_vertices(*surface, edge);
            append_line(vertices_, {.ends = {surface->positions[ends[0]], surface->positions[ends[1]]},
                                    .line_class = LineClass::silhouette,
                                    .crowding = {lines->crowding[ends[0]], lines->crowding[ends[1]]}});
        }
    }
    first_lines.push_back(static_cast<std::uint32_t>(vertices_.size() / 4));
    indices_.reserve(first_lines.back());
    if (!vertices_.empty()) stream_.vertices.stream(std::as_bytes(std::span(vertices_)));
    return first_lines;
}

std::vector<LineDrawer::LineProgram> LineDrawer::programs_for(LinePath path, const LineRun& run,
                                                              bool has_presence) const
{
    const auto make = [](const LinkedProgram& linked, Primitive primitive) {
        const GpuProgram& gpu = linked.gpu;
        return LineProgram{.gpu = &gpu,
                           .primitive = primitive,
                           .clip_from_object = linked.at.clip_from_object,
                           .relative_from_object = linked.at.relative_from_object,
                           .eye_object = linked.gpu.location("hw_line_eye_object"),
                           .fade = gpu.location("hw_line_fade"),
                           .stroke_scale = gpu.location("hw_stroke_scale"),
                           .presence_height = linked.at.presence_height,
                           .presence_inverted = linked.at.presence_inverted};
    };
    if (run.pen.program.is_valid()) {
        const LinkedProgram* pen = programs_.line(run.pen.program, has_presence ? surface_feature::kPresence : 0);
        if (pen == nullptr) return {};
        return {make(*pen, Primitive::triangles)};
    }
    std::string presence = has_presence ? "#define HW_PRESENCE 1\n" : "";
    if (!run.look.stroke.is_ruled()) presence += "#define HW_STROKE 1\n";
    if (path == LinePath::quads)
        return {make(programs_.engine("lines/line_quad.vert", "lines/line_quad.frag", presence), Primitive::triangles)};
    const std::string round = presence + "#define HW_ROUND_POINT 1\n";
    return {make(programs_.engine("lines/line_end.vert", "lines/line_end.frag", presence), Primitive::lines),
            make(programs_.engine("lines/line_end.vert", "lines/line_end.frag", round), Primitive::points)};
}

void LineDrawer::set_look(const LineProgram& program, const LineFrame& frame, const LineRun& run)
{
    const LineLook& look = run.look;
    std::array<float, kLineClassCount> widths;
    std::array<glm::vec3, kLineClassCount> colours;
    for (int i = 0; i < kLineClassCount; ++i) {
        widths[i] = width_px(frame.view, look, static_cast<LineClass>(i));
        colours[i] = linear_from_srgb(look.pens[i].colour);
    }
    state_.use(*program.gpu);
    if (run.pen.uniforms != nullptr) set_uniforms(*program.gpu, *run.pen.uniforms, state_);
    state_.bind_texture(program.gpu->unit("hw_line_depth"), frame.depth_texture);
    GpuProgram::set(program.gpu->location("hw_line_width_px[0]"), std::span<const float>(widths));
    GpuProgram::set(program.gpu->location("hw_line_colour[0]"), std::span<const glm::vec3>(colours));
    GpuProgram::set(program.gpu->location("hw_line_taper"), glm::vec2(look.depth_taper, look.taper_from_m));
    GpuProgram::set(program.gpu->location("hw_line_fold"), glm::vec3(look.fold_weight, run.crease_rad, kWholeFold));
    GpuProgram::set(program.gpu->location("hw_line_share"), share_uniform(look.share, frame.view.time_s));
    const StrokeCharacter& stroke = look.stroke;
    GpuProgram::set(
        program.gpu->location("hw_stroke_px"),
        frame.view.px_scale * glm::vec4(stroke.wobble_px, stroke.bend_px, stroke.overshoot_px, stroke.taper_px));
    GpuProgram::set(program.gpu->location("hw_stroke_dash"),
                    glm::vec2(stroke.dash_px * frame.view.px_scale, stroke.dash_share));
}

void LineDrawer::draw(const LineFrame& frame, const LineRun& run, const EdgeStore& edges)
{
    const LineLook& look = run.look;
    const std::span<const LineItem> items = run.items;
    const LinePath path = path_for(frame, run);
    counters_.changes_with_time |= changes_after(look.share, frame.view.time_s);
    const std::vector<std::uint32_t> first_lines = stream_silhouettes(frame, run, edges);
    for (const bool with_presence : {false, true}) {
        const auto is_now = [&](const LineItem& item) {
            return (has_presence(*item.item) || varies(look.share)) == with_presence;
        };
        if (std::none_of(items.begin(), items.end(), is_now)) continue;
        for (const LineProgram& program : programs_for(path, run, with_presence)) {
            set_look(program, frame, run);
            for (std::size_t i = 0; i < items.size(); ++i) {
                const LineMesh* lines = edges.lines(items[i].object->object, run.crease_rad);
                const DrawItem& item = *items[i].item;
                if (lines == nullptr || !is_now(items[i])) continue;
                if (!shows_at_all(item, frame.view.time_s)) continue;
                draw_item(program, frame, look, items[i], *lines, lines->buffer,
                          stretches_of(*lines, frame, look, path));
                const Stretch silhouettes{first_lines[i], first_lines[i + 1] - first_lines[i],
                                          width_px(frame.view, look, LineClass::silhouette)};
                draw_item(program, frame, look, items[i], *lines, stream_, {&silhouettes, 1});
            }
        }
    }
}

std::vector<LineDrawer::Stretch> LineDrawer::stretches_of(const LineMesh& lines, const LineFrame& frame,
                                                          const LineLook& look, LinePath path)
{
    std::vector<Stretch> stretches;
    for (const LineMesh::Run& run : lines.runs) {
        float width = width_px(frame.view, look, run.line_class);
        if (std::ranges::find(kFoldedClasses, run.line_class) != kFoldedClasses.end())
            width = std::max(width, width_px(frame.view, look, LineClass::silhouette));
        if (width <= 0.0f) continue;
        const bool continues = !stretches.empty() &&
                               stretches.back().first_line + stretches.back().count == run.first_line &&
                               (path == LinePath::quads || stretches.back().width_px == width);
        if (continues)
            stretches.back().count += run.count;
        else
            stretches.push_back({run.first_line, run.count, width});
    }
    return stretches;
}

void LineDrawer::draw_item(const LineProgram& program, const LineFrame& frame, const LineLook& look,
                           const LineItem& item, const LineMesh& lines, const LineBuffer& buffer,
                           std::span<const Stretch> stretches)
{
    const bool is_empty =
        std::all_of(stretches.begin(), stretches.end(), [](const Stretch& s) { return s.count == 0; });
    if (is_empty) return;
    const View& view = frame.view;
    GpuProgram::set(program.clip_from_object, item.object->clip_from_object);
    GpuProgram::set(program.relative_from_object, item.object->relative_from_object);
    GpuProgram::set(program.eye_object, eye_object(view, *item.object));
    const float full_px = look.far.full_spacing_px * view.px_scale;
    const float window_px = look.far.is_on ? full_px / kFullSpacingInWindows : 0.0f;
    GpuProgram::set(program.fade,
                    glm::vec3(window_px, lines.crowding_window * item.object->scale, FarPolicy::kInnerGone));
    GpuProgram::set(program.stroke_scale, static_cast<float>(item.object->scale));
    set_presence(program.presence_height, program.presence_inverted, *item.item, view.time_s);
    const bool as_quads = program.primitive == Primitive::triangles;
    const std::uint32_t indices_per_line = as_quads ? 6 : 2;
    state_.bind(as_quads ? buffer.as_quads : buffer.as_ends);
    for (const Stretch& s : stretches) {
        if (program.primitive != Primitive::points) counters_.lines += s.count;
        PipelineState pipeline = kLineState;
        if (!as_quads) pipeline.line_width_px = s.width_px;
        state_.apply(pipeline);
        state_.draw_indexed(program.primitive, s.first_line * indices_per_line, s.count * indices_per_line);
    }
}

}  // namespace hw
