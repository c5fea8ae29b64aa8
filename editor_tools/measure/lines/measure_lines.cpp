// Draws scenes in lines alone and judges the pictures by the exact visible lines: both ways of drawing lines, 1 and 4
// samples, and a sweep of polygon offsets. Where the far policy thins a line, its wanted width is the thinned one, by
// the code that draws vectors; what it thins to less than a quarter of a pixel is neither wanted nor a leak.
#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/render/renderer.hpp"
#include "measure/lines/exact_lines.hpp"
#include "measure/lines/line_error.hpp"
#include "measure/lines/line_style.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct LinesMeasureArguments {
    std::vector<std::filesystem::path> files;
    int views = 4;
    std::string size = "1400x900";
    bool has_sweep = false;
    std::filesystem::path pictures;
    MeasureResult result;
};

/// One way of drawing.
struct Variant {
    LinePath path;
    int samples;
    FaceOffset offset;
    const char* sweep = "";  ///< The column that a sweep changes.
};

std::vector<Variant> variants_of(bool has_sweep)
{
    std::vector<Variant> variants;
    for (const LinePath path : {LinePath::quads, LinePath::native})
        for (const int samples : {1, 4}) variants.push_back({path, samples, {}});
    if (!has_sweep) return variants;
    for (const float factor : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f, 1.25f, 1.5f, 2.0f, 3.0f})
        variants.push_back({LinePath::quads, 4, {factor, FaceOffset{}.units}, "factor_swept"});
    for (const float units : {0.0f, 1.0f, 2.0f, 8.0f, 16.0f, 64.0f})
        variants.push_back({LinePath::quads, 4, {FaceOffset{}.factor, units}, "units_swept"});
    return variants;
}

const char* name_of(LinePath path)
{
    return path == LinePath::quads ? "quads" : "GL_LINES";
}

/// line_style() made ready to draw.
std::unique_ptr<Style> drawing_style(const PluginRegistry& plugins, Renderer& renderer)
{
    auto style = line_style(plugins, "measure lines");
    style->prepare(renderer.program_cache(plugins.find("pen_and_ink", PluginKind::style)->shader_folder));
    return style;
}

/// A level or model in lines, and its exact drawing.
class MeasuredScene {
 public:
    MeasuredScene(const std::filesystem::path& file, const PluginRegistry& plugins, Renderer& renderer)
        : renderer_(renderer), style_(drawing_style(plugins, renderer)), exact_(file, {"lines", style_.get()})
    {
        SceneInput input;
        input.scene = &scene();
        input.styles = {{"lines", style_.get()}};
        input.objects.assign(scene().objects.size(), StyledObject{.style = 0});
        input.chunks = exact_.world().chunks;
        input.background_srgb = glm::vec3(1.0f);
        renderer.load(std::move(input));
    }

    const Scene& scene() const { return exact_.scene(); }
    std::vector<CameraPlace> cameras(int count, double aspect) const { return exact_.cameras(count, aspect); }

    /// Adds what finding the lines costs to `seconds`.
    std::vector<WantedLine> wanted(const CameraPlace& camera, glm::ivec2 size, double& seconds)
    {
        double own_s = 0.0;
        std::vector<WantedLine> wanted;
        for (VectorLine& line : exact_.drawn(camera, size, &own_s)) {
            if (line.is_closed) line.points_px.push_back(line.points_px.front());
            wanted.push_back({std::move(line.points_px), line.width_px});
        }
        seconds += own_s;
        return wanted;
    }

    InkImage draw(const CameraPlace& camera, glm::ivec2 size, const Variant& variant)
    {
        const View view = camera_view(camera, size, scene().bounds_world);
        renderer_.draw(view, {.samples = variant.samples, .line_path = variant.path, .line_offset = variant.offset});
        return ink_of(renderer_.read_picture());
    }

 private:
    Renderer& renderer_;
    std::unique_ptr<Style> style_;
    ExactLines exact_;
};

/// The drawing in grey, ink that leaked in red, lines that are missed in blue.
void write_judged(const std::filesystem::path& file, const InkImage& drawing, const std::vector<unsigned char>& judged)
{
    Pixels picture{drawing.width, drawing.height, 3, {}};
    for (std::size_t i = 0; i < judged.size(); ++i) {
        const auto grey = static_cast<std::uint8_t>(255.0f - 127.0f * drawing.ink[i]);
        const std::array<std::array<std::uint8_t, 3>, 3> colours{{{grey, grey, grey}, {220, 0, 0}, {0, 0, 255}}};
        picture.bytes.insert(picture.bytes.end(), colours[judged[i]].begin(), colours[judged[i]].end());
    }
    write_png(file, picture);
}

struct Row {
    std::string model;
    Variant variant;
    int views = 0;
    LineError error;
    double ink = 0.0;
    double exact_s = 0.0;
};

