// Two neighbouring frames at places along a path, drawn in every kind of hatching: how ink changes where the surface is
// the same. And what hatching costs: the same frames with lines, with and without it, one after the other in one run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/json/out.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/stage/map_store.hpp"
#include "hatchway/world/camera_path.hpp"
#include "hatchway/world/looks.hpp"
#include "measure/hatching/hatch_probe.hpp"
#include "measure/hatching/hatch_profile.hpp"
#include "measure/hatching/surface_motion.hpp"
#include "measure/measures.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"
#include "program/pictures/shots.hpp"

namespace hw {
namespace {

constexpr int kTries = 1500;  // places of a pair of frames; most lie at edges
constexpr const char* kUnfiltered = "unfiltered map";

struct CoherenceArguments {
    std::filesystem::path file;
    std::string path = kTour;
    int frames = 12;
    std::string size = "960x540";
    std::filesystem::path json;
};

/// One kind of hatching on everything.
struct Kind {
    std::string name;
    std::unique_ptr<Style> style;
    bool has_ink_maps = false;
    int hatch_map = kNone;  ///< Of the probe.
    bool is_cost = false;   ///< Drawn with lines, for its time alone.
    CoherenceErrors errors;
    std::vector<double> ms;
};

/// A level without visibility, all of it drawn in one kind of hatching at a time.
class InkedLevel {
 public:
    InkedLevel(Context& context, const std::filesystem::path& file)
        : renderer_(context),
          level_(read_level_with(file, {})),
          world_(open_world(level_, BakedLight::if_there)),
          looks_(resolve_looks(level_, world_->scene, kFallbackStyle))
    {
        const int fine = maps_.use(level_, MapKind::hatch, "fine", "");
        ordinary_ = ordinary_levels(*maps_.maps()[fine]);
        const int ordinary = kOrdinary;
        add_ink("hatch map", "plain", {});
        add_ink("strokes", "shaded", {});
        add_ink("tonal map", "shaded", "strokes");
        add_ink("ink map", "none", {});
        kinds_.back().has_ink_maps = true;
        add_probe("ordinary mips", LevelChoice::ordinary_mips, ordinary);
        add_probe(kUnfiltered, LevelChoice::no_mips, fine);
        for (const auto& [name, tone] : {std::pair("without hatching", "none"), std::pair("with hatch map", "plain"),
                                         std::pair("with strokes", "shaded")}) {
            add_ink(name, tone, {}, true);
            kinds_.back().is_cost = true;
        }
    }

    const Level& level() const { return level_; }
    const Scene& scene() const { return world_->scene; }
    const std::vector<MeshChunks>& chunks() const { return world_->chunks; }
    std::vector<Kind>& kinds() { return kinds_; }

    void show(const Kind& kind)
    {
        SceneInput input;
        input.scene = &world_->scene;
        input.styles = {{kind.name, kind.style.get()}};
        for (const auto& [map_kind, name] : kind.style->needs().maps)
            if (!name.value.empty())
                input.named_maps[{map_kind, name.value}] = maps_.use(level_, map_kind, name.value, "");
        for (const ObjectLook& look : looks_) {
            StyledObject object;
            object.style = 0;
            if (const auto ink = look.maps.find(MapKind::ink); kind.has_ink_maps && ink != look.maps.end())
                object.maps[MapKind::ink] = maps_.use(level_, MapKind::ink, ink->second, "/assign");
            if (kind.hatch_map != kNone) object.maps[MapKind::hatch] = kind.hatch_map;
            input.objects.push_back(std::move(object));
        }
        input.maps = maps_.maps();
        if (kind.hatch_map == kOrdinary)
            for (StyledObject& object : input.objects)
                object.maps[MapKind::hatch] = static_cast<int>(input.maps.size());
        input.maps.push_back(&ordinary_);
        input.chunks = world_->chunks;
        input.lightmap = world_->lightmap ? &*world_->lightmap : nullptr;
        input.lights = lights_of(level_, world_->scene);
        input.exposure_ev = static_cast<float>(exposure_ev_of(level_, world_->scene, input.lights));
        renderer_.load(std::move(input));
    }

    FrameStats draw(const Camera& camera, glm::ivec2 size)
    {
        const View view =
            camera_view({camera.eye_world, camera.target_world, camera.fov_deg}, size, world_->scene.bounds_world);
        return renderer_.draw(view, {.samples = 1, .use_pvs = false, .is_timed = true});
    }

