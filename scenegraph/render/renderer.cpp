#include "hatchway/render/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "hatchway/core/budget.hpp"
#include "hatchway/core/error.hpp"
#include "hatchway/render/frame_cost.hpp"
#include "hatchway/render/frame_phases.hpp"
#include "hatchway/render/mirror_views.hpp"
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

GpuTargetDesc picture_desc(glm::ivec2 size_px, int samples)
{
    return {.size_px = size_px, .colours = {{TextureFormat::srgb8_alpha8}}, .samples = samples};
}

PixelRect pixels_of(const PictureWindow& window, glm::ivec2 size_px)
{
    const glm::ivec2 low(glm::floor((window.min * 0.5 + 0.5) * glm::dvec2(size_px)));
    const glm::ivec2 high(glm::ceil((window.max * 0.5 + 0.5) * glm::dvec2(size_px)));
    return {low, high - low};
}

bool has_changing_presence(const Frame& frame)
{
    return std::ranges::any_of(frame.view.visible.objects, [&](const VisibleObject& visible) {
        const StyledObject& look = frame.scene.input.objects[visible.object];
        return look.over != kNone && changes_after(look.presence, frame.view.camera.time_s);
    });
}

/// What the views of one frame share.
struct FrameRun {
    FrameOptions options;
    const glm::dvec3 viewer_world;
    FrameStats stats;
    PhaseClock clock;
    double layers = 0.0;  ///< Of all views until now.
};

/// `shown`: an image in place of the picture, or null.
void draw_phases(const Frame& frame, FrameRun& run, const ImageKey* shown)
{
    draw_products(frame);
    run.clock.end_phase(run.stats.products_ms);
    frame.device.state.set_scissor(frame.view.scissor);
    draw_images(frame);
    run.clock.end_phase(run.stats.images_ms);
    draw_surfaces(frame);
    draw_reflections(frame);
    run.clock.end_phase(run.stats.surfaces_ms);
    draw_lines(frame);
    run.clock.end_phase(run.stats.lines_ms);
    draw_blended(frame);
    run.clock.end_phase(run.stats.surfaces_ms);
    if (shown != nullptr) show_image(frame, *shown);
}

/// What a view of a frame shows: the camera's, or that of a mirror.
struct Sight {
    View camera;
    const Mirror* mirror = nullptr;  ///< Null: the camera itself.
    PictureWindow window = {};
    int mirrors_left = 0;  ///< How many more a line of sight is followed through.
};

}  // namespace

struct Renderer::State {
    State(Context& context, ImageReader read_image) : device(context, std::move(read_image)) {}

    GpuTarget& picture_of(glm::ivec2 size_px);
    /// Draws a view, those of its mirrors first, into `shown`, which has one sample.
    void draw_view(FrameRun& run, const Sight& sight, GpuTarget& shown);
    std::vector<Reflection> draw_mirrors(FrameRun& run, const Sight& sight, const VisibleSet& visible);
    void count_view(FrameRun& run, const Frame& frame, bool is_camera);
    void count(FrameStats& stats);
    /// Adds to FrameRun::layers; throws hw::Error where it is too much. A graphics card draws in no time what takes a
    /// software renderer for ever.
    FrameCost add_cost(FrameRun& run, const VisibleSet& visible, std::size_t image_count, glm::ivec2 size_px) const;

    RenderDevice device;
    GpuTarget picture;
    std::unique_ptr<LoadedScene> scene;
    std::map<ImageKey, Images> images_of_frame;  ///< Of the camera's view of the last: good until the next.
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
    const bool has_mirrors = !input.mirrors.empty();
    const bool is_software = state_->device.context.device().is_software;
    state_->scene = std::make_unique<LoadedScene>(std::move(input), state_->device.line_indices,
                                                  is_software ? FilterMode::linear_in_level : FilterMode::trilinear);
    if (has_mirrors) state_->scene->mirror_program = programs.cache(programs.engine_folder()).surface("mirror.frag");
}

