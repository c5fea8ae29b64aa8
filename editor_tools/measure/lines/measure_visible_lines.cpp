// The exact visible lines against brute force: a ray for every pixel of every edge. What the far policy thins away is
// told beside what is missed. And what they cost, from a scene as it was imported and from one made ready.
#include <fmt/format.h>

#include <array>

#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/render/view/line_camera.hpp"
#include "measure/lines/exact_lines.hpp"
#include "measure/lines/line_style.hpp"
#include "measure/lines/ray_judge.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/no_value.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

constexpr double kFaintestPx = 0.25;  // what is thinner leaves too little ink to count as drawn

struct VisibleLinesArguments {
    std::vector<std::filesystem::path> files;
    int views = 4;
    std::string size = "1400x900";
    std::filesystem::path pictures;
    MeasureResult result;
};

struct Row {
    std::string model;
    int views = 0;
    double prepare_s = 0.0;
    double warm_s = 0.0;  ///< Of a view, mean.
    RayVerdict verdict;

    double share_of_visible(double px) const
    {
        return verdict.visible_px > 0.0 ? px / verdict.visible_px : measure::kNoValue;
    }
    double share_of_found(double px) const
    {
        return verdict.found_px > 0.0 ? px / verdict.found_px : measure::kNoValue;
    }
    double unjudged() const
    {
        const double all_px = verdict.found_px + verdict.unjudged_px;
        return all_px > 0.0 ? verdict.unjudged_px / all_px : measure::kNoValue;
    }
};

JudgedLine judged(std::vector<glm::dvec2> points_px, bool is_closed, bool is_intersection)
{
    if (is_closed) points_px.push_back(points_px.front());
    return {std::move(points_px), is_intersection};
}

/// Lines that were found in grey, missed ones in blue, thinned ones in orange, and those that no edge explains in red.
void write_judged(const std::filesystem::path& file, glm::ivec2 size, const std::vector<std::uint8_t>& judged)
{
    constexpr std::array<std::array<std::uint8_t, 3>, 5> kColours{
        {{255, 255, 255}, {190, 190, 190}, {0, 0, 255}, {240, 160, 0}, {220, 0, 0}}};
    Pixels picture{size.x, size.y, 3, {}};
    for (const std::uint8_t pixel : judged)
        picture.bytes.insert(picture.bytes.end(), kColours[pixel].begin(), kColours[pixel].end());
    write_png(file, picture);
}

void judge_view(ExactLines& lines, const RayJudge& judge, const CameraPlace& camera, glm::ivec2 size,
                const std::filesystem::path& picture, Row& row)
{
    std::vector<JudgedLine> found, drawn;
    double seconds = 0.0;
    for (const VisibleLine& line : lines.find(camera, size, &seconds))
        found.push_back(judged(line.points_px, line.is_closed, line.line_class == LineClass::intersection));
    for (const VectorLine& line : lines.drawn(camera, size))
        if (line.width_px >= kFaintestPx) drawn.push_back(judged(line.points_px, line.is_closed, false));
    const LineCamera place = line_camera(camera, camera_view(camera, size, lines.scene().bounds_world));
    const JudgeCamera judge_camera{place.eye_world, place.target_world, place.fov_rad,
                                   place.size_px,   place.near_m,       place.roll_rad};
    std::vector<std::uint8_t> pixels;
    row.verdict.add(judge.judge(judge_camera, found, drawn, picture.empty() ? nullptr : &pixels));
    if (!picture.empty()) write_judged(picture, size, pixels);
    row.warm_s += seconds / row.views;
}

