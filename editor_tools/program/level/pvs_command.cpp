#include <fmt/format.h>

#include <chrono>

#include "hatchway/core/files/files.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/compiled/portal_file.hpp"
#include "hatchway/io/json/out.hpp"
#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

struct PvsArguments {
    std::filesystem::path file;
    std::filesystem::path json;
    std::filesystem::path rows;
    std::string effort = "full";
    int threads = 0;
};

/// Tolerances in the units of such files, about an inch.
constexpr double kSlack = 1e-6;
constexpr double kLeast = 1e-4;

struct Averages {
    double leaves = 0.0;
    double clusters = 0.0;
};

Averages averages_of(const PortalFile& portals, const LeafRows& rows)
{
    std::vector<double> leaves_in(static_cast<std::size_t>(rows.leaf_count()));
    for (const int cluster : portals.cluster_of_leaf) leaves_in[static_cast<std::size_t>(cluster)] += 1.0;
    Averages result;
    for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) {
        double leaves = 0.0;
        visit_bits(rows.row(cluster), [&](int seen) {
            leaves += leaves_in[static_cast<std::size_t>(seen)];
            result.clusters += 1.0;
        });
        result.leaves += leaves * leaves_in[static_cast<std::size_t>(cluster)];
    }
    result.leaves /= static_cast<double>(portals.cluster_of_leaf.size());
    result.clusters /= rows.leaf_count();
    return result;
}

std::string rows_text(const LeafRows& rows)
{
    std::string text;
    for (int cluster = 0; cluster < rows.leaf_count(); ++cluster) {
        bool is_first = true;
        visit_bits(rows.row(cluster), [&](int seen) {
            fmt::format_to(std::back_inserter(text), "{}{}", is_first ? "" : " ", seen);
            is_first = false;
        });
        text += '\n';
    }
    return text;
}

void run_pvs(const PvsArguments& arguments)
{
    require_outputs({{"--json", arguments.json}, {"--rows", arguments.rows}}, {arguments.file});
    const PortalFile portals = read_portal_file(arguments.file);
    PvsOptions options;
    options.effort = pvs_effort(arguments.effort);
    options.threads = arguments.threads;
    options.slack = kSlack;
    options.least = kLeast;
    const auto start = std::chrono::steady_clock::now();
    const PvsResult pvs = build_pvs(portals.graph, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Averages averages = averages_of(portals, pvs.rows);
    JsonValue json = JsonValue::object();
    json.set("leaves", static_cast<std::uint64_t>(portals.cluster_of_leaf.size()));
    json.set("clusters", portals.graph.leaf_count).set("portals", portals.portals_in_file);
    json.set("avg_visible_leaves", averages.leaves).set("avg_visible_clusters", averages.clusters);
    json.set("seconds", seconds);
    if (!arguments.rows.empty()) write_file_atomically(arguments.rows, rows_text(pvs.rows));
    if (!arguments.json.empty()) write_json(arguments.json, json);
    print_lines(json.text());
}

}  // namespace

void add_pvs_command(CommandLine app)
{
    auto arguments = std::make_shared<PvsArguments>();
    CommandLine command = app.add_subcommand("pvs", "Computes which leaves of a Quake portal file see each other");
    command.add_option("file", arguments->file, "A portal file, PRT1 or PRT2 text").required();
    command.add_option("-j,--threads", arguments->threads, "Threads; 0 for all").check(whole_number_in(0, 1024));
    command.add_option("--pvs", arguments->effort, "How tight").check(one_of(kPvsEfforts));
    command.add_option("--rows", arguments->rows, "Writes for each leaf or cluster a line of those it sees")
        .option_text("FILE");
    add_json_argument(command, arguments->json);
    command.callback([arguments] { run_pvs(*arguments); });
}

}  // namespace hw
