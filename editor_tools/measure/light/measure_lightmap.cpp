// Time against error of baked light: every pass of a bake is one point of the curve. Errors are against closed forms,
// and where light bounces in a furnished room against the same bake of many more samples and another seed. Closed dark
// rooms count leaks.
#include <fmt/format.h>

#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/world/light/bake.hpp"
#include "measure/light/light_error.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

constexpr std::uint32_t kReferenceFactor = 8;  // samples of the converged reference, times those measured
constexpr std::uint32_t kLeakSamples = 64;

struct LightmapMeasureArguments {
    std::uint32_t samples = bake_options(BakeQuality::final).samples;
    MeasureResult result;
};

struct LightRow {
    std::uint32_t samples = 0;
    std::uint32_t luxels = 0;
    double seconds = 0.0;
    LightError error;
};

std::vector<LightRow> rows_of(const LightCase& light_case, std::uint32_t samples)
{
    const bool has_reference = static_cast<bool>(light_case.reference);
    BakeOptions options{.luxels_per_m = light_case.luxels_per_m, .samples = kReferenceFactor * samples, .seed = 1};
    Lightmap converged;
    if (!has_reference) converged = bake_lightmap(light_case.scene, light_case.sources, options);
    options.samples = samples;
    options.seed = 0;  // no sample that is judged is in the reference
    std::vector<LightRow> rows;
    bake_lightmap(light_case.scene, light_case.sources, options, [&](const BakeState& state) {
        const LightError error = has_reference ? light_error(state.lightmap, light_case)
                                               : light_difference(state.lightmap, converged, light_case);
        rows.push_back({state.samples, state.luxels, state.seconds, error});
    });
    return rows;
}

JsonValue measure_cases(std::uint32_t samples)
{
    JsonValue json = JsonValue::array();
    print_line(fmt::format("{:<20}{:>9}{:>9}{:>10}{:>10}{:>10}{:>10}{:>10}", "case", "samples", "luxels", "seconds",
                           "RMS %", "worst %", "local p95", "bias %"));
    for (const LightCase& light_case : light_cases())
        for (const LightRow& row : rows_of(light_case, samples)) {
            print_line(fmt::format("{:<20}{:>9}{:>9}{:>10.3f}{:>10.3f}{:>10.3f}{:>10.3f}{:>10.3f}", light_case.name,
                                   row.samples, row.luxels, row.seconds, 100.0 * row.error.rms, 100.0 * row.error.worst,
                                   100.0 * row.error.local_p95, 100.0 * row.error.bias));
            json.push(JsonValue::object()
                          .set("case", light_case.name)
                          .set("luxels_per_m", light_case.luxels_per_m)
                          .set("samples", row.samples)
                          .set("luxels", row.luxels)
                          .set("seconds", row.seconds)
                          .set("rms", row.error.rms)
                          .set("worst_of_mean", row.error.worst)
                          .set("local_p95", row.error.local_p95)
                          .set("bias", row.error.bias));
        }
    return json;
}

JsonValue measure_leaks()
{
    JsonValue json = JsonValue::array();
    print_lines(fmt::format("\n{:<36}{:>10}{:>8}{:>8}{:>15}\n", "closed room, walls of 0.05 m", "luxels/m", "seen",
                            "leaked", "brightest lux"));
    for (const DarkRoom& room : dark_rooms())
        for (const double density : {1.0, 2.0, 4.0, 8.0}) {
            const Lightmap lightmap =
                bake_lightmap(room.scene, room.sources, {.luxels_per_m = density, .samples = kLeakSamples});
            const LeakCount count = count_leaks(lightmap, room);
            print_line(fmt::format("{:<36}{:>10}{:>8}{:>8}{:>15.3g}", room.name, density, count.seen, count.leaked,
                                   count.brightest_lux));
            json.push(JsonValue::object()
                          .set("room", room.name)
                          .set("luxels_per_m", density)
                          .set("seen", count.seen)
                          .set("leaked", count.leaked)
                          .set("brightest_lux", count.brightest_lux));
        }
    return json;
}

void measure_lightmap(const LightmapMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, {});
    JsonValue rows = measure_cases(arguments.samples);
    JsonValue leaks = measure_leaks();
    arguments.result.write(JsonValue::object().set("rows", std::move(rows)).set("leaks", std::move(leaks)));
}

}  // namespace

void add_measure_lightmap(CommandLine measure)
{
    auto arguments = std::make_shared<LightmapMeasureArguments>();
    CommandLine command = measure.add_subcommand(
        "lightmap", "Seconds and error of baked light against closed forms, over samples; leaks into closed rooms");
    command.add_option("--samples", arguments->samples, "Of each luxel in the last pass; those of final quality")
        .option_text("N")
        .check(whole_number_in(8, 65536));
    arguments->result.add_to(command);
    command.callback([arguments] { measure_lightmap(*arguments); });
}

}  // namespace hw
