#include "hatchway/render/renderer.hpp"

#include <chrono>
#include <set>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/render/frame_plan.hpp"
#include "hatchway/render/loaded_scene.hpp"
#include "hatchway/render/opaque_faces.hpp"
#include "hatchway/render/overlay/overlay_drawer.hpp"
#include "hatchway/render/style_pass.hpp"
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

}  // namespace

struct Renderer::State {
    explicit State(Context& own_context)
        : context(own_context),
          programs(installation_prefix() / "share" / "hatchway" / "shaders", own_context.device().is_es),
          lines(own_context.device(), programs, gpu, line_indices),
          overlay(programs, gpu),
          no_vertices({}, nullptr)
    {
    }

    void size_targets(glm::ivec2 size_px, int samples);
    void draw_products(const FramePlan& plan, const View& view);
    void draw_images(const FramePlan& plan, FrameParts& parts, FrameStats& stats);
    void draw_surfaces(const FramePlan& plan, FrameParts& parts);
    void draw_lines(const FramePlan& plan, FrameParts& parts);
    void draw_blended(const FramePlan& plan, FrameParts& parts);
    void resolve(const View& view, const FrameOptions& options);
    FrameParts parts_of(const View& view, const FrameOptions& options, SurfaceDrawer& surfaces);
    void count(FrameStats& stats, const FrameParts& parts);
    StylePass pass_of(FrameParts& parts, int style, PassStage stage) const;
    Style& style(int index) const { return *scene->input.styles[index].style; }

    Context& context;
    GpuState gpu;
    ProgramStore programs;
    TargetPool pool;
    GpuQueries queries;
    LineIndices line_indices;
    LineDrawer lines;
    OverlayDrawer overlay;
    GpuVertexArray no_vertices;
    GpuBuffer frame_block;
    GpuTarget picture;
    GpuTarget sampled;  ///< Where multisampled frames are drawn.
    std::unique_ptr<LoadedScene> scene;
    VisibleSet visible;
    const std::map<MapKind, int> no_maps;
};

Renderer::Renderer(Context& context) : state_(std::make_unique<State>(context)) {}
Renderer::~Renderer() = default;

ProgramCache& Renderer::program_cache(const std::filesystem::path& style_folder)
{
    return state_->programs.cache(style_folder);
}

void Renderer::reload_shaders()
{
    state_->programs.reload();
}

void Renderer::load(SceneInput input)
{
    HW_ASSERT(input.scene != nullptr && input.objects.size() == input.scene->objects.size());
    HW_ASSERT(input.chunks.empty() || input.chunks.size() == input.scene->meshes.size());
    const bool is_software = state_->context.device().is_software;
    state_->scene = std::make_unique<LoadedScene>(std::move(input), state_->line_indices,
                                                  is_software ? FilterMode::linear_in_level : FilterMode::trilinear);
}

void Renderer::set_looks(std::vector<NamedStyle> styles, std::vector<StyledObject> objects)
{
    HW_ASSERT(objects.size() == state_->scene->input.objects.size());
    state_->scene->set_looks(std::move(styles), std::move(objects));
}

void Renderer::State::size_targets(glm::ivec2 size_px, int samples)
{
    const bool is_sampled = samples > 1;
    if (picture.desc().size_px != size_px || picture.is_empty())
        picture = GpuTarget({.size_px = size_px, .colours = {TextureFormat::srgb8_alpha8}});
    const bool fits = !sampled.is_empty() && sampled.desc().size_px == size_px && sampled.desc().samples == samples;
    if (is_sampled && !fits)
        sampled = GpuTarget({.size_px = size_px, .colours = {TextureFormat::srgb8_alpha8}, .samples = samples});
}

StylePass Renderer::State::pass_of(FrameParts& parts, int style_index, PassStage stage) const
{
    const Needs& needs = scene->needs[style_index];
    const StyleLight light{needs.shadow == ShadowNeed::main_light, needs.lightmap && scene->lightmap.has_light(),
                           needs.streams};
    return {parts, stage, light, scene->style_maps[style_index]};
}

void Renderer::State::draw_products(const FramePlan& plan, const View& view)
{
    for (std::size_t i = 0; i < plan.styles.size(); ++i) {
        if (plan.styles[i].is_empty()) continue;
        const Needs& needs = scene->needs[i];
        if (needs.lightmap) scene->lightmap.prepare();
        const bool is_all_baked = needs.lightmap && scene->is_all_baked;
        if (needs.shadow == ShadowNeed::main_light && !is_all_baked)
            scene->shadow.prepare(*scene->input.scene, scene->gpu, scene->light, programs, gpu);
    }
    stream_frame_block(frame_block, view, scene->light, scene->shadow.frame());
}

