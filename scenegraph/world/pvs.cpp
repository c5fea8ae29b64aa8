// Portals are done in batches, those that see little first. A batch may use what earlier batches found (a portal behind
// another sees at most what that one sees), never what its own batch finds: so the rows do not depend on the number of
// threads.
#include "world/pvs.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/progress.hpp"
#include "world/flow_graph.hpp"

namespace hw {
namespace {

FlowGraph prepare(const PortalGraph& graph, const PvsOptions& options)
{
    FlowGraph flow;
    flow.leaf_count = graph.leaf_count;
    flow.portals_out_of.resize(static_cast<std::size_t>(graph.leaf_count));
    flow.tolerance = {options.slack, options.least};
    flow.portals.reserve(graph.portals.size());
    for (const DirectedPortal& portal : graph.portals) {
        flow.portals_out_of[static_cast<std::size_t>(portal.from_leaf)].push_back(static_cast<int>(flow.portals.size()));
        FlowPortal& made = flow.portals.emplace_back();
        made.to_leaf = portal.to_leaf;
        made.plane = {portal.normal, portal.offset};
        made.winding = Winding(portal.winding);
    }
    return flow;
}

bool reaches_front(const Winding& winding, const FlowPlane& plane, double least)
{
    for (int i = 0; i < winding.count; ++i) {
        if (plane.distance(winding[i]) > least) return true;
    }
    return false;
}

/// A line can pass `first` and then `later` only if `later` reaches in front of `first` and that behind it.
bool may_follow(const FlowPortal& first, const FlowPortal& later, double least)
{
    return reaches_front(later.winding, first.plane, least) &&
           reaches_front(first.winding, {-later.plane.normal, -later.plane.offset}, least);
}

LeafBits coarse_sight(const FlowGraph& graph, const FlowPortal& source)
{
    LeafBits seen((static_cast<std::size_t>(graph.leaf_count) + 63) / 64);
    std::vector<int> pending{source.to_leaf};
    set_bit(seen, source.to_leaf);
    while (!pending.empty()) {
        const int leaf = pending.back();
        pending.pop_back();
        for (const int number : graph.portals_out_of[static_cast<std::size_t>(leaf)]) {
            const FlowPortal& portal = graph.portals[static_cast<std::size_t>(number)];
            if (has_bit(seen, portal.to_leaf) || !may_follow(source, portal, graph.tolerance.least)) continue;
            set_bit(seen, portal.to_leaf);
            pending.push_back(portal.to_leaf);
        }
    }
    return seen;
}

/// One leaf on the way from the source portal: what of the source still sees it, and through what.
struct Step {
    Winding source;
    Winding pass;
    FlowPlane pass_plane;
    bool has_pass = false;
    int leaf = 0;
    LeafBits may_see;
};

/// The flow of one source portal.
class Flow {
 public:
    Flow(const FlowGraph& graph, const FlowPortal& source, std::uint64_t budget)
        : graph_(graph), source_(source), budget_(budget), words_(source.sees.size()),
          sees_(source.sees.size()), is_on_way_(static_cast<std::size_t>(graph.leaf_count))
    {
    }

    /// False if the budget ran out.
    bool run()
    {
        sees_ = surely_seen(graph_, source_);
        Step& first = step(0);
        first.source = source_.winding;
        first.leaf = source_.to_leaf;
        first.may_see = source_.sees;
        visit(0);
        return !is_over_budget();
    }
    LeafBits take() { return std::move(sees_); }
    std::uint64_t cost() const { return cost_; }

 private:
    bool is_over_budget() const { return budget_ != 0 && cost_ > budget_; }

    Step& step(std::size_t depth)
    {
        while (steps_.size() <= depth) {
            steps_.push_back(std::make_unique<Step>());
            steps_.back()->may_see.resize(words_);
        }
        return *steps_[depth];
    }

    /// What may still be seen through `portal`; false if all of it is known to be seen.
    bool narrow(const Step& here, const FlowPortal& portal, Step& next) const
    {
        std::uint64_t fresh = 0;
        for (std::size_t word = 0; word < words_; ++word) {
            next.may_see[word] = here.may_see[word] & portal.sees[word];
            fresh |= next.may_see[word] & ~sees_[word];
        }
        return fresh != 0;
    }

    bool clip_through(const Step& here, const FlowPortal& portal, Step& next)
    {
        const ClipTolerance& tolerance = graph_.tolerance;
        cost_ += 2;
        next.pass = portal.winding;
        if (!clip(next.pass, source_.plane, tolerance)) return false;
        next.source = here.source;
        const FlowPlane behind{-portal.plane.normal, -portal.plane.offset};
        if (!clip(next.source, behind, tolerance)) return false;
        if (!here.has_pass) return true;
        if (!clip(next.pass, here.pass_plane, tolerance)) return false;
        cost_ += 4;
        const FlowPlane pass_back{-here.pass_plane.normal, -here.pass_plane.offset};
        if (!clip_to_separators(next.pass, {next.source, source_.plane, here.pass, false, false}, tolerance)) return false;
        if (!clip_to_separators(next.pass, {here.pass, pass_back, next.source, true, true}, tolerance)) return false;
        // The same from the far end: what of the source can be reached from what is left of the portal.
        cost_ += 4;
        if (!clip_to_separators(next.source, {next.pass, behind, here.pass, true, false}, tolerance)) return false;
        return clip_to_separators(next.source, {here.pass, here.pass_plane, next.pass, false, true}, tolerance);
    }