void Renderer::set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects)
{
    HW_ASSERT(objects.size() == state_->scene->input.objects.size());
    state_->scene->set_looks(std::move(styles), std::move(objects));
}

GpuTarget& Renderer::State::picture_of(glm::ivec2 size_px)
{
    if (picture.desc().size_px != size_px || picture.is_empty()) picture = GpuTarget(picture_desc(size_px, 1));
    return picture;
}

void Renderer::State::count_view(FrameRun& run, const Frame& frame, bool is_camera)
{
    FrameStats& stats = run.stats;
    if (is_camera) {
        stats.leaves_visible = frame.view.visible.leaves_visible;
        stats.objects_visible = static_cast<int>(frame.view.visible.objects.size());
    }
    stats.faces_drawn += frame.view.visible.triangle_count();
    stats.images_made += static_cast<int>(frame.results.images.size());
    stats.transient_targets += frame.results.transient_targets;
    stats.changes_with_time |= frame.results.reads_clock || has_changing_presence(frame);
}

void Renderer::State::count(FrameStats& stats)
{
    const GpuCounters& counters = device.state.counters();
    const LineCounters line_counters = device.lines.take_counters();
    stats.leaves_total = scene->input.visibility == nullptr ? 0 : scene->input.visibility->tree.leaf_count;
    stats.objects_total = static_cast<int>(scene->input.scene->objects.size());
    stats.triangles = counters.triangles;
    stats.lines = line_counters.lines;
    stats.draw_calls = counters.draw_calls;
    stats.state_changes = counters.state_changes;
    stats.program_switches = counters.program_switches;
    stats.silhouette_extractions = line_counters.silhouette_extractions;
    stats.silhouette_edges = line_counters.silhouette_edges;
    stats.changes_with_time |= line_counters.changes_with_time;
    stats.edge_tables_built = scene->edges.line_meshes_built();
    stats.adjacencies_built = scene->edges.surfaces_built();
    stats.lightmaps_uploaded = scene->lightmap.uploaded_count();
    stats.hatch_streams_built = scene->gpu.hatch_streams_built();
    stats.shadow_maps_drawn = scene->shadow.drawn_count();
    stats.programs_compiled = device.programs.compiled_count();
}

FrameCost Renderer::State::add_cost(FrameRun& run, const VisibleSet& visible, std::size_t image_count,
                                    glm::ivec2 size_px) const
{
    if (!device.context.device().is_software) return {};
    const FrameCost cost = frame_cost(*scene, visible, image_count, size_px);
    run.layers += cost.face_layers + cost.line_layers;
    Budget().require(Cost::layers, static_cast<std::uint64_t>(run.layers), "", "");
    return cost;
}

std::vector<Reflection> Renderer::State::draw_mirrors(FrameRun& run, const Sight& sight, const VisibleSet& visible)
{
    std::vector<Reflection> reflections;
    if (sight.mirrors_left == 0) return reflections;
    for (const MirrorInView& seen : mirrors_in(scene->input, visible, sight.camera, sight.window)) {
        if (run.stats.mirror_views >= kMostMirrorViews) {
            device.warn_once(fmt::format("mirrors show each other so often that only {} of their views are drawn",
                                         kMostMirrorViews));
            break;
        }
        ++run.stats.mirror_views;
        GpuTarget& shown = device.pool.take(picture_desc(sight.camera.size_px, 1));
        const std::size_t taken = device.pool.taken_count();
        const Box& bounds = scene->input.scene->bounds_world;
        draw_view(run,
                  {reflected_view(sight.camera, seen.plane, seen.window, bounds), seen.mirror, seen.window,
                   sight.mirrors_left - 1},
                  shown);
        device.pool.free_since(taken);
        reflections.push_back({seen.mirror, {shown.colour().id(), shown.desc().size_px, PixelFormat::rgba8}});
    }
    return reflections;
}

