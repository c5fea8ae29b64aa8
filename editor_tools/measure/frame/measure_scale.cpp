// What grows with a level and what with what is seen of it: levels of four sizes, looked at from their first room.
// Slopes are of a straight line through the logarithms: 1 is proportional, 0 constant. The error beside the time is the
// share of pixels that differ from the frame drawn without the PVS.
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "measure/frame/scale_level.hpp"
#include "measure/log_slope.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/picture_difference.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct ScaleArguments {
    std::vector<int> rooms{64, 128, 256, 500};
    int frames = 20;
    std::string size = "640x360";
    std::string style = "photoreal";
    fs::path write;
    MeasureResult result;
};

/// A folder for generated levels that goes away. Nobody can know its name before.
struct WorkFolder {
    WorkFolder()
    {
        std::string name = (fs::temp_directory_path() / "hatchway_scale_XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw Error({.what = "the folder for generated levels cannot be made", .file = name});
        path = name;
    }
    ~WorkFolder()
    {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    fs::path path;
};

struct Row {
    measure::ScaleLevel level;
    double open_s = 0.0;        ///< First time: import, compile, upload.
    double compile_s = 0.0;     ///< Of it, the visibility alone.
    double open_again_s = 0.0;  ///< With the compiled level at hand.
    double heap_mib = 0.0;      ///< Of the level, open and drawn: what closing it frees.
    int clusters = 0;
    std::uint64_t shortfalls = 0;  ///< Budgets of the compiler that ran out.
    double frame_ms = 0.0;         ///< Medians.
    double visibility_ms = 0.0;
    double frame_triangles = 0.0;
    double visible_share = 0.0;
    double differing_share = 0.0;
};

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Allocated and not freed: pages that the allocator keeps for later are no level's.
double heap_mib()
{
    const struct mallinfo2 heap = ::mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd) / (1024.0 * 1024.0);
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double slope(const std::vector<Row>& rows, double Row::*value)
{
    std::vector<double> triangles, values;
    for (const Row& row : rows) {
        triangles.push_back(static_cast<double>(row.level.triangles));
        values.push_back(std::max(row.*value, 1e-9));
    }
    return measure::log_slope(triangles, values);
}

void draw_frames(Stage& stage, const ScaleArguments& arguments, const glm::ivec2& size, Row& row)
{
    const CameraPlace camera{row.level.eye_world, row.level.target_world, 70.0};
    const View view = camera_view(camera, size, stage.world().places.boxes_world);
    FrameOptions options{.samples = 1, .is_timed = true};
    stage.draw(view, options);  // what is made on first use is no part of a frame
    std::vector<double> frame_ms, visibility_ms;
    for (int i = 0; i < arguments.frames; ++i) {
        const FrameStats stats = stage.draw(view, options);
        frame_ms.push_back(stats.total_ms);
        visibility_ms.push_back(stats.visibility_ms);
        row.frame_triangles = static_cast<double>(stats.triangles);
    }
    row.frame_ms = median(std::move(frame_ms));
    row.visibility_ms = median(std::move(visibility_ms));
    const Pixels with = stage.renderer().read_picture();
    options.use_pvs = false;
    stage.draw(view, options);
    const Pixels without = stage.renderer().read_picture();
    row.differing_share = measure::unlike_share(with, without);
}

Row measure_rooms(Context& context, const ScaleArguments& arguments, const fs::path& folder, int rooms)
{
    const fs::path file = folder / fmt::format("rooms_{}.glb", rooms);
    Row row;
    row.level = measure::write_scale_level(file, rooms);
    const StageOptions options{
        .file = file, .style_overrides = {"*=" + arguments.style}, .cache = CompiledCache{folder}};
    {
        const auto start = Clock::now();
        const Stage stage(context, options);
        row.open_s = seconds_since(start);
        row.compile_s = stage.visibility()->stats.seconds;
        row.visible_share = stage.visibility()->stats.average_visible_share;
        row.clusters = stage.visibility()->stats.clusters;
        row.shortfalls = stage.visibility()->stats.shortfalls.size();
    }
    const auto start = Clock::now();
    auto stage = std::make_unique<Stage>(context, options);
    row.open_again_s = seconds_since(start);
    draw_frames(*stage, arguments, parse_size(arguments.size), row);
    const double open_mib = heap_mib();
    stage.reset();
    row.heap_mib = open_mib - heap_mib();  // what closing it gives back: what went before takes no part
    return row;
}

JsonValue row_json(const Row& row)
{
    JsonValue json = JsonValue::object();
    json.set("rooms", row.level.rooms).set("objects", row.level.objects).set("triangles", row.level.triangles);
    json.set("open_s", row.open_s).set("compile_s", row.compile_s).set("open_again_s", row.open_again_s);
    json.set("heap_mib", row.heap_mib).set("visible_share", row.visible_share);
    json.set("clusters", row.clusters).set("shortfalls", row.shortfalls);
    json.set("frame_ms", row.frame_ms).set("visibility_ms", row.visibility_ms);
    json.set("frame_triangles", row.frame_triangles).set("pixels_unlike_without_pvs", row.differing_share);
    return json;
}

std::string row_text(const Row& row)
{
    return fmt::format(
        "{:4} rooms, {:5} objects, {:8} triangles: open {:.2f} s (compile {:.2f}), again {:.2f} s, "
        "{:.0f} MiB; frame {:.2f} ms (visibility {:.2f}), {} triangles; {:.4f} % of pixels unlike "
        "without PVS\n",
        row.level.rooms, row.level.objects, row.level.triangles, row.open_s, row.compile_s, row.open_again_s,
        row.heap_mib, row.frame_ms, row.visibility_ms, row.frame_triangles, 100.0 * row.differing_share);
}

void measure_scale(const ScaleArguments& arguments)
{
    const glm::ivec2 size = parse_size(arguments.size);
    require_outputs({arguments.result.output(), {"--write", arguments.write}}, {});
    if (!arguments.write.empty()) {
        const auto level = measure::write_scale_level(arguments.write, arguments.rooms.back());
        print_line(
            fmt::format("{}: {} objects, {} triangles", arguments.write.string(), level.objects, level.triangles));
        return;
    }
    if (arguments.rooms.size() < 2 || arguments.rooms.front() >= arguments.rooms.back())
        throw Error({.what = "--rooms", .expected = "at least two sizes, the largest last"});
    const auto context = make_headless_context();
    require_fits(size, context->device());
    const WorkFolder folder;
    measure_rooms(*context, arguments, folder.path, 2);  // what driver and threads take once is no level's
    std::vector<Row> rows;
    JsonValue json_rows = JsonValue::array();
    for (const int rooms : arguments.rooms) {
        rows.push_back(measure_rooms(*context, arguments, folder.path, rooms));
        print_lines(row_text(rows.back()));
        json_rows.push(row_json(rows.back()));
    }
    const double compile = slope(rows, &Row::compile_s);
    const double frame = slope(rows, &Row::frame_ms);
    print_line(fmt::format("slopes against triangles: compile {:.2f}, frame {:.2f}", compile, frame));
    arguments.result.write(JsonValue::object()
                               .set("measure", "scale")
                               .set("device", context->device().renderer)
                               .set("size", arguments.size)
                               .set("compile_slope", compile)
                               .set("frame_slope", frame)
                               .set("rows", std::move(json_rows)));
}

}  // namespace

void add_measure_scale(CommandLine measure)
{
    auto arguments = std::make_shared<ScaleArguments>();
    CommandLine command = measure.add_subcommand(
        "scale", "What grows with a level: compile, memory and a frame from its first room, over several sizes");
    command.add_option("--rooms", arguments->rooms, "Sizes, 64,128,256,500: 10 objects and 4,000 triangles a room")
        .option_text("N,N,...")
        .check(whole_number_in(2, 20'000))
        .delimiter(',');
    command.add_option("--frames", arguments->frames, "Frames of each size; 20")
        .option_text("N")
        .check(whole_number_in(1, 10'000));
    command.add_option("--size", arguments->size, "Size of the picture, 640x360").option_text("WxH");
    command.add_option("--style", arguments->style, "Of all objects; photoreal").option_text("STYLE");
    command.add_option("--write", arguments->write, "Only write the model of the last size here, to look at it")
        .option_text("FILE.glb");
    arguments->result.add_to(command);
    command.callback([arguments] { measure_scale(*arguments); });
}

}  // namespace hw
