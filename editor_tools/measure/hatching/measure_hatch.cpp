// Hatch maps on planes and a sphere at known angles and distances: what the picture shows across the lines, against
// lines of one width and one spacing, for our choice of the level and for what hardware and ordinary mips do.
#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "measure/hatching/hatch_probe.hpp"
#include "measure/hatching/hatch_profile.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

constexpr glm::ivec2 kSize{64, 512};  // few columns: lines lie level
constexpr glm::ivec2 kPictureSize{600, 400};
constexpr double kFovDeg = 8.0;
constexpr double kPictureFovDeg = 50.0;
constexpr double kPictureAngleDeg = 70.0;
constexpr double kPictureDistance = 4.0;
constexpr double kSteepestShare = 0.98;  // of a sphere's radius: sin of 80 degrees

struct HatchMeasureArguments {
    std::vector<double> angles{0.0, 22.5, 45.0, 60.0, 70.0, 80.0};
    std::vector<double> distances{1.1, 1.4, 2.0, 5.6, 16.0, 45.0, 90.0, 181.0, 256.0};
    std::filesystem::path pictures;
    MeasureResult result;
};

struct Row {
    LevelChoice choice;
    std::string surface;
    double angle_deg = 0.0;
    double distance = 0.0;
    double ms = 0.0;
    HatchSamples samples;
};

/// The part of a column that shows the surface no steeper than 80 degrees.
std::vector<double> judged(std::vector<double> ink, const HatchPlace& place)
{
    if (!place.is_sphere) return ink;
    const auto is_surface = [](double value) { return value > 1e-3; };
    const auto first = std::find_if(ink.begin(), ink.end(), is_surface);
    const auto last = std::find_if(ink.rbegin(), ink.rend(), is_surface).base();
    if (first >= last) return {};
    const auto margin = static_cast<std::ptrdiff_t>((1.0 - kSteepestShare) * static_cast<double>(last - first) + 8.0);
    if (last - first <= 2 * margin) return {};
    return {first + margin, last - margin};
}

Row measured(HatchProbe& probe, const HatchPlace& place, LevelChoice choice)
{
    const HatchPicture picture = probe.draw(place, choice, kSize, kFovDeg);
    Row row{choice, place.is_sphere ? "sphere" : "plane", place.angle_deg, place.distance, picture.surfaces_ms, {}};
    // One column: lines lie level, so others show the same lines again.
    add_profile(row.samples, judged(column_ink(picture.pixels, kSize.x / 2), place), {});
    return row;
}

/// Numbers of one row, or of several together. `native_contrast`: that of the map seen straight on at its own scale.
JsonValue errors_json(const HatchSamples& samples, double native_contrast)
{
    double nearest = measure::kNoValue;
    double farthest = measure::kNoValue;
    if (!samples.spacing.empty()) {
        const auto [least, most] = std::minmax_element(samples.spacing.begin(), samples.spacing.end());
        nearest = 1.0 + *least;
        farthest = 1.0 + *most;
    }
    std::vector<double> contrast = samples.contrast;
    const double contrast_p5 = [&] {
        if (contrast.empty()) return measure::kNoValue;
        const auto at = contrast.begin() + static_cast<std::ptrdiff_t>(contrast.size() / 20);
        std::nth_element(contrast.begin(), at, contrast.end());
        return *at;
    }();
    return JsonValue::object()
        .set("lines", static_cast<std::uint64_t>(samples.width.size()))
        .set("spacing_median", absolute_quantile(samples.spacing, 0.5))
        .set("spacing_p99", absolute_quantile(samples.spacing, 0.99))
        .set("spacing_nearest", nearest)
        .set("spacing_farthest", farthest)
        .set("ink_spacing_median", absolute_quantile(samples.ink_spacing, 0.5))
        .set("ink_spacing_p99", absolute_quantile(samples.ink_spacing, 0.99))
        .set("width_median", absolute_quantile(samples.width, 0.5))
        .set("tone_mean", std::abs(mean_of(samples.tone)))
        .set("tone_rms", root_mean_square(samples.tone))
        .set("contrast_kept", mean_of(samples.contrast) / native_contrast)
        .set("contrast_kept_p5", contrast_p5 / native_contrast)
        .set("moire_rms", root_mean_square(samples.low_energy));
}

