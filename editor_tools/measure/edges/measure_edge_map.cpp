// The edge map against the exact visible lines: each operator on each format of its image, over a sweep of thresholds;
// what it costs, the widths it draws, what turning the picture changes, and scenes that it is known to fail on. Beside
// it the lines of the meshes as the device draws them, judged in the same way.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "measure/edges/edge_cases.hpp"
#include "measure/edges/edge_drawing.hpp"
#include "measure/edges/edge_error.hpp"
#include "measure/lines/line_style.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct EdgeMapArguments {
    std::vector<std::filesystem::path> files;
    int views = 3;
    std::string size = "1400x900";
    std::vector<std::string> operators{"second", "diagonal", "c1", "c1_three_passes", "ids", "ids_2011", "object"};
    std::filesystem::path pictures;
    MeasureResult result;
};

/// One way to make an edge map.
struct Variant {
    const char* name;  ///< Of the operator; "object" is the lines of the meshes.
    const char* format = "";
    const char* normal = "";  ///< Empty: its image is that of numbers of triangles.

    bool is_of_meshes() const { return std::string_view(name).starts_with("object"); }
    bool is_of_ids() const { return std::string_view(name).starts_with("ids"); }
    ImageKey key(double width_px = 1.0) const
    {
        ImageKey key{"edge_map", {{"operator", std::string(name)}, {"width_px", width_px}}};
        if (is_of_ids()) return key;
        key.params["format"] = std::string(format);
        key.params["normal"] = std::string(normal);
        return key;
    }
    ImageKey source() const
    {
        if (is_of_ids()) return {"triangle_ids", {{"planes", std::string_view(name) == "ids"}}};
        return {"normal_depth", {{"format", std::string(format)}, {"normal", std::string(normal)}}};
    }
    /// Whether it marks edges as whole ones: the papers' operators need a threshold.
    bool is_without_threshold() const { return std::string_view(name) == "second" || is_of_ids() || is_of_meshes(); }
    bool is_default() const
    {
        return std::string_view(name) == "second" && std::string_view(format) == "rgba32f" &&
               std::string_view(normal) == "face";
    }
    std::string text() const { return *format == 0 ? name : fmt::format("{} {}", name, format); }
};
/// Ours first. The paper's is the diagonal operator on bytes with interpolated normals.
constexpr std::array<Variant, 12> kVariants{{{"second", "rgba32f", "face"},
                                             {"second", "rgba16f", "face"},
                                             {"second", "rgba8", "face"},
                                             {"second", "rgba32f", "geometric"},
                                             {"diagonal", "rgba8", "geometric"},
                                             {"diagonal", "rgba32f", "geometric"},
                                             {"c1", "rgba8", "geometric"},
                                             {"c1_three_passes", "rgba8", "geometric"},
                                             {"c1", "rgba32f", "geometric"},
                                             {"ids"},
                                             {"ids_2011"},
                                             {"object"}}};
constexpr std::array kThresholds{0.02, 0.05, 0.1, 0.25, 0.5, 0.75, 0.95};
constexpr std::size_t kDefaultThreshold = 3;
constexpr std::array kWidthsPx{1.0, 2.0, 4.0, 8.0};

/// What is told of one variant in one file.
struct Row {
    std::string model;
    Variant variant{};
    int views = 0;
    std::array<EdgeError, kThresholds.size()> errors;
    double images_s = 0.0;   ///< Mean of the views, the image of normals and depths included.
    double source_s = 0.0;   ///< That image alone.
    double prepare_s = 0.0;  ///< Of the lines of the meshes: what is made once of each.
    double turned_unlike = 0.0;
    double turned_marks = 0.0;
    std::array<std::vector<float>, kWidthsPx.size()> widths;

    /// The threshold at which profiles have the best harmonic mean of precision and recall; the default where edges are
    /// whole ones.
    std::size_t told_threshold() const
    {
        if (variant.is_without_threshold()) return kDefaultThreshold;
        const auto worth = [&](std::size_t i) {
            const double p = errors[i].profile_precision(), r = errors[i].recall(EdgeKind::profile);
            return p > 0.0 && r > 0.0 ? 2.0 * p * r / (p + r) : 0.0;
        };
        std::size_t best = 0;
        for (std::size_t i = 1; i < kThresholds.size(); ++i)
            if (worth(i) > worth(best)) best = i;
        return best;
    }
};

