// The portal flow on the portals of a file, and a naive one on the same, in one run: seconds, and pairs (leaf, seen
// leaf) that one shows and the other does not.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "hatchway/core/error.hpp"
#include "hatchway/core/plain_text.hpp"
#include "hatchway/io/compiled/portal_file.hpp"
#include "measure/measure_result.hpp"
#include "measure/measures.hpp"
#include "measure/visibility/naive_flow.hpp"
#include "program/arguments.hpp"
#include "program/option_rules.hpp"
#include "program/output_files.hpp"

namespace hw {
namespace {

// In the units of such files, about an inch, of both flows; as `hatchway pvs` sets them.
constexpr ClipTolerance kTolerance{.slack = 1e-6, .least = 1e-4};

struct PortalsMeasureArguments {
    std::vector<std::filesystem::path> files;
    int leaves = 0;
    int threads = 1;
    MeasureResult result;
};

template <typename Work>
double seconds_of(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<int> even_sample(int leaf_count, int wanted)
{
    std::vector<int> result;
    for (int i = 0; i < wanted; ++i)
        result.push_back(static_cast<int>(static_cast<std::int64_t>(i) * leaf_count / wanted));
    return result;
}

double mean_visible(const LeafRows& rows, const std::vector<int>& leaves)
{
    double sum = 0.0;
    for (const int leaf : leaves) visit_bits(rows.row(leaf), [&](int) { sum += 1.0; });
    return sum / static_cast<double>(leaves.size());
}

/// Pairs (leaf, seen leaf) that the first rows show and the second do not.
int shown_only_by(const LeafRows& rows, const LeafRows& others, const std::vector<int>& leaves)
{
    int count = 0;
    for (const int leaf : leaves) visit_bits(rows.row(leaf), [&](int seen) { count += !others.sees(leaf, seen); });
    return count;
}

JsonValue measure_file(const std::filesystem::path& file, const PortalsMeasureArguments& arguments)
{
    const PortalGraph graph = read_portal_file(file).graph;
    if (graph.portals.empty())
        throw Error({.what = "has no portals", .file = file.string(), .expected = "leaves that see each other"});
    const bool is_sample = arguments.leaves > 0 && arguments.leaves < graph.leaf_count;
    const std::vector<int> leaves = even_sample(graph.leaf_count, is_sample ? arguments.leaves : graph.leaf_count);
    PvsResult ours;
    const PvsOptions options{
        .effort = PvsEffort::exact, .threads = arguments.threads, .slack = kTolerance.slack, .least = kTolerance.least};
    const double ours_s = seconds_of([&] { ours = build_pvs(graph, options); });
    LeafRows naive;
    const double naive_s = seconds_of([&] { naive = measure::naive_flow(graph, leaves, kTolerance); });
    const int only_naive = shown_only_by(naive, ours.rows, leaves), only_ours = shown_only_by(ours.rows, naive, leaves);
    const std::string name = file.filename().string();
    print_line(
        fmt::format("{:<28} leaves {:>6} of {:>6}, ours (all) {:>9.3f} s, naive (these) {:>9.3f} s, shown by naive "
                    "only {}, by ours only {}",
                    name, leaves.size(), graph.leaf_count, ours_s, naive_s, only_naive, only_ours));
    JsonValue row = JsonValue::object();
    row.set("file", name).set("leaves", graph.leaf_count).set("portals", std::uint64_t{graph.portals.size()});
    row.set("threads", arguments.threads).set("seconds", ours_s);
    row.set("naive_leaves", std::uint64_t{leaves.size()}).set("naive_seconds", naive_s);
    row.set("visible", mean_visible(ours.rows, leaves)).set("naive_visible", mean_visible(naive, leaves));
    row.set("only_naive", only_naive).set("only_ours", only_ours);
    return row;
}

void measure_portals(const PortalsMeasureArguments& arguments)
{
    require_outputs({arguments.result.output()}, arguments.files);
    JsonValue rows = JsonValue::array();
    for (const auto& file : arguments.files) rows.push(measure_file(file, arguments));
    arguments.result.write(JsonValue::object().set("rows", std::move(rows)));
}

}  // namespace

void add_measure_portals(CommandLine measure)
{
    auto arguments = std::make_shared<PortalsMeasureArguments>();
    CommandLine command =
        measure.add_subcommand("portals", "The portal flow of .prt files beside a naive one: seconds and rows");
    command.add_option("FILES", arguments->files, "Portal files").required().option_text("PRT...");
    command
        .add_option("--leaves", arguments->leaves,
                    "The naive flow makes the rows of an even sample of so many leaves; all")
        .option_text("N")
        .check(whole_number_in(1, 1'000'000));
    command.add_option("-j,--threads", arguments->threads, "Threads of our flow, the naive one has one; 1")
        .check(whole_number_in(0, 1024));
    arguments->result.add_to(command);
    command.callback([arguments] { measure_portals(*arguments); });
}

}  // namespace hw
