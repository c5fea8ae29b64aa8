#include <fmt/format.h>

#include <charconv>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/images/images.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/level/level_doubts.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"
#include "program/pictures/image_key.hpp"
#include "program/pictures/shots.hpp"
#include "program/pictures/stats_text.hpp"
#include "program/pictures/world_shown.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

struct RenderArguments {
    LevelArguments level;
    ShotArguments shots;
    ShowArguments show;
    std::string size = "1280x720";
    fs::path out;
    int samples = 4;
    std::string lines = "quads";
    std::string shown_image;
    std::string part = "1/1";
    bool has_stats = false;
    fs::path json;
};

const std::map<std::string, LinePath> kLinePaths{{"native", LinePath::native}, {"quads", LinePath::quads}};

bool is_path(const RenderArguments& arguments)
{
    return !arguments.shots.path.empty();
}

fs::path picture_file(const RenderArguments& arguments, std::size_t index)
{
    return is_path(arguments) ? arguments.out / fmt::format("frame_{:04}.png", index) : arguments.out;
}

/// All that is written: the JSON file and `pictures` pictures, or one.
std::vector<OutputFile> output_files(const RenderArguments& arguments, std::size_t pictures)
{
    std::vector<OutputFile> outputs{{"--json", arguments.json}};
    for (std::size_t i = 0; i < pictures; ++i) outputs.push_back({"--out", picture_file(arguments, i)});
    return outputs;
}

/// Every `of`-th picture from number `first`, both counted from 1.
struct Part {
    std::size_t first = 1;
    std::size_t of = 1;
    bool has(std::size_t picture) const { return picture % of == first - 1; }
};

Part part_of(const RenderArguments& arguments)
{
    const std::string& text = arguments.part;
    const char* end = text.data() + text.size();
    Part part;
    const auto [sign, first_status] = std::from_chars(text.data(), end, part.first);
    const bool has_sign = first_status == std::errc() && sign != end && *sign == '/';
    const auto [stop, of_status] = std::from_chars(has_sign ? sign + 1 : end, end, part.of);
    if (!has_sign || of_status != std::errc() || stop != end || part.first < 1 || part.first > part.of)
        throw Error({.what = "--part " + text, .expected = "K/N, 1 <= K <= N, such as 3/8"});
    return part;
}

FrameOptions frame_options(const RenderArguments& arguments)
{
    FrameOptions options;
    options.samples = arguments.samples;
    options.use_pvs = !arguments.level.without_pvs;
    options.line_path = kLinePaths.at(arguments.lines);
    if (!arguments.shown_image.empty()) options.shown_image = image_key_of(arguments.shown_image);
    options.is_timed = arguments.has_stats || !arguments.json.empty();
    return options;
}

void check_arguments(const RenderArguments& arguments)
{
    parse_size(arguments.size);
    part_of(arguments);
    frame_options(arguments);
    check_shot_arguments(arguments.shots);
    require_outputs(output_files(arguments, is_path(arguments) ? 0 : 1), {arguments.level.file});
    if (is_path(arguments))
        require_writable_folder(arguments.out, "--out");
    else if (arguments.out.extension() != ".png")
        throw Error({.what = "--out " + arguments.out.string(), .expected = "a name that ends in .png"});
}

JsonValue result_json(const RenderArguments& arguments, const Context& context)
{
    JsonValue result = JsonValue::object();
    result.set("level", arguments.level.file.string()).set("size", arguments.size);
    result.set("samples", arguments.samples).set("pvs", !arguments.level.without_pvs);
    result.set("device", context.device().renderer);
    return result;
}

std::string pictures_text(const RenderArguments& arguments, std::size_t count)
{
    return fmt::format("{}: {} picture{}", arguments.out.string(), count, count == 1 ? "" : "s");
}