/// The same lines of meshes that change, so that all that is prepared is made in each frame.
Row made_anew(Row row)
{
    row.variant.name = "object, made anew";
    row.images_s += row.prepare_s;
    return row;
}

double quantile(std::vector<float> values, double share)
{
    if (values.empty()) return measure::kNoValue;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

JsonValue error_json(const EdgeError& error, double threshold)
{
    return JsonValue::object()
        .set("threshold", threshold)
        .set("profile_recall", error.recall(EdgeKind::profile))
        .set("profile_precision", error.profile_precision())
        .set("profile_missed", 1.0 - error.recall(EdgeKind::profile))
        .set("profile_extra", 1.0 - error.profile_precision())
        .set("inner_recall", error.recall(EdgeKind::inner))
        .set("inner_precision", error.inner_precision())
        .set("flush_recall", error.recall(EdgeKind::flush))
        .set("chamfer_px", error.chamfer_px())
        .set("false_share", error.false_share());
}

JsonValue named(JsonValue json, const Row& row)
{
    json.set("model", row.model).set("variant", row.variant.text()).set("operator", row.variant.name);
    if (*row.variant.normal == 0) return json.set("format", JsonValue()).set("normal", JsonValue());
    return json.set("format", row.variant.format).set("normal", row.variant.normal);
}

JsonValue row_json(const Row& row, double megapixels)
{
    const std::size_t told = row.told_threshold();
    const EdgeError& error = row.errors[told];
    JsonValue json = named(error_json(error, kThresholds[told]), row);
    const auto length = [&](EdgeKind kind) { return error.wanted_px[static_cast<std::size_t>(kind)]; };
    json.set("views", row.views).set("profile_px", length(EdgeKind::profile)).set("inner_px", length(EdgeKind::inner));
    json.set("flush_px", length(EdgeKind::flush));
    json.set("ms", 1000.0 * row.images_s);
    json.set("ms_per_megapixel", 1000.0 * row.images_s / megapixels);
    const double edge_s = row.variant.is_of_meshes() ? measure::kNoValue : row.images_s - row.source_s;
    json.set("edge_ms_per_megapixel", 1000.0 * edge_s / megapixels);
    json.set("unlike_when_turned", measure::share_of(row.turned_unlike, row.turned_marks));
    for (std::size_t i = 0; i < kWidthsPx.size(); ++i) {
        json.set(fmt::format("width_{}_median", kWidthsPx[i]), quantile(row.widths[i], 0.5));
        json.set(fmt::format("width_{}_p5", kWidthsPx[i]), quantile(row.widths[i], 0.05));
    }
    return json;
}

std::string row_text(const Row& row, double megapixels)
{
    const std::size_t told = row.told_threshold();
    const EdgeError& e = row.errors[told];
    return fmt::format(
        "{:<22} {:<23} {:<9} at {:<4}  profile recall {:6.2f} % precision {:6.2f} %  inner {:6.2f} % {:6.2f} %  "
        "flush {:6.2f} %  chamfer {:5.2f} px  turned {:5.2f} %  {:6.1f} ms/Mpx\n",
        row.model, row.variant.text(), row.variant.normal, kThresholds[told], 100.0 * e.recall(EdgeKind::profile),
        100.0 * e.profile_precision(), 100.0 * e.recall(EdgeKind::inner), 100.0 * e.inner_precision(),
        100.0 * e.recall(EdgeKind::flush), e.chamfer_px(),
        100.0 * measure::share_of(row.turned_unlike, row.turned_marks), 1000.0 * row.images_s / megapixels);
}

/// Right profiles grey, right inner edges light grey, wrong marks red, missed lines blue.
void write_judged(const std::filesystem::path& file, glm::ivec2 size, const std::vector<EdgeVerdict>& verdicts)
{
    constexpr std::array<std::array<std::uint8_t, 3>, 5> kColours{
        {{255, 255, 255}, {120, 120, 120}, {190, 190, 190}, {220, 0, 0}, {0, 0, 255}}};
    Pixels picture{size.x, size.y, 3, {}};
    for (const EdgeVerdict verdict : verdicts) {
        const auto& colour = kColours[static_cast<std::size_t>(verdict)];
        picture.bytes.insert(picture.bytes.end(), colour.begin(), colour.end());
    }
    write_png(file, picture);
}

/// Adds what differs between a map and the one of the turned picture.
void add_turned(Row& row, const Pixels& map, const Pixels& of_turned)
{
    const Pixels other = turned(map);
    for (std::size_t i = 0; i < other.bytes.size(); i += 3)
        for (std::size_t channel = 0; channel < 2; ++channel) {
            const int a = other.bytes[i + channel], b = of_turned.bytes[i + channel];
            if (std::min(a, b) < 128) ++row.turned_marks;
            if (std::min(a, b) < 128 && std::abs(a - b) > 64) ++row.turned_unlike;
        }
}

/// Lines of the meshes lie on both sides of an outline, so they count where no object is, too.
Pixels everywhere(glm::ivec2 size)
{
    return {size.x, size.y, 3, std::vector<std::uint8_t>(std::size_t{3} * size.x * size.y, 255)};
}

class Measurement {
 public:
    Measurement(const EdgeMapArguments& arguments, Context& context)
        : arguments_(arguments), context_(context), size_(parse_size(arguments.size))
    {
        for (const Variant& variant : kVariants)
            if (std::find(arguments.operators.begin(), arguments.operators.end(), variant.name) !=
                arguments.operators.end())
                variants_.push_back(variant);
    }

    const std::vector<Variant>& variants() const { return variants_; }

    std::vector<Row> rows_of(const std::filesystem::path& file)
    {
        const std::unique_ptr<Style> style = line_style(plugins_, "measure edge-map");
        const ExactLines lines(file, {"lines", style.get()});
        EdgeDrawing drawing(context_, plugins_, lines.scene(), lines.world().chunks);
        const auto cameras = lines.cameras(arguments_.views, static_cast<double>(size_.x) / size_.y);
        std::vector<Row> rows;
        for (const Variant& variant : variants_)
            rows.push_back({.model = file.stem().string(),
                            .variant = variant,
                            .views = static_cast<int>(cameras.size()),
                            .prepare_s = variant.is_of_meshes() ? lines.prepare_s() : 0.0});
        for (std::size_t i = 0; i < cameras.size(); ++i) {
            if (cameras[i].orthographic_height_m)
                throw Error(
                    {.what = "a camera in parallel projection", .file = file.string(), .expected = "perspective"});
            const View view = camera_view(cameras[i], size_, lines.scene().bounds_world);
            const std::vector<WantedEdge> wanted = wanted_edges(lines, cameras[i], size_);
            const EdgeJudge judge(drawing.draw(view, {"object_ids", {}}), wanted);
            const EdgeJudge judge_of_meshes(everywhere(size_), wanted);
            sources_s_.clear();
            for (Row& row : rows) add_view(row, drawing, view, row.variant.is_of_meshes() ? judge_of_meshes : judge, i);
        }
        return rows;
    }

    JsonValue case_json(const EdgeCase& blind, const Variant& variant)
    {
        EdgeDrawing drawing(context_, plugins_, blind.scene);
        const View view = camera_view(blind.camera, size_, blind.scene.bounds_world);
        const EdgeJudge judge(variant.is_of_meshes() ? everywhere(size_) : drawing.draw(view, {"object_ids", {}}),
                              blind.wanted(size_));
        const double threshold = kThresholds[kDefaultThreshold];
        const EdgeError error = judge.judge(drawn(drawing, view, variant), threshold);
        print_line(fmt::format("{:<46} {:<23} flush {:6.2f} %  profile {:6.2f} %  false pixels {:7.4f} %", blind.name,
                               variant.text(), 100.0 * error.recall(EdgeKind::flush),
                               100.0 * error.recall(EdgeKind::profile), 100.0 * error.false_share()));
        return error_json(error, threshold).set("case", blind.name).set("variant", variant.text());
    }

    static Pixels drawn(EdgeDrawing& drawing, const View& view, const Variant& variant, double* seconds = nullptr)
    {
        return variant.is_of_meshes() ? drawing.object_lines(view, seconds)
                                      : drawing.draw(view, variant.key(), seconds);
    }

    double megapixels() const { return 1e-6 * size_.x * size_.y; }

 private:
    void add_view(Row& row, EdgeDrawing& drawing, const View& view, const EdgeJudge& judge, std::size_t number)
    {
        double images_s = 0.0;
        const Pixels map = drawn(drawing, view, row.variant, &images_s);
        row.images_s += images_s / row.views;
        if (!row.variant.is_of_meshes()) row.source_s += source_s(drawing, view, row.variant) / row.views;
        std::vector<EdgeVerdict> verdicts;
        for (std::size_t i = 0; i < kThresholds.size(); ++i)
            row.errors[i].add(judge.judge(map, kThresholds[i], i == kDefaultThreshold ? &verdicts : nullptr));
        add_turned(row, map, drawn(drawing, turned(view), row.variant));
        for (std::size_t i = 0; row.variant.is_default() && i < kWidthsPx.size(); ++i) {
            const auto ratios = judge.width_ratios(drawing.draw(view, row.variant.key(kWidthsPx[i])), kWidthsPx[i]);
            row.widths[i].insert(row.widths[i].end(), ratios.begin(), ratios.end());
        }
        if (arguments_.pictures.empty()) return;
        write_judged(arguments_.pictures / fmt::format("{}_{}_{}_{}_view{}.png", row.model, row.variant.name,
                                                       row.variant.format, row.variant.normal, number),
                     size_, verdicts);
    }

    /// Each image of a view once.
    double source_s(EdgeDrawing& drawing, const View& view, const Variant& variant)
    {
        const auto [known, is_new] = sources_s_.try_emplace(variant.source(), 0.0);
        if (is_new) drawing.draw(view, known->first, &known->second);
        return known->second;
    }

    const EdgeMapArguments& arguments_;
    Context& context_;
    PluginRegistry plugins_;
    glm::ivec2 size_;
    std::vector<Variant> variants_;
    std::map<ImageKey, double> sources_s_;  // of the view that is drawn
};

void measure_edge_map(const EdgeMapArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    if (!arguments.pictures.empty()) make_folder(arguments.pictures);
    const auto context = make_headless_context();
    require_fits(parse_size(arguments.size), context->device());
    Measurement measurement(arguments, *context);
    JsonValue cases = JsonValue::array(), rows = JsonValue::array(), curve = JsonValue::array();
    for (const EdgeCase& blind : edge_cases())
        for (const Variant& variant : measurement.variants()) cases.push(measurement.case_json(blind, variant));
    Progress progress("Measuring edge maps", arguments.files.size());
    for (const auto& file : arguments.files) {
        for (const Row& row : measurement.rows_of(file)) {
            print_lines(row_text(row, measurement.megapixels()));
            rows.push(row_json(row, measurement.megapixels()));
            if (row.variant.is_of_meshes()) rows.push(row_json(made_anew(row), measurement.megapixels()));
            for (std::size_t i = 0; i < kThresholds.size(); ++i)
                curve.push(named(error_json(row.errors[i], kThresholds[i]), row));
        }
        progress.advance();
    }
    arguments.result.write(JsonValue::object()
                               .set("size", arguments.size)
                               .set("device", context->device().renderer)
                               .set("rows", std::move(rows))
                               .set("curve", std::move(curve))
                               .set("cases", std::move(cases)));
}

}  // namespace

void add_measure_edge_map(CommandLine measure)
{
    auto arguments = std::make_shared<EdgeMapArguments>();
    CommandLine command = measure.add_subcommand(
        "edge-map", "Edge maps against the exact visible lines, and scenes that they are known to fail on");
    command.add_option("FILES", arguments->files, "Levels or models; without one, the known cases alone")
        .option_text("MODEL|LEVEL...");
    command.add_option("--views", arguments->views, "Views of each: its cameras, else around it; 3")
        .option_text("N")
        .check(whole_number_in(1, 1'000));
    command
        .add_option("--operators", arguments->operators,
                    "Which; second,diagonal,c1,c1_three_passes,ids,ids_2011,object")
        .check(one_of(EdgeMapArguments().operators))
        .delimiter(',');
    command.add_option("--size", arguments->size, "Size of the pictures, 1400x900").option_text("WxH");
    command
        .add_option("--pictures", arguments->pictures,
                    "A folder for judged maps: right edges grey, wrong ones red, missed lines blue")
        .option_text("DIR");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_edge_map(*arguments); });
}

}  // namespace hw