void Renderer::State::draw_view(FrameRun& run, const Sight& sight, GpuTarget& shown)
{
    const bool is_camera = sight.mirror == nullptr;
    FrameOptions& options = run.options;
    const ImageKey* shown_image = is_camera && options.shown_image ? &*options.shown_image : nullptr;
    VisibleSet visible;
    find_visible({.scene = scene->input.scene,
                  .chunks = scene->input.chunks,
                  .mesh_bounds = scene->mesh_bounds,
                  .visibility = options.use_pvs ? scene->input.visibility : nullptr,
                  .left_out = scene->repeats,
                  .mirror = sight.mirror,
                  .window = sight.window},
                 sight.camera, visible);
    FramePlan plan = plan_frame(scene->input, visible);
    std::vector<WantedImage> images = plan_images(*scene, plan, shown_image);
    const FrameCost cost = add_cost(run, visible, images.size(), sight.camera.size_px);
    if (cost.wants_one_sample() && options.samples > 1) {
        device.warn_once(
            fmt::format("faces lie over each other so often that pictures have one sample for each pixel, not {}",
                        options.samples));
        options.samples = 1;
    }
    run.clock.end_phase(run.stats.visibility_ms);
    FrameResults results{.reflections = draw_mirrors(run, sight, visible)};
    const int samples = options.samples;
    GpuTarget& target = samples > 1 ? device.pool.take(picture_desc(sight.camera.size_px, samples)) : shown;
    FrameView view{.camera = sight.camera,
                   .viewer_world = run.viewer_world,
                   .options = options,
                   .picture = target,
                   .visible = std::move(visible),
                   .plan = std::move(plan),
                   .images = std::move(images),
                   .scissor = {},
                   .is_deep = cost.is_deep()};
    if (!is_camera) view.scissor = pixels_of(sight.window, sight.camera.size_px);
    const Frame frame{view, *scene, device, results};
    draw_phases(frame, run, shown_image);
    if (samples > 1) target.resolve_into(shown);
    device.state.set_scissor({});
    run.clock.end_phase(run.stats.resolve_ms);
    count_view(run, frame, is_camera);
    if (is_camera) images_of_frame = std::move(results.images);
}

FrameStats Renderer::draw(const View& camera, const FrameOptions& wanted)
{
    HW_ASSERT(state_->scene != nullptr && camera.size_px.x > 0 && camera.size_px.y > 0);
    RenderDevice& device = state_->device;
    LoadedScene& scene = *state_->scene;
    FrameRun run{wanted, camera.eye_world, {}, PhaseClock(wanted.is_timed)};
    run.options.samples = std::min(wanted.samples, device.context.device().max_samples);
    device.state.forget();
    device.state.reset_counters();
    device.is_rehearsal = wanted.is_rehearsal;

    if (wanted.shown_image) scene.require_image(*wanted.shown_image);
    GpuTarget& picture = state_->picture_of(camera.size_px);
    state_->draw_view(run, {.camera = camera, .mirrors_left = scene.input.mirror_depth}, picture);
    picture.bind();
    device.overlay.draw(wanted.overlay, camera.size_px, camera.px_scale, TargetColours::linear);
    run.clock.end_phase(run.stats.resolve_ms);

    device.pool.end_frame();
    state_->count(run.stats);
    run.stats.total_ms = run.clock.total_ms();
    return run.stats;
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
    const auto found = state_->images_of_frame.find(key);
    const Image image = found == state_->images_of_frame.end() ? Image() : found->second[output];
    if (!image.is_valid()) return {};
    return read_texture(image.id, image.size_px, is_whole_number(image.format));
}

void Renderer::present(const Overlay& overlay, float px_scale)
{
    const glm::ivec2 size_px = state_->device.context.framebuffer_size_px();
    if (size_px.x <= 0 || size_px.y <= 0) return;
    state_->device.state.forget();
    if (state_->picture.is_empty()) {
        const GpuTarget& paper = state_->picture_of(size_px);
        paper.bind();
        paper.clear(glm::vec4(1.0f));
    }
    state_->picture.show_in_window(size_px);
    bind_window(size_px);
    state_->device.state.set_srgb_targets(false);
    state_->device.overlay.draw(overlay, size_px, px_scale, TargetColours::as_stored);
}

}  // namespace hw