    InkPicture picture(const Camera& camera, glm::ivec2 size)
    {
        draw(camera, size);
        const Pixels pixels = renderer_.read_picture();
        InkPicture ink{.width = size.x, .height = size.y, .ink = {}};
        for (int x = 0; x < size.x; ++x) columns_.push_back(column_ink(pixels, x));
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) ink.ink.push_back(static_cast<float>(columns_[x][y]));
        columns_.clear();
        return ink;
    }

 private:
    static constexpr int kOrdinary = 1 << 20;

    void add_ink(const std::string& name, const std::string& tone, const std::string& tonal, bool has_lines = false)
    {
        const StyleSource source{"measure coherence", ""};
        const Plugin& plugin = require_plugin(plugins_, "pen_and_ink", PluginKind::style, source);
        ParamSettings params;
        const auto set = [&](const char* key, ParamValue value) { params[key] = {std::move(value), key}; };
        set("tone", tone);
        set("hatch_colour", std::string("#000000"));
        if (!tonal.empty()) set("tonal", tonal);
        if (!has_lines)
            for (const char* width : {"line_width_px", "silhouette_width_px", "border_width_px", "valley_width_px",
                                      "intersection_width_px"})
                set(width, 0.0);
        Kind kind;
        kind.name = name;
        kind.style = make_style(plugin, params, source);
        kind.style->prepare(renderer_.program_cache(plugin.shader_folder));
        kinds_.push_back(std::move(kind));
    }

    void add_probe(const std::string& name, LevelChoice choice, int map)
    {
        Kind kind;
        kind.name = name;
        kind.style = make_probe_style(choice);
        kind.style->prepare(renderer_.program_cache(installation_prefix() / "share" / "hatchway" / "shaders"));
        kind.hatch_map = map;
        kinds_.push_back(std::move(kind));
    }