void render(const RenderArguments& arguments)
{
    check_arguments(arguments);
    const glm::ivec2 size = parse_size(arguments.size);
    const auto context = make_headless_context();
    require_fits(size, context->device());
    Stage stage(*context, stage_options(arguments.level,
                                        arguments.show.kinds.empty() ? CompiledUse::where_kept : CompiledUse::reused));
    warn_of_idle_styles(stage.level(), stage.scene(), arguments.level.styles.size());
    const Part part = part_of(arguments);
    const std::vector<Shot> shots =
        shots_of(arguments.shots, stage.level(), stage.scene(), static_cast<double>(size.x) / size.y);
    require_unread(output_files(arguments, shots.size()));
    if (is_path(arguments)) make_folder(arguments.out);

    FrameOptions options = frame_options(arguments);
    const std::vector<Leak> leaks =
        arguments.show.has_leaks ? told_leaks(stage.level(), stage.scene()).leaks : std::vector<Leak>();
    JsonValue frames = JsonValue::array();
    std::size_t frames_made = 0;
    Progress progress("Rendering", shots.size());
    for (std::size_t i = 0; i < shots.size(); ++i) {
        if (!part.has(i)) continue;
        View view = camera_view(shots[i].camera, size, stage.world().places.boxes_world);
        warn_of_what_is_beyond(view, stage.world().places.boxes_world);
        view.time_s = shots[i].time_s;
        options.overlay.lines = shown_lines(stage, arguments.show, leaks, view, size);
        const FrameStats stats = stage.draw(view, options);
        const fs::path file = picture_file(arguments, i);
        write_png(file, stage.renderer().read_picture());
        frames.push(stats_json(stats).set("file", file.string()).set("time_s", shots[i].time_s));
        if (!is_path(arguments) || arguments.has_stats) print_line(file.string());
        if (arguments.has_stats) print_lines(stats_text(stats));
        progress.advance();
        ++frames_made;
    }
    if (is_path(arguments) && !arguments.has_stats) print_line(pictures_text(arguments, frames_made));
    if (!arguments.json.empty())
        write_json(arguments.json, result_json(arguments, *context).set("frames", std::move(frames)));
    const std::vector<std::string> failures = stage.style_failures();
    if (!failures.empty())
        throw Error(
            {.what = fmt::format("the pictures are not as they should be: {} of what draws failed, as told above",
                                 failures.size()),
             .file = arguments.level.file.string(),
             .fault = Fault::ours});
}

}  // namespace

void add_render_command(CommandLine app)
{
    auto arguments = std::make_shared<RenderArguments>();
    CommandLine command = app.add_subcommand("render", "Draws pictures of a level, from a camera or along a path");
    add_level_arguments(command, arguments->level);
    add_shot_arguments(command, arguments->shots);
    add_show_arguments(command, arguments->show);
    command.add_option("--size", arguments->size, "Size of the picture in pixels, 1280x720").option_text("WxH");
    command.add_option("--out", arguments->out, "The PNG file; with --path a folder for frame_0000.png and on")
        .required()
        .option_text("FILE.png|DIR");
    command.add_option("--samples", arguments->samples, "Samples for each pixel, 1 or 4")
        .option_text("N")
        .check(one_of({"1", "4"}));
    command.add_option("--lines", arguments->lines, "How lines are drawn: quads, or native (GL_LINES)")
        .option_text("WAY")
        .check(one_of({"quads", "native"}));
    command
        .add_option("--show-image", arguments->shown_image,
                    "Draws an image that styles need in place of the picture: its pass and parameters, such as "
                    "normal_depth or 'edge_map operator=c1 width_px=2'")
        .option_text("KEY");
    command
        .add_option("--part", arguments->part, "Only every N-th picture of a path from the K-th on, for many machines")
        .option_text("K/N");
    command.add_flag("--stats", arguments->has_stats, "Print what each frame did");
    add_json_argument(command, arguments->json);
    command.callback([arguments] { render(*arguments); });
}

}  // namespace hw