std::string errors_text(const std::string& name, const HatchSamples& s, double native_contrast, double ms)
{
    const auto [least, most] = std::minmax_element(s.spacing.begin(), s.spacing.end());
    return fmt::format(
        "{:<34} spacing {:>5.1f} {:>6.1f} ({:.2f}-{:.2f})  by ink {:>5.1f} {:>6.1f}  width {:>5.1f}  tone {:.3f} "
        "{:.3f}  "
        "contrast {:.2f}  moire {:.3f}  {:.2f} ms\n",
        name, 100.0 * absolute_quantile(s.spacing, 0.5), 100.0 * absolute_quantile(s.spacing, 0.99),
        s.spacing.empty() ? measure::kNoValue : 1.0 + *least, s.spacing.empty() ? measure::kNoValue : 1.0 + *most,
        100.0 * absolute_quantile(s.ink_spacing, 0.5), 100.0 * absolute_quantile(s.ink_spacing, 0.99),
        100.0 * absolute_quantile(s.width, 0.5), std::abs(mean_of(s.tone)), root_mean_square(s.tone),
        mean_of(s.contrast) / native_contrast, root_mean_square(s.low_energy), ms);
}

std::vector<HatchPlace> places_of(const HatchMeasureArguments& arguments)
{
    std::vector<HatchPlace> places;
    for (const double distance : arguments.distances) {
        for (const double angle : arguments.angles) places.push_back({false, angle, distance});
        places.push_back({true, 0.0, distance});
    }
    return places;
}

void write_pictures(HatchProbe& probe, const std::filesystem::path& folder)
{
    for (std::size_t i = 0; i < kLevelChoices.size(); ++i) {
        std::string name(kLevelChoices[i]);
        std::replace(name.begin(), name.end(), ' ', '_');
        const HatchPlace place{false, kPictureAngleDeg, kPictureDistance};
        write_png(folder / (name + ".png"),
                  probe.draw(place, static_cast<LevelChoice>(i), kPictureSize, kPictureFovDeg).pixels);
    }
}

void measure_hatch(const HatchMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, {});
    if (!arguments.pictures.empty()) require_folder(arguments.pictures, "--pictures");
    const auto context = make_headless_context();
    HatchProbe probe(*context);
    const std::vector<HatchPlace> places = places_of(arguments);
    const double native = mean_of(measured(probe, {false, 0.0, 1.0}, LevelChoice::ours).samples.contrast);
    Progress progress("Measuring", kLevelChoices.size() * places.size());
    JsonValue rows = JsonValue::array();
    JsonValue summary = JsonValue::array();
    print_line("errors in percent: median, 99th percentile (nearest - farthest); tone: mean, RMS");
    for (std::size_t i = 0; i < kLevelChoices.size(); ++i) {
        HatchSamples all;
        double ms = 0.0;
        for (const HatchPlace& place : places) {
            const Row row = measured(probe, place, static_cast<LevelChoice>(i));
            progress.advance();
            JsonValue json = errors_json(row.samples, native);
            json.set("choice", std::string(kLevelChoices[i])).set("surface", row.surface);
            json.set("angle_deg", row.angle_deg).set("distance", row.distance).set("ms", row.ms);
            rows.push(std::move(json));
            add_samples(all, row.samples);
            ms += row.ms / static_cast<double>(places.size());
        }
        if (all.width.empty())
            throw Error({.what = std::string(kLevelChoices[i]) + ": no line of the map was seen",
                         .expected = "--distances nearer than that"});
        print_lines(errors_text(std::string(kLevelChoices[i]), all, native, ms));
        summary.push(errors_json(all, native).set("choice", std::string(kLevelChoices[i])).set("ms", ms));
    }
    if (!arguments.pictures.empty()) write_pictures(probe, arguments.pictures);
    arguments.result.write(JsonValue::object()
                               .set("device", context->device().renderer)
                               .set("summary", std::move(summary))
                               .set("rows", std::move(rows)));
}

}  // namespace

void add_measure_hatch(CommandLine measure)
{
    auto arguments = std::make_shared<HatchMeasureArguments>();
    CommandLine command = measure.add_subcommand(
        "hatch",
        "Spacing, width, tone and contrast of hatch maps on planes and a sphere: ours, hardware, ordinary mips");
    command.add_option("--angles", arguments->angles, "Of planes, degrees off the view; 0 to 85")
        .option_text("A,B,...")
        .delimiter(',')
        .check(number_in(0.0, 85.0));
    command.add_option("--distances", arguments->distances, "1: a texel covers a pixel seen straight on; 1 to 1000")
        .option_text("A,B,...")
        .delimiter(',')
        .check(number_in(1.0, 1000.0));
    command.add_option("--pictures", arguments->pictures, "An existing folder for one picture of each choice")
        .option_text("DIR");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_hatch(*arguments); });
}

}  // namespace hw