JsonValue row_json(const Row& row)
{
    JsonValue json = JsonValue::object();
    json.set("model", row.model).set("path", name_of(row.variant.path)).set("samples", row.variant.samples);
    json.set("factor", static_cast<double>(row.variant.offset.factor));
    json.set("units", static_cast<double>(row.variant.offset.units));
    json.set("views", row.views).set("wanted_px", row.error.wanted_px);
    json.set("missed", row.error.missed_share()).set("leaked", row.error.leaked_share());
    json.set("gaps_per_1000_px", row.error.gaps_per_1000_px());
    json.set("width_median", row.error.width_quantile(0.5)).set("width_p5", row.error.width_quantile(0.05));
    json.set("ink_share", row.ink).set("exact_s", row.exact_s);
    const std::string sweep = row.variant.sweep;
    const FaceOffset& offset = row.variant.offset;
    if (!sweep.empty()) json.set(sweep, static_cast<double>(sweep == "units_swept" ? offset.units : offset.factor));
    return json;
}

std::string row_text(const Row& row)
{
    return fmt::format(
        "{:<24} {:<8} {} sample{} offset {:>4} {:>3}  missed {:6.3f} %  leaked {:6.3f} %  gaps {:6.3f} / 1000 px  "
        "width {:.3f} "
        "(p5 {:.3f})  ink {:.2f} %  exact {:.1f} ms\n",
        row.model, name_of(row.variant.path), row.variant.samples, row.variant.samples == 1 ? " " : "s",
        row.variant.offset.factor, row.variant.offset.units, 100.0 * row.error.missed_share(),
        100.0 * row.error.leaked_share(), row.error.gaps_per_1000_px(), row.error.width_quantile(0.5),
        row.error.width_quantile(0.05), 100.0 * row.ink, 1000.0 * row.exact_s);
}

std::vector<Row> measure_scene(const LinesMeasureArguments& arguments, const std::filesystem::path& file,
                               const PluginRegistry& plugins, Renderer& renderer)
{
    const glm::ivec2 size = parse_size(arguments.size);
    MeasuredScene scene(file, plugins, renderer);
    std::vector<Row> rows;
    for (const Variant& variant : variants_of(arguments.has_sweep)) rows.push_back({file.stem().string(), variant});
    const auto cameras = scene.cameras(arguments.views, static_cast<double>(size.x) / size.y);
    double exact_s = 0.0;
    for (std::size_t view = 0; view < cameras.size(); ++view) {
        const std::vector<WantedLine> wanted = scene.wanted(cameras[view], size, exact_s);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const InkImage drawing = scene.draw(cameras[view], size, rows[i].variant);
            std::vector<unsigned char> judged;
            rows[i].error.add(line_error(drawing, wanted, &judged));
            rows[i].ink += ink_share(drawing) / static_cast<double>(cameras.size());
            if (arguments.pictures.empty()) continue;
            write_judged(
                arguments.pictures / fmt::format("{}_{}_{}_{}_view{}.png", rows[i].model, name_of(rows[i].variant.path),
                                                 rows[i].variant.samples, rows[i].variant.offset.factor, view),
                drawing, judged);
        }
    }
    for (Row& row : rows) {
        row.views = static_cast<int>(cameras.size());
        row.exact_s = exact_s / row.views;
        if (row.error.wanted_px <= 0.0)
            throw Error({.what = "no line is visible from any view", .file = file.string(), .expected = "lines"});
    }
    return rows;
}

void measure_lines(const LinesMeasureArguments& arguments)
{
    const glm::ivec2 size = parse_size(arguments.size);
    require_outputs({arguments.result.output()}, arguments.files);
    if (!arguments.pictures.empty()) make_folder(arguments.pictures);
    const auto context = make_headless_context();
    require_fits(size, context->device());
    const PluginRegistry plugins;
    Progress progress("Measuring lines", arguments.files.size());
    JsonValue rows = JsonValue::array();
    for (const auto& file : arguments.files) {
        Renderer renderer(*context);
        for (const Row& row : measure_scene(arguments, file, plugins, renderer)) {
            print_lines(row_text(row));
            rows.push(row_json(row));
        }
        progress.advance();
    }
    arguments.result.write(JsonValue::object()
                               .set("size", arguments.size)
                               .set("device", context->device().renderer)
                               .set("rows", std::move(rows)));
}

}  // namespace

void add_measure_lines(CommandLine measure)
{
    auto arguments = std::make_shared<LinesMeasureArguments>();
    CommandLine command = measure.add_subcommand("lines", "Drawn lines against the exact visible lines");
    command.add_option("FILES", arguments->files, "Levels or models").required().option_text("MODEL|LEVEL...");
    command.add_option("--views", arguments->views, "Views of each: its cameras, else around it; 4")
        .option_text("N")
        .check(whole_number_in(1, 1'000));
    command.add_option("--size", arguments->size, "Size of the picture, 1400x900").option_text("WxH");
    command.add_flag("--sweep", arguments->has_sweep, "Also over polygon offsets, with quads at 4 samples");
    command.add_option("--pictures", arguments->pictures, "A folder for judged pictures: leaked red, missed blue")
        .option_text("DIR");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_lines(*arguments); });
}

}  // namespace hw
