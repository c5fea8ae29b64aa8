// Two neighbouring frames at places along a path and at the level's cameras, drawn in every kind of hatching: how ink
// changes where the surface is the same. And what hatching costs: the same frames with lines, with and without it, one
// after the other in one run.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "measure/hatching/frame_pairs.hpp"
#include "measure/hatching/hatch_profile.hpp"
#include "measure/hatching/inked_level.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "measure/resampled_share.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"
#include "program/pictures/shots.hpp"

namespace hw {
namespace {

constexpr int kTries = 300;     // places of a pair of frames; most lie at edges
constexpr int kCostFrames = 4;  // of the path; time varies less than coherence

struct CoherenceArguments {
    std::filesystem::path file;
    std::string path = kTour;
    int frames = 48;
    std::string size = "960x540";
    std::string cost_size = "1280x720";
    MeasureResult result;
};

const CameraPath& path_of(const CoherenceArguments& arguments, const InkedLevel& level)
{
    const CameraPath* path = find_named(level.level().paths, arguments.path);
    if (path != nullptr) return *path;
    throw Error({.what = "--path " + arguments.path,
                 .file = arguments.file.string(),
                 .expected = "a camera path of the level"});
}

/// Which places a row is about.
struct Part {
    std::string path;
    bool is_curved = false;
};

/// All places of all pairs, one after the other.
struct AllPlaces {
    explicit AllPlaces(const std::vector<FramePair>& from) : pairs(from)
    {
        for (std::size_t i = 0; i < pairs.size(); ++i)
            for (const SeenTwice& place : pairs[i].places) {
                places.push_back(place);
                pair_of.push_back(i);
            }
    }
    bool is_in(const Part& part, std::size_t place) const
    {
        return pairs[pair_of[place]].path == part.path && places[place].is_curved == part.is_curved;
    }

