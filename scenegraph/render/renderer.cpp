#include "hatchway/render/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "hatchway/core/budget.hpp"
#include "hatchway/core/error.hpp"
#include "hatchway/render/frame_cost.hpp"
#include "hatchway/render/frame_phases.hpp"
#include "hatchway/render/products/engine_images.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw {
namespace {

using Clock = std::chrono::steady_clock;

/// Measures the phases of a frame one after the other.
class PhaseClock {
 public:
    explicit PhaseClock(bool waits) : waits_(waits), start_(Clock::now()), last_(start_) {}
    void end_phase(double& milliseconds)
    {
        if (waits_) finish_device();
        const Clock::time_point now = Clock::now();
        milliseconds += std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
    }
    double total_ms() const { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

 private:
    bool waits_;
    Clock::time_point start_;
    Clock::time_point last_;
};

bool has_changing_presence(const Frame& frame)
{
    return std::ranges::any_of(frame.view.visible.objects, [&](const VisibleObject& visible) {
        const StyledObject& look = frame.scene.input.objects[visible.object];
        return look.over != kNone && changes_after(look.presence, frame.view.camera.time_s);
    });
}

}  // namespace

struct Renderer::State {
    State(Context& context, ImageReader read_image) : device(context, std::move(read_image)) {}

    GpuTarget& target_of(glm::ivec2 size_px, int samples);
    void resolve(const View& view, const FrameOptions& options);
    void count(FrameStats& stats, const Frame& frame);
    /// Throws hw::Error where it is too much. A graphics card draws in no time what takes a software renderer for ever.
    FrameCost cost_of(const VisibleSet& visible, std::size_t image_count, glm::ivec2 size_px) const;

    RenderDevice device;
    GpuTarget picture;
    GpuTarget sampled;  ///< Where multisampled frames are drawn.
    std::unique_ptr<LoadedScene> scene;
    std::map<ImageKey, Images> images;  ///< Of the last frame: good until the next.
};

Renderer::Renderer(Context& context, ImageReader read_image)
    : state_(std::make_unique<State>(context, std::move(read_image)))
{
}
Renderer::~Renderer() = default;

ProgramCache& Renderer::program_cache(const std::filesystem::path& style_folder)
{
    return state_->device.programs.cache(style_folder);
}

void Renderer::reload_shaders()
{
    state_->device.programs.reload();
}

void Renderer::set_visibility(const Visibility* visibility)
{
    if (state_->scene) state_->scene->input.visibility = visibility;
}

void Renderer::load(SceneInput input)
{
    HW_ASSERT(input.scene != nullptr && input.objects.size() == input.scene->objects.size());
    HW_ASSERT(input.chunks.empty() || input.chunks.size() == input.scene->meshes.size());
    ProgramStore& programs = state_->device.programs;
    input.image_passes =
        with_engine_images(std::move(input.image_passes), programs.cache(programs.engine_folder()), *input.scene);
    const bool is_software = state_->device.context.device().is_software;
    state_->scene = std::make_unique<LoadedScene>(std::move(input), state_->device.line_indices,
                                                  is_software ? FilterMode::linear_in_level : FilterMode::trilinear);
}

void Renderer::set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects)
{
    HW_ASSERT(objects.size() == state_->scene->input.objects.size());
    state_->scene->set_looks(std::move(styles), std::move(objects));
}

/// The target that a frame is drawn into, of that size.
GpuTarget& Renderer::State::target_of(glm::ivec2 size_px, int samples)
{
    if (picture.desc().size_px != size_px || picture.is_empty())
        picture = GpuTarget({.size_px = size_px, .colours = {{TextureFormat::srgb8_alpha8}}});
    if (samples <= 1) return picture;
    if (sampled.is_empty() || sampled.desc().size_px != size_px || sampled.desc().samples != samples)
        sampled = GpuTarget({.size_px = size_px, .colours = {{TextureFormat::srgb8_alpha8}}, .samples = samples});
    return sampled;
}

void Renderer::State::resolve(const View& view, const FrameOptions& options)
{
    if (options.samples > 1) sampled.resolve_into(picture);
    picture.bind();
    device.overlay.draw(options.overlay, view.size_px, view.px_scale, TargetColours::linear);
}