void Renderer::State::draw_images(const FramePlan& plan, FrameParts& parts, FrameStats& stats)
{
    std::set<ImageKey> wanted;
    for (std::size_t i = 0; i < plan.styles.size(); ++i)
        if (!plan.styles[i].is_empty()) wanted.insert(scene->needs[i].images.begin(), scene->needs[i].images.end());
    const auto needs_of = [&](const ImageKey& key) -> const Needs* {
        const auto found = scene->image_needs.find(key);
        return found == scene->image_needs.end() ? nullptr : &found->second;
    };
    const EngineImageInput input{parts.view, &visible, scene->input.scene, scene->input.objects, scene->first_triangle};
    for (const ImageKey& key : in_order_of_need(wanted, needs_of)) {
        ++stats.images_made;
        if (is_engine_image(key.pass)) {
            parts.images[key] = draw_engine_image(key.pass, input, scene->gpu, programs, gpu, pool);
            continue;
        }
        StylePass pass(parts, PassStage::images, {}, no_maps);
        parts.images[key] = scene->image_passes.at(key)->make(pass);
        gpu.apply({});
    }
    for (std::size_t i = 0; i < plan.styles.size(); ++i) {
        if (plan.styles[i].is_empty()) continue;
        std::vector<DrawItem> items = plan.styles[i].base;
        items.insert(items.end(), plan.styles[i].over.begin(), plan.styles[i].over.end());
        items.insert(items.end(), plan.styles[i].blended.begin(), plan.styles[i].blended.end());
        StylePass pass = pass_of(parts, static_cast<int>(i), PassStage::images);
        style(static_cast<int>(i)).images(pass, items);
        gpu.apply({});
    }
}

void Renderer::State::draw_surfaces(const FramePlan& plan, FrameParts& parts)
{
    parts.picture->bind();
    gpu.apply({});
    parts.picture->clear(glm::vec4(scene->light.background_linear, 1.0f));
    const auto draw = [&](PassStage stage, auto items_of) {
        for (std::size_t i = 0; i < plan.styles.size(); ++i) {
            const std::vector<DrawItem>& items = items_of(plan.styles[i]);
            if (items.empty()) continue;
            StylePass pass = pass_of(parts, static_cast<int>(i), stage);
            style(static_cast<int>(i)).surfaces(pass, Layer::opaque, items);
            gpu.apply({});
        }
    };
    draw(PassStage::base, [](const StyleItems& items) -> const std::vector<DrawItem>& { return items.base; });
    draw_opaque_faces(parts);
    draw(PassStage::over, [](const StyleItems& items) -> const std::vector<DrawItem>& { return items.over; });
}

void Renderer::State::draw_lines(const FramePlan& plan, FrameParts& parts)
{
    if (parts.has_lines) lay_line_depth(parts);
    for (std::size_t i = 0; i < plan.styles.size(); ++i) {
        std::vector<DrawItem> items = plan.styles[i].base;
        items.insert(items.end(), plan.styles[i].over.begin(), plan.styles[i].over.end());
        if (items.empty()) continue;
        StylePass pass = pass_of(parts, static_cast<int>(i), PassStage::base);
        style(static_cast<int>(i)).lines(pass, items);
        gpu.apply({});
    }
}

void Renderer::State::draw_blended(const FramePlan& plan, FrameParts& parts)
{
    for (const StyleRun& run : plan.blended_runs) {
        StylePass pass = pass_of(parts, run.style, PassStage::blended);
        style(run.style).surfaces(pass, Layer::blended, run.items);
        gpu.apply({});
        style(run.style).lines(pass, run.items);
        gpu.apply({});
    }
}

void Renderer::State::resolve(const View& view, const FrameOptions& options)
{
    if (options.samples > 1) sampled.resolve_into(picture);
    picture.bind();
    overlay.draw(options.overlay, view.size_px, view.px_scale, TargetColours::linear);
}

