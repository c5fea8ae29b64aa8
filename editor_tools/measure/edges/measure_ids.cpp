// Outlines by numbers of triangles: what each pass costs, whether the device does what the rule says, and how the edges
// meet the exact visible lines; scenes that edge maps fail on; and a fan of triangles around one edge, which makes
// lists long.
#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "measure/edges/edge_cases.hpp"
#include "measure/edges/edge_drawing.hpp"
#include "measure/edges/edge_error.hpp"
#include "measure/edges/id_reference.hpp"
#include "measure/lines/line_style.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

constexpr double kThreshold = 0.25;

struct IdsArguments {
    std::vector<std::filesystem::path> files;
    int views = 3;
    std::string size = "1400x900";
    std::vector<int> fan{16, 64, 256, 1024};
    MeasureResult result;
};

/// One way to make edges of numbers. The paper's own is vertices of 2011.
struct Variant {
    const char* name;  ///< Of the operator.
    const char* storage;

    bool is_of_2011() const { return std::string_view(name) == "ids_2011"; }
    ImageKey key() const { return {"edge_map", {{"operator", std::string(name)}, {"storage", std::string(storage)}}}; }
    ImageKey source() const { return {"triangle_ids", {{"planes", !is_of_2011()}}}; }
};
constexpr std::array<Variant, 4> kVariants{
    {{"ids", "vertices"}, {"ids", "lists"}, {"ids_2011", "vertices"}, {"ids_2011", "lists"}}};

/// Of all views: times are means, counts are sums.
struct Row {
    Variant variant{};
    double plain_s = 0.0, ids_s = 0.0, resolve_s = 0.0;
    std::size_t differing = 0;
    EdgeError error;
};

void add_times(Row& row, EdgeDrawing& drawing, const View& view, double share)
{
    double ids_s = 0.0, all_s = 0.0;
    drawing.draw(view, row.variant.source(), &ids_s);
    drawing.draw(view, row.variant.key(), &all_s);
    row.plain_s += share * drawing.plain_s(view);
    row.ids_s += share * ids_s;
    row.resolve_s += share * (all_s - ids_s);
}

/// What object-space lines take that start from nothing, as for a model that deforms.
struct ObjectLines {
    double prepare_s = 0.0;
    double find_s = 0.0;
};

JsonValue row_json(const std::string& model, std::uint64_t triangles, const Row& row, const ObjectLines& lines)
{
    const double device_s = row.plain_s + row.ids_s + row.resolve_s;
    return JsonValue::object()
        .set("model", model)
        .set("triangles", triangles)
        .set("operator", row.variant.name)
        .set("storage", row.variant.storage)
        .set("plain_ms", 1000.0 * row.plain_s)
        .set("ids_ms", 1000.0 * row.ids_s)
        .set("resolve_ms", 1000.0 * row.resolve_s)
        .set("ids_over_plain", row.ids_s / row.plain_s)
        .set("resolve_over_plain", row.resolve_s / row.plain_s)
        .set("device_fps", 1.0 / device_s)
        .set("object_fps", 1.0 / (row.plain_s + lines.prepare_s + lines.find_s))
        .set("object_prepare_ms", 1000.0 * lines.prepare_s)
        .set("object_find_ms", 1000.0 * lines.find_s)
        .set("differing_pixels", row.differing)
        .set("profile_recall", row.error.recall(EdgeKind::profile))
        .set("profile_precision", row.error.profile_precision())
        .set("profile_missed", 1.0 - row.error.recall(EdgeKind::profile))
        .set("profile_extra", 1.0 - row.error.profile_precision())
        .set("flush_recall", row.error.recall(EdgeKind::flush))
        .set("inner_recall", row.error.recall(EdgeKind::inner))
        .set("false_share", row.error.false_share())
        .set("chamfer_px", row.error.chamfer_px());
}

std::string row_text(const std::string& model, std::uint64_t triangles, const Row& row, const ObjectLines& lines)
{
    return fmt::format(
        "{:<20} {:>8} {:<8} {:<8}  plain {:6.1f} ms  ids {:6.1f} ms  resolve {:6.1f} ms  {:5.1f} fps  "
        "(object {:5.1f} fps, prepare {:7.1f} ms)  differ {}  profile recall {:6.2f} % precision {:6.2f} %  flush "
        "{:6.2f} %  "
        "false {:7.4f} %",
        model, triangles, row.variant.name, row.variant.storage, 1000.0 * row.plain_s, 1000.0 * row.ids_s,
        1000.0 * row.resolve_s, 1.0 / (row.plain_s + row.ids_s + row.resolve_s),
        1.0 / (row.plain_s + lines.prepare_s + lines.find_s), 1000.0 * lines.prepare_s, row.differing,
        100.0 * row.error.recall(EdgeKind::profile), 100.0 * row.error.profile_precision(),
        100.0 * row.error.recall(EdgeKind::flush), 100.0 * row.error.false_share());
}

class Measurement {
 public:
    Measurement(const IdsArguments& arguments, Context& context)
        : arguments_(arguments), context_(context), size_(parse_size(arguments.size))
    {
    }