void Renderer::State::count(FrameStats& stats, const Frame& frame)
{
    const GpuCounters& counters = device.state.counters();
    const LineCounters line_counters = device.lines.take_counters();
    stats.leaves_visible = frame.view.visible.leaves_visible;
    stats.leaves_total = scene->input.visibility == nullptr ? 0 : scene->input.visibility->tree.leaf_count;
    stats.objects_visible = static_cast<int>(frame.view.visible.objects.size());
    stats.objects_total = static_cast<int>(scene->input.scene->objects.size());
    stats.faces_drawn = frame.view.visible.triangle_count();
    stats.triangles = counters.triangles;
    stats.lines = line_counters.lines;
    stats.draw_calls = counters.draw_calls;
    stats.state_changes = counters.state_changes;
    stats.program_switches = counters.program_switches;
    stats.silhouette_extractions = line_counters.silhouette_extractions;
    stats.silhouette_edges = line_counters.silhouette_edges;
    stats.images_made = static_cast<int>(frame.results.images.size());
    stats.transient_targets = frame.results.transient_targets;
    stats.changes_with_time =
        frame.results.reads_clock || line_counters.changes_with_time || has_changing_presence(frame);
    stats.edge_tables_built = scene->edges.line_meshes_built();
    stats.adjacencies_built = scene->edges.surfaces_built();
    stats.lightmaps_uploaded = scene->lightmap.uploaded_count();
    stats.hatch_streams_built = scene->gpu.hatch_streams_built();
    stats.shadow_maps_drawn = scene->shadow.drawn_count();
    stats.programs_compiled = device.programs.compiled_count();
}

FrameCost Renderer::State::cost_of(const VisibleSet& visible, std::size_t image_count, glm::ivec2 size_px) const
{
    if (!device.context.device().is_software) return {};
    const FrameCost cost = frame_cost(*scene, visible, image_count, size_px);
    Budget().require(Cost::layers, static_cast<std::uint64_t>(cost.face_layers + cost.line_layers), "", "");
    return cost;
}

FrameStats Renderer::draw(const View& camera, const FrameOptions& wanted)
{
    HW_ASSERT(state_->scene != nullptr && camera.size_px.x > 0 && camera.size_px.y > 0);
    RenderDevice& device = state_->device;
    FrameOptions options = wanted;
    options.samples = std::min(wanted.samples, device.context.device().max_samples);
    LoadedScene& scene = *state_->scene;
    FrameStats stats;
    PhaseClock clock(options.is_timed);
    device.state.forget();
    device.state.reset_counters();
    device.is_rehearsal = options.is_rehearsal;

    if (options.shown_image) scene.require_image(*options.shown_image);
    VisibleSet visible;
    find_visible({.scene = scene.input.scene,
                  .chunks = scene.input.chunks,
                  .mesh_bounds = scene.mesh_bounds,
                  .visibility = options.use_pvs ? scene.input.visibility : nullptr,
                  .left_out = scene.repeats},
                 camera, visible);
    FramePlan plan = plan_frame(scene.input, visible);
    std::vector<WantedImage> images = plan_images(scene, plan, options.shown_image ? &*options.shown_image : nullptr);
    const FrameCost cost = state_->cost_of(visible, images.size(), camera.size_px);
    if (cost.wants_one_sample() && options.samples > 1) {
        device.warn_once(
            fmt::format("faces lie over each other so often that pictures have one sample for each pixel, not {}",
                        options.samples));
        options.samples = 1;
    }
    FrameView view{camera,
                   options,
                   state_->target_of(camera.size_px, options.samples),
                   std::move(visible),
                   std::move(plan),
                   std::move(images),
                   cost.is_deep()};
    FrameResults results;
    const Frame frame{view, scene, device, results};
    clock.end_phase(stats.visibility_ms);

    draw_products(frame);
    clock.end_phase(stats.products_ms);
    draw_images(frame);
    clock.end_phase(stats.images_ms);
    draw_surfaces(frame);
    clock.end_phase(stats.surfaces_ms);
    draw_lines(frame);
    clock.end_phase(stats.lines_ms);
    draw_blended(frame);
    clock.end_phase(stats.surfaces_ms);
    if (options.shown_image) show_image(frame, *options.shown_image);
    state_->resolve(camera, options);
    clock.end_phase(stats.resolve_ms);

    device.pool.end_frame();
    state_->images = results.images;
    state_->count(stats, frame);
    stats.total_ms = clock.total_ms();
    return stats;
}

std::vector<std::string> Renderer::remarks() const
{
    return {state_->device.told.begin(), state_->device.told.end()};
}

std::vector<ProgramText> Renderer::style_shaders() const
{
    return state_->device.programs.style_shaders();
}

Pixels Renderer::read_picture()
{
    return state_->picture.read_rgb();
}

std::vector<glm::uvec4> Renderer::read_image(const ImageKey& key, std::size_t output)
{
    const auto found = state_->images.find(key);
    const Image image = found == state_->images.end() ? Image() : found->second[output];
    if (!image.is_valid()) return {};
    return read_texture(image.id, image.size_px, is_whole_number(image.format));
}

void Renderer::present(const Overlay& overlay, float px_scale)
{
    const glm::ivec2 size_px = state_->device.context.framebuffer_size_px();
    if (size_px.x <= 0 || size_px.y <= 0) return;
    state_->device.state.forget();
    if (state_->picture.is_empty()) {
        const GpuTarget& paper = state_->target_of(size_px, 1);
        paper.bind();
        paper.clear(glm::vec4(1.0f));
    }
    state_->picture.show_in_window(size_px);
    bind_window(size_px);
    state_->device.state.set_srgb_targets(false);
    state_->device.overlay.draw(overlay, size_px, px_scale, TargetColours::as_stored);
}

}  // namespace hw