    const std::vector<FramePair>& pairs;
    std::vector<SeenTwice> places;
    std::vector<std::size_t> pair_of;
};

/// Flicker and ink beside those of the unfiltered map, where both have marks.
void set_ratio(JsonValue& row, const Part& part, const AllPlaces& all, const std::vector<CoherenceError>& errors,
               const std::vector<CoherenceError>& unfiltered)
{
    std::map<std::size_t, std::pair<double, double>> sums;  // by pair of frames
    std::vector<double> own, other, own_ink, other_ink;
    for (std::size_t i = 0; i < all.places.size(); ++i) {
        if (!all.is_in(part, i) || errors[i].slide < 0.0 || unfiltered[i].slide < 0.0) continue;
        own.push_back(errors[i].pixel_flicker);
        other.push_back(unfiltered[i].pixel_flicker);
        sums[all.pair_of[i]].first += own.back();
        sums[all.pair_of[i]].second += other.back();
        own_ink.push_back(errors[i].ink);
        other_ink.push_back(unfiltered[i].ink);
    }
    std::vector<std::pair<double, double>> parts;
    for (const auto& [pair, sum] : sums) parts.push_back(sum);
    const measure::ShareRange range = measure::resampled_share(parts);
    row.set("common_places", std::uint64_t{own.size()}).set("common_pairs", std::uint64_t{parts.size()});
    row.set("pixel_flicker_of_unfiltered", measure::share_of(mean_of(own), mean_of(other)));
    row.set("of_unfiltered_low", range.low).set("of_unfiltered_high", range.high);
    row.set("ink_there", mean_of(own_ink)).set("unfiltered_ink_there", mean_of(other_ink));
}

/// The errors of one kind at the places of one part.
JsonValue kind_row(const std::string& name, const Part& part, const AllPlaces& all,
                   const std::vector<CoherenceError>& errors, const std::vector<CoherenceError>& unfiltered)
{
    std::vector<double> flicker, pixel_flicker, tone, slide, motion;
    for (std::size_t i = 0; i < all.places.size(); ++i) {
        if (!all.is_in(part, i)) continue;
        motion.push_back(glm::distance(all.places[i].after, all.places[i].before));
        const CoherenceError& e = errors[i];
        if (e.slide < 0.0) continue;  // blank paper does not flicker
        flicker.push_back(e.flicker);
        pixel_flicker.push_back(e.pixel_flicker);
        tone.push_back(e.tone);
        slide.push_back(e.slide);
    }
    const char* surface = part.is_curved ? "curved" : "flat";
    print_line(fmt::format("{:<10}{:<16}{:<8}{:>7}{:>7}{:>9.4f}{:>9.4f}{:>10.4f}{:>10.3f}{:>10.3f}", part.path, name,
                           surface, motion.size(), slide.size(), mean_of(flicker), mean_of(pixel_flicker),
                           absolute_quantile(tone, 0.99), absolute_quantile(slide, 0.5),
                           absolute_quantile(slide, 0.95)));
    JsonValue row = JsonValue::object();
    row.set("path", part.path).set("ink", name).set("surface", surface);
    row.set("places", std::uint64_t{motion.size()}).set("motion_px_median", absolute_quantile(motion, 0.5));
    row.set("marked_places", std::uint64_t{slide.size()});
    row.set("flicker", mean_of(flicker)).set("pixel_flicker", mean_of(pixel_flicker));
    set_ratio(row, part, all, errors, unfiltered);
    return row.set("tone_change_p99", absolute_quantile(tone, 0.99))
        .set("tone_change_most", absolute_quantile(tone, 1.0))
        .set("slide_px_median", absolute_quantile(slide, 0.5))
        .set("slide_px_p95", absolute_quantile(slide, 0.95));
}

std::vector<CoherenceError> errors_of(InkedLevel& level, const InkKind& kind, const std::vector<FramePair>& pairs,
                                      glm::ivec2 size)
{
    std::vector<CoherenceError> errors;
    level.show(kind);
    for (const FramePair& pair : pairs)
        add_coherence(errors, level.picture(pair.before, size), level.picture(pair.after, size), pair.places);
    return errors;
}

JsonValue coherence_rows(InkedLevel& level, const std::vector<FramePair>& pairs, glm::ivec2 size, Progress& progress)
{
    const AllPlaces all(pairs);
    std::map<std::string, std::vector<CoherenceError>> errors;
    for (const InkKind& kind : level.kinds()) {
        if (kind.is_cost) continue;
        errors[kind.name] = errors_of(level, kind, pairs, size);
        progress.advance();
    }
    print_line(fmt::format("{:<10}{:<16}{:<8}{:>7}{:>7}{:>9}{:>9}{:>10}{:>10}{:>10}", "path", "ink", "surface",
                           "places", "marked", "3x3", "pixels", "tone p99", "slide", "slide p95"));
    JsonValue rows = JsonValue::array();
    for (const std::string& path : {pairs.front().path, std::string(FramePair::kAtCameras)})
        for (const InkKind& kind : level.kinds())
            for (const bool is_curved : {false, true})
                if (!kind.is_cost)
                    rows.push(kind_row(kind.name, {path, is_curved}, all, errors.at(kind.name),
                                       errors.at(InkedLevel::kUnfiltered)));
    return rows;
}

/// All kinds of every frame before the next frame: a slow moment of the machine meets all. Medians of three draws.
JsonValue cost_rows(InkedLevel& level, const std::vector<FramePair>& pairs, glm::ivec2 size)
{
    JsonValue rows = JsonValue::array();
    for (const int samples : {1, 4}) {
        std::map<std::string, std::vector<double>> ms;
        for (const FramePair& pair : pairs)
            for (const InkKind& kind : level.kinds()) {
                if (!kind.is_cost) continue;
                level.show(kind);
                level.draw(pair.before, size, samples);  // what is made on first use is no part of a frame
                std::array<double, 3> draws{};
                for (double& draw : draws) draw = level.draw(pair.before, size, samples).total_ms;
                std::sort(draws.begin(), draws.end());
                ms[kind.name].push_back(draws[1]);
            }
        const double without = mean_of(ms.at("without hatching"));
        for (const auto& [name, all] : ms) {
            const double mean = mean_of(all);
            print_line(fmt::format("{:<20}{} samples{:>9.2f} ms{:>8.2f} x", name, samples, mean, mean / without));
            rows.push(JsonValue::object()
                          .set("ink", name)
                          .set("samples", samples)
                          .set("ms", mean)
                          .set("share", mean / without));
        }
    }
    return rows;
}

void refuse_none_seen(const std::vector<FramePair>& pairs)
{
    for (const FramePair& pair : pairs)
        if (!pair.places.empty()) return;
    throw Error({.what = "two neighbouring frames have no place of a smooth surface in common",
                 .expected = "a slower --path, nearer to surfaces"});
}

void measure_coherence(const CoherenceArguments& arguments)
{
    const glm::ivec2 size = parse_size(arguments.size), cost_size = parse_size(arguments.cost_size);
    require_outputs({arguments.result.output()}, {arguments.file});
    const auto context = make_headless_context();
    require_fits(size, context->device());
    require_fits(cost_size, context->device());
    InkedLevel level(*context, arguments.file);
    const CameraPath& path = path_of(arguments, level);
    std::vector<FramePair> pairs = pairs_along(path, arguments.frames);
    for (FramePair& pair : pairs_at(level.level().cameras)) pairs.push_back(std::move(pair));
    find_places(pairs, SurfaceMotion(level.scene(), level.chunks()), size, kTries);
    refuse_none_seen(pairs);
    Progress progress("Measuring", level.kinds().size());
    JsonValue rows = coherence_rows(level, pairs, size, progress);
    JsonValue costs = cost_rows(level, pairs_along(path, kCostFrames), cost_size);
    arguments.result.write(JsonValue::object()
                               .set("level", arguments.file.string())
                               .set("path", arguments.path)
                               .set("size", arguments.size)
                               .set("cost_size", arguments.cost_size)
                               .set("frames", arguments.frames)
                               .set("camera_frames", std::uint64_t{pairs.size()} - arguments.frames)
                               .set("tries", std::uint64_t{kTries} * pairs.size())
                               .set("cost_frames", kCostFrames)
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
    command.add_option("--frames", arguments->frames, "Pairs of neighbouring frames, spread evenly; 48")
        .option_text("N")
        .check(whole_number_in(1, 100'000));
    command.add_option("--size", arguments->size, "Size of the picture, 960x540").option_text("WxH");
    command.add_option("--cost-size", arguments->cost_size, "Size of the pictures that are timed, 1280x720")
        .option_text("WxH");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_coherence(*arguments); });
}

}  // namespace hw