Row measure_file(const std::filesystem::path& file, const VisibleLinesArguments& arguments,
                 const PluginRegistry& plugins)
{
    const glm::ivec2 size = parse_size(arguments.size);
    const std::unique_ptr<Style> style = line_style(plugins, "measure visible-lines");
    ExactLines lines(file, {"lines", style.get()});
    const auto cameras = lines.cameras(arguments.views, static_cast<double>(size.x) / size.y);
    Row row{.model = file.stem().string(), .views = static_cast<int>(cameras.size()), .verdict = {}};
    row.prepare_s = lines.prepare_s();
    const RayJudge judge(lines.scene(), glm::radians(kMeasuredCreaseDeg));
    for (std::size_t view = 0; view < cameras.size(); ++view)
        judge_view(lines, judge, cameras[view], size,
                   arguments.pictures.empty() ? std::filesystem::path()
                                              : arguments.pictures / fmt::format("{}_view{}.png", row.model, view),
                   row);
    return row;
}

JsonValue row_json(const Row& row)
{
    const RayVerdict& v = row.verdict;
    JsonValue json = JsonValue::object();
    json.set("model", row.model).set("views", row.views);
    json.set("prepare_s", row.prepare_s).set("warm_s", row.warm_s).set("cold_s", row.prepare_s + row.warm_s);
    json.set("candidates_px", v.candidates_px).set("visible_px", v.visible_px).set("found_px", v.found_px);
    json.set("missed", row.share_of_visible(v.missed_px)).set("crossed", row.share_of_visible(v.crossed_px));
    json.set("thinned", row.share_of_visible(v.thinned_px));
    json.set("extra", row.share_of_found(v.extra_px)).set("noticed", row.share_of_found(v.noticed_px));
    json.set("unsure", row.share_of_found(v.unsure_px)).set("unjudged", row.unjudged());
    json.set("unjudged_px", v.unjudged_px).set("rays", v.rays);
    return json;
}

std::string row_text(const Row& row)
{
    return fmt::format(
        "{:<24} visible {:>8.0f} px  missed {:6.3f} %  crossed {:6.2f} %  thinned {:6.2f} %  extra {:6.3f} %  noticed "
        "{:5.1f} %  unsure "
        "{:5.1f} %  not judged {:5.1f} %  prepare {:>7.1f} ms  view {:>6.1f} ms\n",
        row.model, row.verdict.visible_px, 100.0 * row.share_of_visible(row.verdict.missed_px),
        100.0 * row.share_of_visible(row.verdict.crossed_px), 100.0 * row.share_of_visible(row.verdict.thinned_px),
        100.0 * row.share_of_found(row.verdict.extra_px), 100.0 * row.share_of_found(row.verdict.noticed_px),
        100.0 * row.share_of_found(row.verdict.unsure_px), 100.0 * row.unjudged(), 1000.0 * row.prepare_s,
        1000.0 * row.warm_s);
}

void measure_visible_lines(const VisibleLinesArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    if (!arguments.pictures.empty()) make_folder(arguments.pictures);
    const PluginRegistry plugins;
    Progress progress("Measuring visible lines", arguments.files.size());
    JsonValue rows = JsonValue::array();
    for (const auto& file : arguments.files) {
        const Row row = measure_file(file, arguments, plugins);
        print_lines(row_text(row));
        rows.push(row_json(row));
        progress.advance();
    }
    arguments.result.write(JsonValue::object().set("size", arguments.size).set("rows", std::move(rows)));
}

}  // namespace

void add_measure_visible_lines(CommandLine measure)
{
    auto arguments = std::make_shared<VisibleLinesArguments>();
    CommandLine command =
        measure.add_subcommand("visible-lines", "The exact visible lines against rays, and their cost");
    command.add_option("FILES", arguments->files, "Levels or models").required().option_text("MODEL|LEVEL...");
    command.add_option("--views", arguments->views, "Views of each: its cameras, else around it; 4")
        .option_text("N")
        .check(whole_number_in(1, 1'000));
    command.add_option("--size", arguments->size, "Size of the picture, 1400x900").option_text("WxH");
    command
        .add_option("--pictures", arguments->pictures,
                    "A folder for judged pictures: missed blue, thinned orange, extra red")
        .option_text("DIR");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_visible_lines(*arguments); });
}

}  // namespace hw
