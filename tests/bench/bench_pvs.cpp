// bench_pvs FILE.prt [--leaves N] [-j THREADS]: our portal flow and a naive one on the same portals, in one run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "bench/naive_flow.hpp"
#include "io/portal_file.hpp"

namespace hw::bench {
namespace {

// In the units of such files, about an inch; as `hatchway pvs` sets them.
constexpr double kSlack = 1e-6;
constexpr double kLeast = 1e-4;

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
    for (int i = 0; i < wanted; ++i) {
        result.push_back(static_cast<int>(static_cast<std::int64_t>(i) * leaf_count / wanted));
    }
    return result;
}

double average_visible(const LeafRows& rows, const std::vector<int>& leaves)
{
    double sum = 0.0;
    for (const int leaf : leaves) visit_bits(rows.row(leaf), [&](int) { sum += 1.0; });
    return sum / static_cast<double>(leaves.size());
}

/// Leaves that the first rows show and the second do not.
int shown_only_by(const LeafRows& rows, const LeafRows& others, const std::vector<int>& leaves)
{
    int count = 0;
    for (const int leaf : leaves) visit_bits(rows.row(leaf), [&](int seen) { count += !others.sees(leaf, seen); });
    return count;
}

double share_of_portals(const PortalGraph& graph, const std::vector<int>& leaves)
{
    const auto starts_there = [&](const DirectedPortal& portal) {
        return std::binary_search(leaves.begin(), leaves.end(), portal.from_leaf);
    };
    const auto count = std::count_if(graph.portals.begin(), graph.portals.end(), starts_there);
    return static_cast<double>(count) / static_cast<double>(graph.portals.size());
}

void run(const std::filesystem::path& file, int wanted, int threads)
{
    const PortalGraph graph = read_portal_file(file).graph;
    const bool is_sample = wanted > 0 && wanted < graph.leaf_count;
    const std::vector<int> leaves = even_sample(graph.leaf_count, is_sample ? wanted : graph.leaf_count);
    PvsResult ours;
    const double whole_s = seconds_of([&] {
        ours = build_pvs(graph, {.effort = PvsEffort::exact, .threads = threads, .slack = kSlack, .least = kLeast});
    });
    LeafRows naive;
    const double naive_s = seconds_of([&] { naive = naive_flow(graph, leaves, kLeast); });
    const double share = share_of_portals(graph, leaves);
    const double ours_s = whole_s * share;
    std::cout << fmt::format("{}: {} leaves or clusters, {} portals one way\n", file.filename().string(),
                             graph.leaf_count, graph.portals.size());
    if (is_sample) {
        std::cout << fmt::format(
            "an even sample of {} leaves holds {:.2f} % of the portals: of our {:.3f} s this share is counted.\n"
            "The naive flow reuses results within the sample only, so the ratio favours us; without --leaves it is "
            "fair.\n",
            leaves.size(), 100.0 * share, whole_s);
    }
    std::cout << fmt::format("naive, 1 thread    {:>10.3f} s   average visible {:.2f}\n", naive_s,
                             average_visible(naive, leaves));
    std::cout << fmt::format("ours, {:<12} {:>10.3f} s   average visible {:.2f}\n",
                             threads == 0 ? "all threads" : fmt::format("{} threads", threads), ours_s,
                             average_visible(ours.rows, leaves));
    std::cout << fmt::format("ratio              {:>10.2f}     shown by naive only {}, by ours only {}\n",
                             naive_s / ours_s, shown_only_by(naive, ours.rows, leaves),
                             shown_only_by(ours.rows, naive, leaves));
}

}  // namespace
}  // namespace hw::bench

int main(int count, char** arguments)
{
    CLI::App app("Our portal flow and a naive one on the same portals");
    std::filesystem::path file;
    int leaves = 0, threads = 0;
    app.add_option("file", file, "A portal file, PRT1 or PRT2 text")->required();
    app.add_option("--leaves", leaves, "Leaves that the naive flow does, an even sample; 0 for all")
        ->check(CLI::NonNegativeNumber);
    app.add_option("-j,--threads", threads, "Threads of ours; 0 for all")->check(CLI::NonNegativeNumber);
    CLI11_PARSE(app, count, arguments);
    try {
        hw::bench::run(file, leaves, threads);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
