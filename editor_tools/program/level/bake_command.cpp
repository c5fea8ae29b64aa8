#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "hatchway/core/budget.hpp"
#include "hatchway/core/error.hpp"
#include "hatchway/core/glob.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/compiled/lightmap_file.hpp"
#include "hatchway/stage/level_light.hpp"
#include "hatchway/world/light/bake.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct BakeArguments {
    std::filesystem::path file;
    std::string quality = "final";
    std::optional<double> luxels_per_m;
    std::optional<std::uint32_t> samples;
    std::vector<std::string> nodes;
    std::filesystem::path out;
};

BakeOptions options_of(const BakeArguments& arguments)
{
    BakeOptions options = bake_options(arguments.quality == "draft" ? BakeQuality::draft : BakeQuality::final);
    if (arguments.luxels_per_m) options.luxels_per_m = *arguments.luxels_per_m;
    if (arguments.samples) options.samples = *arguments.samples;
    for (std::uint64_t* budget : {&options.budget, &options.ray_budget})
        *budget = static_cast<std::uint64_t>(std::min(1e18, Budget::factor() * static_cast<double>(*budget)));
    return options;
}

/// Whether a glob names the node or one of its parents.
bool is_named(const Scene& scene, int node, std::span<const Glob> globs)
{
    for (; node != kNone; node = scene.nodes[node].parent)
        for (const Glob& glob : globs)
            if (glob.matches(scene.nodes[node].path)) return true;
    return false;
}

/// The objects that get baked light; empty: all.
std::vector<ObjectId> receivers_of(const Scene& scene, std::span<const std::string> patterns)
{
    std::vector<ObjectId> receivers;
    if (patterns.empty()) return receivers;
    const std::vector<Glob> globs(patterns.begin(), patterns.end());
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        if (is_named(scene, scene.objects[id].node, globs)) receivers.push_back(id);
    if (receivers.empty())
        throw Error(
            {.what = "--nodes: no object has such a name", .file = scene.file, .expected = "a path glob of a node"});
    return receivers;
}

constexpr double kShowAgain_s = 5.0;

/// Writes what there is by now, so that a walk through the level shows it, but not at every moment.
class EarlyResults {
 public:
    explicit EarlyResults(const std::filesystem::path& out) : out_(out) {}

    void offer(const BakeState& state)
    {
        if (state.seconds - written_s_ < kShowAgain_s) return;
        write_lightmap(out_, state.lightmap);
        written_s_ = state.seconds;
    }

 private:
    const std::filesystem::path& out_;
    double written_s_ = 0.0;
};

void bake(const BakeArguments& arguments)
{
    const std::filesystem::path out = arguments.out.empty() ? lightmap_path(arguments.file) : arguments.out;
    require_outputs({{"--out", out}}, {arguments.file});
    const Level level = read_level_with(arguments.file, {});
    const auto world = open_world(level);
    require_unread({{"--out", out}});
    std::uint32_t luxels = 0;
    double seconds = 0.0;
    BakeOptions options = options_of(arguments);
    options.receivers = receivers_of(world->scene, arguments.nodes);
    EarlyResults early(out);
    const Lightmap lightmap =
        bake_lightmap(world->scene, light_sources_of(level, world->scene), options, [&](const BakeState& state) {
            luxels = state.luxels;
            seconds = state.seconds;
            early.offer(state);
        });
    write_lightmap(out, lightmap);
    print_line(fmt::format("{}: {} luxels in {} x {}, {:.3g} luxels per metre; {:.1f} s", out.string(), luxels,
                           lightmap.size.x, lightmap.size.y, lightmap.luxels_per_m, seconds));
}

}  // namespace

void add_bake_command(CommandLine app)
{
    auto arguments = std::make_shared<BakeArguments>();
    CommandLine command = app.add_subcommand("bake", "Bakes a level's light: soft shadows and light that bounces");
    command.add_option("level", arguments->file, "A level or a bare model").required().option_text("LEVEL|MODEL");
    command.add_option("--quality", arguments->quality, "draft: coarse and grainy; final: what is shipped")
        .check(one_of({"draft", "final"}));
    command.add_option("--luxels-per-m", arguments->luxels_per_m, "Density on surfaces; draft 2, final 8")
        .option_text("N")
        .check(number_in(0.01, 1000.0));
    command.add_option("--samples", arguments->samples, "Of each luxel; draft 32, final 512")
        .option_text("N")
        .check(whole_number_in(1, 65536));
    command
        .add_option(
            "--nodes", arguments->nodes,
            "Only the nodes of a path glob and what hangs below them; repeatable. Others keep the light of frames")
        .option_text("GLOB")
        .one_value_each();
    command.add_option("--out", arguments->out, "The file; beside the level, where walk and render find it")
        .option_text("FILE");
    command.callback([arguments] { bake(*arguments); });
}

}  // namespace hw
