#include <fmt/format.h>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/io/json/out.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/level/level_doubts.hpp"
#include "program/level/node_list.hpp"
#include "program/level/style_doubts.hpp"
#include "program/output_files.hpp"
#include "program/pictures/world_shown.hpp"

namespace hw {
namespace {

struct CheckArguments {
    LevelArguments level;
    std::filesystem::path json;
};

JsonValue leaks_json(const std::vector<Leak>& leaks)
{
    const auto point_json = [](const glm::dvec3& p) { return JsonValue::array().push(p.x).push(p.y).push(p.z); };
    JsonValue json = JsonValue::array();
    for (const Leak& leak : leaks) {
        JsonValue points = JsonValue::array();
        for (const glm::dvec3& point : leak.points_world) points.push(point_json(point));
        json.push(JsonValue::object()
                      .set("from", leak.from)
                      .set("opening", point_json(leak.opening_world))
                      .set("opening_m2", leak.opening_m2)
                      .set("near", leak.near_node)
                      .set("points", std::move(points)));
    }
    return json;
}

JsonValue result_json(const CheckArguments& arguments, const Stage& stage, const std::vector<std::string>& doubts,
                      const LeakSearch& search)
{
    JsonValue warnings = JsonValue::array();
    for (const std::string& doubt : doubts) warnings.push(doubt);
    return JsonValue::object()
        .set("level", arguments.level.file.string())
        .set("objects", static_cast<std::uint64_t>(stage.scene().objects.size()))
        .set("hidden_objects", static_cast<std::uint64_t>(stage.scene().hidden.size()))
        .set("triangles", drawn_triangle_count(stage.scene()))
        .set("is_compiled_level_used", stage.is_compiled_level_used())
        .set("warnings", std::move(warnings))
        .set("leaks", leaks_json(search.leaks))
        .set("is_leak_search_complete", search.is_complete);
}

std::string compiled_text(const Stage& stage)
{
    return stage.is_compiled_level_used() ? "visibility from the compiled level; " : "";
}

void check(const CheckArguments& arguments)
{
    const std::vector<OutputFile> outputs{{"--json", arguments.json}};
    require_outputs(outputs, {arguments.level.file});
    const auto context = make_headless_context();
    Stage stage(*context, stage_options(arguments.level, CompiledUse::where_kept));
    require_unread(outputs);
    std::vector<std::string> found = level_doubts(stage.level(), stage.scene());
    for (std::string& doubt : style_doubts(*context, stage)) found.push_back(std::move(doubt));
    for (const std::string& doubt : found) log_warning(doubt);
    // The stage has told these.
    const std::vector<std::string>& of_model = stage.scene().doubts;
    found.insert(found.end(), of_model.begin(), of_model.end());
    const std::vector<std::string> failures = stage.style_failures();
    const bool is_sealed = stage.level().is_sealed;
    const LeakSearch search = is_sealed ? told_leaks(stage.level(), stage.scene()) : LeakSearch{};
    const std::size_t warnings = found.size() + search.leaks.size() + (search.is_complete ? 0 : 1);

    const Scene& scene = stage.scene();
    print_line(
        fmt::format("{}: {}: {} objects{}, {} triangles, {} materials, {} lights, {} styles, {} cameras, {} "
                    "paths; {}{} warning{}",
                    arguments.level.file.string(), failures.empty() ? "good" : "not drawn as it should be",
                    scene.objects.size(), hidden_text(scene), drawn_triangle_count(scene), scene.materials.size(),
                    scene.lights.size() + stage.level().lights.size(), stage.level().styles.size(),
                    stage.level().cameras.size() + scene.cameras.size(), stage.level().paths.size(),
                    compiled_text(stage), warnings, warnings == 1 ? "" : "s"));
    if (!arguments.json.empty()) write_json(arguments.json, result_json(arguments, stage, found, search));
    if (!failures.empty())
        throw Error(
            {.what = fmt::format("the level is not drawn as it should be: {} of what draws failed, as told above",
                                 failures.size()),
             .file = arguments.level.file.string(),
             .fault = Fault::ours});
}

}  // namespace

void add_check_command(CommandLine app)
{
    auto arguments = std::make_shared<CheckArguments>();
    CommandLine command =
        app.add_subcommand("check", "Opens a level with all its styles, maps and shaders, and says what is wrong");
    add_level_arguments(command, arguments->level);
    add_json_argument(command, arguments->json);
    command.callback([arguments] { check(*arguments); });
}

}  // namespace hw