    void add_file(const std::filesystem::path& file, JsonValue& rows)
    {
        const std::unique_ptr<Style> style = line_style(plugins_, "measure ids");
        const ExactLines lines(file, {"lines", style.get()});
        const IdReference reference(lines.scene());
        const auto cameras = lines.cameras(arguments_.views, static_cast<double>(size_.x) / size_.y);
        ObjectLines object{lines.prepare_s(), 0.0};
        std::vector<Row> of_file;
        for (const Variant& variant : kVariants) of_file.push_back({.variant = variant});
        EdgeDrawing drawing(context_, plugins_, lines.scene(), lines.world().chunks);
        for (const CameraPlace& camera : cameras) {
            if (camera.orthographic_height_m)
                throw Error(
                    {.what = "a camera in parallel projection", .file = file.string(), .expected = "perspective"});
            const View view = camera_view(camera, size_, lines.scene().bounds_world);
            const EdgeJudge judge(drawing.draw(view, {"object_ids", {}}), wanted_edges(lines, camera, size_));
            if (&camera == &cameras.front()) lines.find(camera, size_, &object.find_s);
            for (Row& row : of_file) {
                add_times(row, drawing, view, 1.0 / static_cast<double>(cameras.size()));
                add_errors(row, drawing, reference, view, judge);
            }
        }
        const std::uint64_t triangles = drawn_triangle_count(lines.scene());
        for (const Row& row : of_file) {
            print_line(row_text(file.stem().string(), triangles, row, object));
            rows.push(row_json(file.stem().string(), triangles, row, object));
        }
    }

    JsonValue case_json(const EdgeCase& known, const Variant& variant)
    {
        EdgeDrawing drawing(context_, plugins_, known.scene);
        const View view = camera_view(known.camera, size_, known.scene.bounds_world);
        const EdgeJudge judge(drawing.draw(view, {"object_ids", {}}), known.wanted(size_));
        Row row{.variant = variant};
        add_errors(row, drawing, IdReference(known.scene), view, judge);
        print_line(
            fmt::format("{:<46} {:<8} {:<8} flush {:6.2f} %  profile {:6.2f} %  false pixels {:7.4f} %  differ {}",
                        known.name, variant.name, variant.storage, 100.0 * row.error.recall(EdgeKind::flush),
                        100.0 * row.error.recall(EdgeKind::profile), 100.0 * row.error.false_share(), row.differing));
        return JsonValue::object()
            .set("case", known.name)
            .set("operator", variant.name)
            .set("storage", variant.storage)
            .set("flush_recall", row.error.recall(EdgeKind::flush))
            .set("profile_recall", row.error.recall(EdgeKind::profile))
            .set("false_share", row.error.false_share())
            .set("differing_pixels", row.differing);
    }

    JsonValue fan_json(int sides, const Variant& variant)
    {
        const EdgeCase fan = cylinder_fan(sides);
        EdgeDrawing drawing(context_, plugins_, fan.scene);
        const View view = camera_view(fan.camera, size_, fan.scene.bounds_world);
        Row row{.variant = variant};
        add_times(row, drawing, view, 1.0);
        print_line(fmt::format("fan of {:>5} sides  {:<8} {:<8}  ids {:6.1f} ms  resolve {:8.1f} ms", sides,
                               variant.name, variant.storage, 1000.0 * row.ids_s, 1000.0 * row.resolve_s));
        return JsonValue::object()
            .set("sides", sides)
            .set("operator", variant.name)
            .set("storage", variant.storage)
            .set("ids_ms", 1000.0 * row.ids_s)
            .set("resolve_ms", 1000.0 * row.resolve_s);
    }

 private:
    void add_errors(Row& row, EdgeDrawing& drawing, const IdReference& reference, const View& view,
                    const EdgeJudge& judge)
    {
        const Pixels map = drawing.draw(view, row.variant.key());
        row.differing += reference.unlike(map, drawing.ids(row.variant.source(), view.size_px), view,
                                          {.is_of_2011 = row.variant.is_of_2011()});
        row.error.add(judge.judge(map, kThreshold));
    }

    const IdsArguments& arguments_;
    Context& context_;
    PluginRegistry plugins_;
    glm::ivec2 size_;
};

void measure_ids(const IdsArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    const auto context = make_headless_context();
    require_fits(parse_size(arguments.size), context->device());
    Measurement measurement(arguments, *context);
    JsonValue cases = JsonValue::array(), rows = JsonValue::array(), fan = JsonValue::array();
    for (const EdgeCase& known : edge_cases())
        for (const Variant& variant : kVariants) cases.push(measurement.case_json(known, variant));
    for (const int sides : arguments.fan)
        for (const Variant& variant : kVariants)
            if (variant.is_of_2011()) fan.push(measurement.fan_json(sides, variant));
    Progress progress("Measuring outlines by triangle numbers", arguments.files.size());
    for (const auto& file : arguments.files) {
        measurement.add_file(file, rows);
        progress.advance();
    }
    arguments.result.write(JsonValue::object()
                               .set("size", arguments.size)
                               .set("device", context->device().renderer)
                               .set("rows", std::move(rows))
                               .set("cases", std::move(cases))
                               .set("fan", std::move(fan)));
}

}  // namespace

void add_measure_ids(CommandLine measure)
{
    auto arguments = std::make_shared<IdsArguments>();
    CommandLine command = measure.add_subcommand(
        "ids", "Outlines by numbers of triangles: time, error and a reference, beside the exact lines");
    command.add_option("FILES", arguments->files, "Levels or models; without one, the known cases and the fan alone")
        .option_text("MODEL|LEVEL...");
    command.add_option("--views", arguments->views, "Views of each: its cameras, else around it; 3")
        .option_text("N")
        .check(whole_number_in(1, 1'000));
    command.add_option("--size", arguments->size, "Size of the pictures, 1400x900").option_text("WxH");
    command.add_option("--fan", arguments->fan, "Sides of the fans of triangles; 16,64,256,1024")
        .option_text("N,...")
        .check(whole_number_in(3, 1500))
        .delimiter(',');
    arguments->result.add_to(command);
    command.callback([arguments] { measure_ids(*arguments); });
}

}  // namespace hw