    void visit(std::size_t depth)
    {
        Step& here = step(depth);
        is_on_way_[static_cast<std::size_t>(here.leaf)] = 1;
        for (const int number : graph_.portals_out_of[static_cast<std::size_t>(here.leaf)]) {
            const FlowPortal& portal = graph_.portals[static_cast<std::size_t>(number)];
            // A line meets a convex leaf once.
            if (!has_bit(here.may_see, portal.to_leaf) || is_on_way_[static_cast<std::size_t>(portal.to_leaf)]) continue;
            Step& next = step(depth + 1);
            ++cost_;
            if (!narrow(here, portal, next) || !clip_through(here, portal, next)) continue;
            set_bit(sees_, portal.to_leaf);
            next.pass_plane = portal.plane;
            next.has_pass = true;
            next.leaf = portal.to_leaf;
            visit(depth + 1);
            if (is_over_budget()) break;
        }
        is_on_way_[static_cast<std::size_t>(here.leaf)] = 0;
    }

    const FlowGraph& graph_;
    const FlowPortal& source_;
    std::uint64_t budget_;
    std::uint64_t cost_ = 0;
    std::size_t words_;
    LeafBits sees_;
    std::vector<char> is_on_way_;
    std::vector<std::unique_ptr<Step>> steps_;
};

/// What a portal sees at most, given what the portals behind it are known to see.
LeafBits seen_through_next(const FlowGraph& graph, const FlowPortal& source)
{
    LeafBits result(source.sees.size());
    set_bit(result, source.to_leaf);
    for (const int number : graph.portals_out_of[static_cast<std::size_t>(source.to_leaf)]) {
        const FlowPortal& portal = graph.portals[static_cast<std::size_t>(number)];
        if (!may_follow(source, portal, graph.tolerance.least)) continue;
        for (std::size_t word = 0; word < result.size(); ++word) result[word] |= portal.sees[word];
    }
    for (std::size_t word = 0; word < result.size(); ++word) result[word] &= source.sees[word];
    return result;
}

struct Outcome {
    LeafBits sees;
    std::uint64_t cost = 0;
    bool is_coarse = false;
};

Outcome flow_from(const FlowGraph& graph, const FlowPortal& source, std::uint64_t budget)
{
    Flow flow(graph, source, budget);
    const bool is_finished = flow.run();
    if (is_finished) return {flow.take(), flow.cost(), false};
    return {seen_through_next(graph, source), flow.cost(), true};
}

int flow_all(FlowGraph& graph, const PvsOptions& options)
{
    constexpr std::size_t kSmallestBatch = 32;
    constexpr double kStepsPerSecond = 3e6;  // per thread, roughly; a count, not a clock, so that rows stay the same
    std::vector<int> order(graph.portals.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<int> sizes;
    for (const FlowPortal& portal : graph.portals) sizes.push_back(bit_count(portal.sees));
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return sizes[static_cast<std::size_t>(a)] < sizes[static_cast<std::size_t>(b)];
    });
    Progress progress("visibility", std::max<std::size_t>(order.size(), 1));
    double left = options.effort == PvsEffort::exact ? 0.0 : options.seconds * kStepsPerSecond;
    const bool has_budget = left > 0.0;
    int coarse = 0;
    for (std::size_t first = 0; first < order.size();) {
        const std::size_t size = std::min(std::max(kSmallestBatch, first / 16), order.size() - first);
        // A portal may use several times its even share: most use far less.
        const double share = 8.0 * std::max(left, 0.0) / static_cast<double>(order.size() - first);
        const std::uint64_t budget = has_budget ? static_cast<std::uint64_t>(share) + 100 : 0;
        std::vector<Outcome> outcomes(size);
        tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
            const FlowPortal& source = graph.portals[static_cast<std::size_t>(order[first + i])];
            outcomes[i] = flow_from(graph, source, budget);
            progress.advance();
        });
        for (std::size_t i = 0; i < size; ++i) {
            FlowPortal& portal = graph.portals[static_cast<std::size_t>(order[first + i])];
            portal.sees = std::move(outcomes[i].sees);
            left -= static_cast<double>(outcomes[i].cost);
            coarse += outcomes[i].is_coarse;
        }
        first += size;
    }
    return coarse;
}

}  // namespace

PvsResult build_pvs(const PortalGraph& graph, const PvsOptions& options)
{
    FlowGraph flow = prepare(graph, options);
    PvsResult result;
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, flow.portals.size(),
                          [&](std::size_t i) { flow.portals[i].sees = coarse_sight(flow, flow.portals[i]); });
        if (options.effort != PvsEffort::fast) result.coarse_portals = flow_all(flow, options);
    });
    result.rows = LeafRows(graph.leaf_count);
    for (int leaf = 0; leaf < graph.leaf_count; ++leaf) {
        const std::span<std::uint64_t> row = result.rows.row(leaf);
        row[static_cast<std::size_t>(leaf) / 64] |= std::uint64_t{1} << (leaf % 64);
        for (const int number : flow.portals_out_of[static_cast<std::size_t>(leaf)]) {
            const LeafBits& sees = flow.portals[static_cast<std::size_t>(number)].sees;
            for (std::size_t word = 0; word < row.size(); ++word) row[word] |= sees[word];
        }
    }
    return result;
}

}  // namespace hw