    Renderer renderer_;
    PluginRegistry plugins_;
    Level level_;
    std::shared_ptr<const LevelWorld> world_;
    std::vector<ObjectLook> looks_;
    MapStore maps_;
    MapLevels ordinary_;
    std::vector<Kind> kinds_;
    std::vector<std::vector<double>> columns_;
};

struct FramePair {
    Camera before;
    Camera after;
    std::vector<SeenTwice> places;
};

std::vector<FramePair> frame_pairs(const CoherenceArguments& arguments, const InkedLevel& level, glm::ivec2 size)
{
    const auto found = level.level().paths.find(arguments.path);
    if (found == level.level().paths.end())
        throw Error({.what = "--path " + arguments.path,
                     .file = arguments.file.string(),
                     .expected = "a camera path of the level"});
    const CameraPath& path = found->second;
    const SurfaceMotion motion(level.scene(), level.chunks());
    const int count = path_frame_count(path);
    std::mt19937 random(1);
    const auto within = [&](int side) { return 16.0 + (side - 32.0) * (random() / 4294967296.0); };
    std::vector<FramePair> pairs;
    for (int i = 0; i < arguments.frames; ++i) {
        const int frame = (count - 2) * (2 * i + 1) / (2 * arguments.frames);
        FramePair pair{
            camera_at(path, path_frame_time(path, frame)), camera_at(path, path_frame_time(path, frame + 1)), {}};
        for (int k = 0; k < kTries; ++k) {
            const double x = within(size.x);
            const glm::dvec2 at(x, within(size.y));
            if (const auto place = motion.seen_twice(pair.before, pair.after, size, at)) pair.places.push_back(*place);
        }
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

void measure_kind(InkedLevel& level, Kind& kind, const std::vector<FramePair>& pairs, glm::ivec2 size)
{
    level.show(kind);
    for (const FramePair& pair : pairs)
        add_coherence(kind.errors, level.picture(pair.before, size), level.picture(pair.after, size), pair.places);
}

/// All kinds of every frame before the next frame: a slow moment of the machine meets all.
void measure_costs(InkedLevel& level, const std::vector<FramePair>& pairs, glm::ivec2 size)
{
    for (const FramePair& pair : pairs)
        for (Kind& kind : level.kinds()) {
            if (!kind.is_cost) continue;
            level.show(kind);
            level.draw(pair.before, size);  // what is made on first use is no part of a frame
            double least = 1e9;
            for (int i = 0; i < 3; ++i) least = std::min(least, level.draw(pair.before, size).total_ms);
            kind.ms.push_back(least);
        }
}

JsonValue kind_row(const Kind& kind, double unfiltered_flicker)
{
    const CoherenceErrors& e = kind.errors;
    const double flicker = mean_of(e.flicker);
    print_line(fmt::format("{:<20}{:>8}{:>10.4f}{:>9.2f}{:>11.4f}{:>11.4f}{:>11.3f}{:>11.3f}", kind.name,
                           e.flicker.size(), flicker, flicker / unfiltered_flicker, absolute_quantile(e.tone, 0.99),
                           absolute_quantile(e.tone, 1.0), absolute_quantile(e.slide, 0.5),
                           absolute_quantile(e.slide, 0.95)));
    return JsonValue::object()
        .set("ink", kind.name)
        .set("places", static_cast<std::uint64_t>(e.flicker.size()))
        .set("flicker", flicker)
        .set("flicker_of_unfiltered", flicker / unfiltered_flicker)
        .set("tone_change_p99", absolute_quantile(e.tone, 0.99))
        .set("tone_change_most", absolute_quantile(e.tone, 1.0))
        .set("slide_px_median", absolute_quantile(e.slide, 0.5))
        .set("slide_px_p95", absolute_quantile(e.slide, 0.95));
}

void measure_coherence(const CoherenceArguments& arguments)
{
    const glm::ivec2 size = parse_size(arguments.size);
    require_outputs({{"--json", arguments.json}}, {arguments.file});
    const auto context = make_headless_context();
    require_fits(size, context->device());
    InkedLevel level(*context, arguments.file);
    const std::vector<FramePair> pairs = frame_pairs(arguments, level, size);
    Progress progress("Measuring", level.kinds().size());
    double unfiltered = 1e-12;
    for (Kind& kind : level.kinds()) {
        if (!kind.is_cost) measure_kind(level, kind, pairs, size);
        if (kind.name == kUnfiltered) unfiltered = std::max(mean_of(kind.errors.flicker), 1e-12);
        progress.advance();
    }
    measure_costs(level, pairs, size);
    print_line(fmt::format("{:<20}{:>8}{:>10}{:>9}{:>11}{:>11}{:>11}{:>11}", "ink", "places", "flicker", "share",
                           "tone p99", "tone most", "slide med", "slide p95"));
    JsonValue rows = JsonValue::array();
    JsonValue costs = JsonValue::array();
    double without = 0.0;
    for (const Kind& kind : level.kinds()) {
        if (!kind.is_cost) {
            rows.push(kind_row(kind, unfiltered));
            continue;
        }
        const double ms = mean_of(kind.ms);
        if (without == 0.0) without = ms;
        print_line(fmt::format("{:<20}{:>8.2f} ms{:>8.2f} x", kind.name, ms, ms / without));
        costs.push(JsonValue::object().set("ink", kind.name).set("ms", ms).set("share", ms / without));
    }
    if (arguments.json.empty()) return;
    write_json(arguments.json, JsonValue::object()
                                   .set("level", arguments.file.string())
                                   .set("path", arguments.path)
                                   .set("size", arguments.size)
                                   .set("device", context->device().renderer)
                                   .set("rows", std::move(rows))
                                   .set("costs", std::move(costs)));
}

}  // namespace

void add_measure_coherence(CommandLine measure)
{
    auto arguments = std::make_shared<CoherenceArguments>();
    CommandLine command = measure.add_subcommand(
        "coherence",
        "Flicker, change of tone and sliding of hatching from frame to frame along a path, and what hatching costs");
    command.add_option("level", arguments->file, "A level file with a camera path").required().option_text("LEVEL");
    command.add_option("--path", arguments->path, "A camera path of the level; tour").option_text("NAME");
    command.add_option("--frames", arguments->frames, "Pairs of neighbouring frames, spread evenly; 12")
        .option_text("N")
        .check(whole_number_in(1, 100'000));
    command.add_option("--size", arguments->size, "Size of the picture, 960x540").option_text("WxH");
    add_json_argument(command, arguments->json);
    command.callback([arguments] { measure_coherence(*arguments); });
}

}  // namespace hw
