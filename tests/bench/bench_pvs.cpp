// bench_pvs FILE.prt [--leaves N] [-j THREADS]: our portal flow and a naive one on the same portals, in one run.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iostream>
#include <string_view>

#include "hatchway/core/error.hpp"
#include "hatchway/io/compiled/portal_file.hpp"
#include "tests/bench/naive_flow.hpp"

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

/// Throws for anything but a whole number from 0.
int count_from(std::string_view text)
{
    int result = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    if (error != std::errc() || end != text.data() + text.size() || result < 0)
        throw Error({.what = fmt::format("\"{}\" is no count", text), .expected = "a whole number from 0"});
    return result;
}

void run_with(const std::vector<std::string_view>& arguments)
{
    std::filesystem::path file;
    int leaves = 0, threads = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool has_value = i + 1 < arguments.size();
        if (arguments[i] == "--leaves" && has_value)
            leaves = count_from(arguments[++i]);
        else if (arguments[i] == "-j" && has_value)
            threads = count_from(arguments[++i]);
        else if (file.empty() && !arguments[i].starts_with('-'))
            file = arguments[i];
        else
            throw Error({.what = fmt::format("\"{}\" is not understood", arguments[i]),
                         .expected = "bench_pvs FILE.prt [--leaves N] [-j THREADS]"});
    }
    if (file.empty()) throw Error({.what = "No file", .expected = "bench_pvs FILE.prt [--leaves N] [-j THREADS]"});
    run(file, leaves, threads);
}

}  // namespace
}  // namespace hw::bench

int main(int count, char** arguments)
{
    try {
        hw::bench::run_with({arguments + 1, arguments + count});
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