void Renderer::State::count(FrameStats& stats, const FrameParts& parts)
{
    const GpuCounters& counters = gpu.counters();
    const LineCounters line_counters = lines.take_counters();
    stats.leaves_visible = visible.leaves_visible;
    stats.leaves_total = scene->input.visibility == nullptr ? 0 : scene->input.visibility->tree.leaf_count;
    stats.objects_visible = static_cast<int>(visible.objects.size());
    stats.objects_total = static_cast<int>(scene->input.scene->objects.size());
    stats.triangles = counters.triangles;
    stats.lines = counters.lines;
    stats.draw_calls = counters.draw_calls;
    stats.state_changes = counters.state_changes;
    stats.program_switches = counters.program_switches;
    stats.silhouette_extractions = line_counters.silhouette_extractions;
    stats.silhouette_edges = line_counters.silhouette_edges;
    stats.transient_targets = parts.transient_targets;
    stats.edge_tables_built = scene->edges.line_meshes_built();
    stats.adjacencies_built = scene->edges.surfaces_built();
    stats.lightmaps_uploaded = scene->lightmap.uploaded_count();
    stats.hatch_streams_built = scene->gpu.hatch_streams_built();
    stats.shadow_maps_drawn = scene->shadow.drawn_count();
    stats.programs_compiled = programs.compiled_count();
}

FrameParts Renderer::State::parts_of(const View& view, const FrameOptions& options, SurfaceDrawer& surfaces)
{
    FrameParts parts;
    parts.view = &view;
    parts.visible = &visible;
    parts.looks = &scene->input.objects;
    parts.picture = options.samples > 1 ? &sampled : &picture;
    parts.state = &gpu;
    parts.programs = &programs;
    parts.pool = &pool;
    parts.surfaces = &surfaces;
    parts.lines = &lines;
    parts.edges = &scene->edges;
    parts.line_frame = {&view, options.samples, options.line_path, options.line_offset};
    parts.no_vertices = &no_vertices;
    parts.scene_features = scene->light_features;
    const auto draws_lines = [&](int style_index) {
        return style_index != kNone && scene->needs[style_index].edges.has_value();
    };
    parts.has_lines =
        std::any_of(scene->input.objects.begin(), scene->input.objects.end(),
                    [&](const StyledObject& object) { return draws_lines(object.style) || draws_lines(object.over); });
    parts.lightmap = &scene->lightmap;
    parts.shadow_texture = scene->shadow.texture();
    // With one sample the software renderer ends hidden fragments by itself; a GPU does so always.
    const bool asks = options.skips_hidden && options.samples > 1 && context.device().is_software;
    parts.queries = asks ? &queries : nullptr;
    return parts;
}

FrameStats Renderer::draw(const View& view, const FrameOptions& options)
{
    HW_ASSERT(state_->scene != nullptr && view.size_px.x > 0 && view.size_px.y > 0);
    State& state = *state_;
    LoadedScene& scene = *state.scene;
    FrameStats stats;
    PhaseClock clock(options.is_timed);
    state.gpu.forget();
    state.gpu.reset_counters();
    state.size_targets(view.size_px, options.samples);

    find_visible({.scene = scene.input.scene,
                  .chunks = scene.input.chunks,
                  .mesh_bounds = scene.mesh_bounds,
                  .visibility = options.use_pvs ? scene.input.visibility : nullptr},
                 view, state.visible);
    const FramePlan plan = plan_frame(scene.input, state.visible);
    clock.end_phase(stats.visibility_ms);

    state.draw_products(plan, view);
    clock.end_phase(stats.products_ms);

    SurfaceDrawer surfaces(state.programs, state.gpu, scene.gpu);
    FrameParts parts = state.parts_of(view, options, surfaces);
    state.draw_images(plan, parts, stats);
    clock.end_phase(stats.images_ms);

    state.draw_surfaces(plan, parts);
    clock.end_phase(stats.surfaces_ms);
    state.draw_lines(plan, parts);
    clock.end_phase(stats.lines_ms);
    state.draw_blended(plan, parts);
    clock.end_phase(stats.surfaces_ms);
    state.resolve(view, options);
    clock.end_phase(stats.resolve_ms);

    state.pool.end_frame();
    state.count(stats, parts);
    stats.total_ms = clock.total_ms();
    return stats;
}

Pixels Renderer::read_picture()
{
    return state_->picture.read_rgb();
}

void Renderer::present(const Overlay& overlay, float px_scale)
{
    const glm::ivec2 size_px = state_->context.framebuffer_size_px();
    if (size_px.x <= 0 || size_px.y <= 0) return;
    state_->gpu.forget();
    state_->picture.show_in_window(size_px);
    bind_window(size_px);
    state_->gpu.set_srgb_targets(false);
    state_->overlay.draw(overlay, size_px, px_scale, TargetColours::as_stored);
}

}  // namespace hw
