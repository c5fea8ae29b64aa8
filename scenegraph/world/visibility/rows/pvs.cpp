// Portals are done in rounds and batches, those that see little first. A batch may use what earlier batches found (a
// portal behind another sees at most what that one sees), never what its own batch finds: so the rows do not depend on
// the number of threads.
#include "hatchway/world/visibility/rows/pvs.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "hatchway/world/visibility/rows/flow_graph.hpp"
#include "hatchway/world/visibility/rows/surely_seen.hpp"

namespace hw {
namespace {

constexpr double kRounding = 1e-9;  // of a portal's radius: by which its centre may lie off its place

/// The corners counter-clockwise about the normal, as separating planes need them.
std::vector<glm::dvec3> oriented(std::vector<glm::dvec3> corners, const glm::dvec3& normal)
{
    glm::dvec3 area(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        area += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    if (glm::dot(area, normal) < 0.0) std::reverse(corners.begin(), corners.end());
    return corners;
}

FlowGraph prepare(const PortalGraph& graph, const PvsOptions& options)
{
    FlowGraph flow;
    flow.leaf_count = graph.leaf_count;
    flow.portals_out_of.resize(static_cast<std::size_t>(graph.leaf_count));
    flow.tolerance = {options.slack, options.least};
    flow.portals.reserve(graph.portals.size());
    for (const DirectedPortal& portal : graph.portals) {
        flow.portals_out_of[static_cast<std::size_t>(portal.from_leaf)].push_back(
            static_cast<int>(flow.portals.size()));
        FlowPortal& made = flow.portals.emplace_back();
        made.to_leaf = portal.to_leaf;
        made.plane = {portal.normal, portal.offset};
        made.winding = Winding(oriented(portal.winding, portal.normal));
        for (int i = 0; i < made.winding.count; ++i) made.centre += made.winding[i] / double(made.winding.count);
        for (int i = 0; i < made.winding.count; ++i)
            made.radius = std::max(made.radius, 1.000001 * glm::distance(made.centre, made.winding[i]));
    }
    return flow;
}

/// The least and the largest distance of a winding's corners from a plane.
struct Sides {
    double least = 0.0, most = 0.0;
};

Sides sides_of(const Winding& winding, const FlowPlane& plane)
{
    Sides sides{plane.distance(winding[0]), plane.distance(winding[0])};
    for (int i = 1; i < winding.count; ++i) {
        const double distance = plane.distance(winding[i]);
        sides.least = std::min(sides.least, distance);
        sides.most = std::max(sides.most, distance);
    }
    return sides;
}

LeafBits all_leaves(const FlowGraph& graph)
{
    LeafBits all((static_cast<std::size_t>(graph.leaf_count) + 63) / 64);
    for (int leaf = 0; leaf < graph.leaf_count; ++leaf) set_bit(all, leaf);
    return all;
}

/// Whether a portal reaches farther in front of a plane than `least`. Its centre and its ball tell of most.
bool does_reach(const FlowPortal& portal, const FlowPlane& plane, double least)
{
    const double distance = plane.distance(portal.centre);
    if (distance - kRounding * portal.radius > least) return true;
    return distance + portal.radius > least && sides_of(portal.winding, plane).most > least;
}

/// A line can pass `first` and then `later` only if `later` reaches in front of `first` and that behind it.
bool may_follow(const FlowPortal& first, const FlowPortal& later, double least)
{
    return does_reach(later, first.plane, least) &&
           does_reach(first, {-later.plane.normal, -later.plane.offset}, least);
}

/// All leaves, where finding out takes too many steps.
LeafBits coarse_sight(const FlowGraph& graph, const FlowPortal& source)
{
    constexpr std::size_t kMostSteps = 200'000'000;  // portals, of all sources
    std::size_t steps_left = kMostSteps / graph.portals.size();
    LeafBits seen((static_cast<std::size_t>(graph.leaf_count) + 63) / 64);
    std::vector<int> pending{source.to_leaf};
    set_bit(seen, source.to_leaf);
    while (!pending.empty()) {
        const int leaf = pending.back();
        pending.pop_back();
        const std::vector<int>& ways = graph.portals_out_of[static_cast<std::size_t>(leaf)];
        if (ways.size() > steps_left) return all_leaves(graph);
        steps_left -= ways.size();
        for (const int number : ways) {
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
    std::vector<FlowPlane> gate;  ///< Separating planes of source and pass; what last hid a portal comes first.
    bool has_gate = false;        ///< They have been made.
    std::size_t entered = 0;      ///< Portal that led here; of no meaning in the first step.
    std::size_t ways_done = 0;    ///< Portals out of the leaf that were tried.
};

/// How a portal lies to the source portal, found out when it is first met.
enum class Relation : std::uint8_t {
    unknown,
    never,  ///< No line passes both.
    clear,  ///< All of it is in front, and all of the source is behind it: neither plane cuts the other.
    cut,
};

/// How far a flow goes. A branch past one of these is not followed: all that may lie behind it counts as seen.
struct FlowLimits {
    std::size_t depth = 0;    ///< Portals in a row.
    std::uint64_t steps = 0;  ///< In all; 0: unlimited.
};

/// The flow of one source portal.
class Flow {
 public:
    Flow(const FlowGraph& graph, const FlowPortal& source, const FlowLimits& limits)
        : graph_(graph),
          source_(source),
          limits_(limits),
          words_(source.sees.size()),
          sees_(source.surely),
          is_on_way_(graph.portals.size()),
          relations_(graph.portals.size())
    {
    }

    void run()
    {
        Step& first = step(0);
        first.source = source_.winding;
        first.leaf = source_.to_leaf;
        first.may_see = source_.sees;
        visit();
    }
    LeafBits take() { return std::move(sees_); }
    std::uint64_t cost() const { return cost_; }
    bool is_coarse() const { return is_coarse_; }

 private:
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

    Relation relation_to(std::size_t index)
    {
        Relation& relation = relations_[index];
        if (relation != Relation::unknown) return relation;
        const FlowPortal& portal = graph_.portals[index];
        const FlowPlane behind{-portal.plane.normal, -portal.plane.offset};
        const Sides later = sides_of(portal.winding, source_.plane), first = sides_of(source_.winding, behind);
        const ClipTolerance& tolerance = graph_.tolerance;
        if (later.most < tolerance.least || first.most < tolerance.least)
            relation = Relation::never;
        else
            relation = std::min(later.least, first.least) >= -tolerance.slack ? Relation::clear : Relation::cut;
        return relation;
    }

    /// Planes through each side of the one and a corner of the other: windings of many corners cost by their product.
    void charge_separators(const Winding& a, const Winding& b)
    {
        constexpr int kLeast = 4, kPairsOfStep = 8;
        cost_ += static_cast<std::uint64_t>(std::max(kLeast, a.count * b.count / kPairsOfStep));
    }

    void make_gate(Step& here)
    {
        if (here.has_gate) return;
        charge_separators(here.source, here.pass);
        here.has_gate = true;
        here.gate.clear();
        const FlowPlane pass_back{-here.pass_plane.normal, -here.pass_plane.offset};
        add_separators({here.source, source_.plane, here.pass, false, false}, here.gate);
        add_separators({here.pass, pass_back, here.source, true, true}, here.gate);
    }

    /// Clips to the gate of a step. The portal's ball is asked first: most portals are wholly behind some plane.
    bool clip_to_gate(Step& here, const FlowPortal& portal, Winding& pass)
    {
        const ClipTolerance& tolerance = graph_.tolerance;
        const auto hidden = [&](std::size_t plane) {
            std::swap(here.gate[plane], here.gate[0]);
            return false;
        };
        for (std::size_t i = 0; i < here.gate.size(); ++i) {
            if (here.gate[i].distance(portal.centre) + portal.radius < tolerance.least) return hidden(i);
        }
        for (std::size_t i = 0; i < here.gate.size(); ++i) {
            if (!clip(pass, here.gate[i], tolerance)) return hidden(i);
        }
        return true;
    }

    /// What of the pass is seen from what is left of the source.
    bool clip_from_both(const Step& here, Step& next)
    {
        charge_separators(next.source, here.pass);
        const ClipTolerance& tolerance = graph_.tolerance;
        const FlowPlane pass_back{-here.pass_plane.normal, -here.pass_plane.offset};
        return clip_to_separators(next.pass, {next.source, source_.plane, here.pass, false, false}, tolerance) &&
               clip_to_separators(next.pass, {here.pass, pass_back, next.source, true, true}, tolerance);
    }

    bool clip_through(Step& here, const FlowPortal& portal, Relation relation, Step& next)
    {
        const ClipTolerance& tolerance = graph_.tolerance;
        cost_ += 2;
        if (here.has_pass) make_gate(here);
        next.pass = portal.winding;
        if (here.has_pass && !clip_to_gate(here, portal, next.pass)) return false;
        next.source = here.source;
        const FlowPlane behind{-portal.plane.normal, -portal.plane.offset};
        const bool is_cut = relation == Relation::cut;
        if (is_cut && !(clip(next.pass, source_.plane, tolerance) && clip(next.source, behind, tolerance)))
            return false;
        if (!here.has_pass) return true;
        if (!clip(next.pass, here.pass_plane, tolerance)) return false;
        // Less of the source has tighter planes.
        if (is_cut && !clip_from_both(here, next)) return false;
        // From the far end: what of the source can be reached from what is left of the portal.
        charge_separators(next.pass, here.pass);
        if (!clip_to_separators(next.source, {next.pass, behind, here.pass, true, false}, tolerance)) return false;
        return clip_to_separators(next.source, {here.pass, here.pass_plane, next.pass, false, true}, tolerance);
    }

    bool is_past_limits(std::size_t depth) const
    {
        return depth >= limits_.depth || (limits_.steps != 0 && cost_ >= limits_.steps);
    }

    /// The step through a portal, if anything new may be behind it.
    bool enters(Step& here, std::size_t depth, std::size_t index)
    {
        const FlowPortal& portal = graph_.portals[index];
        // A line meets a plane once. It may meet a leaf again: merged clusters are not convex.
        if (!has_bit(here.may_see, portal.to_leaf) || is_on_way_[index]) return false;
        const Relation relation = relation_to(index);
        if (relation == Relation::never) return false;
        Step& next = step(depth + 1);
        ++cost_;
        if (!narrow(here, portal, next) || !clip_through(here, portal, relation, next)) return false;
        set_bit(sees_, portal.to_leaf);
        if (is_past_limits(depth)) {
            is_coarse_ = true;
            for (std::size_t word = 0; word < words_; ++word) sees_[word] |= next.may_see[word];
            return false;
        }
        next.pass_plane = portal.plane;
        next.has_pass = true;
        next.has_gate = false;
        next.leaf = portal.to_leaf;
        next.entered = index;
        next.ways_done = 0;
        return true;
    }

    /// Depth first, without recursion: ways may be thousands of portals long.
    void visit()
    {
        for (std::size_t depth = 0;;) {
            Step& here = *steps_[depth];
            const std::vector<int>& ways = graph_.portals_out_of[static_cast<std::size_t>(here.leaf)];
            if (here.ways_done < ways.size()) {
                const auto index = static_cast<std::size_t>(ways[here.ways_done++]);
                if (!enters(here, depth, index)) continue;
                is_on_way_[index] = 1;
                ++depth;
            } else {
                if (depth == 0) return;
                is_on_way_[here.entered] = 0;
                --depth;
            }
        }
    }

    const FlowGraph& graph_;
    const FlowPortal& source_;
    FlowLimits limits_;
    std::uint64_t cost_ = 0;
    bool is_coarse_ = false;
    std::size_t words_;
    LeafBits sees_;
    std::vector<char> is_on_way_;  ///< By portal.
    std::vector<Relation> relations_;
    std::vector<std::unique_ptr<Step>> steps_;
};

struct Outcome {
    LeafBits sees;
    std::uint64_t cost = 0;
    bool is_coarse = false;
};

/// The portals whose answer is still coarse, those that see little first.
std::vector<int> coarse_portals(const FlowGraph& graph)
{
    std::vector<int> result;
    std::vector<int> sizes(graph.portals.size());
    for (std::size_t i = 0; i < graph.portals.size(); ++i) {
        sizes[i] = bit_count(graph.portals[i].sees);
        if (graph.portals[i].is_coarse) result.push_back(static_cast<int>(i));
    }
    std::stable_sort(result.begin(), result.end(), [&](int a, int b) {
        return sizes[static_cast<std::size_t>(a)] < sizes[static_cast<std::size_t>(b)];
    });
    return result;
}

/// One round over the coarse portals, as long as there are steps left; returns its cost.
double flow_round(FlowGraph& graph, const FlowLimits& limits, double steps_left,
                  const std::function<void(double)>& tell)
{
    constexpr std::size_t kSmallestBatch = 32;
    const std::vector<int> order = coarse_portals(graph);
    double cost = 0.0;
    for (std::size_t first = 0; first < order.size() && cost < steps_left;) {
        const std::size_t size = std::min(std::max(kSmallestBatch, first / 16), order.size() - first);
        std::vector<Outcome> outcomes(size);
        tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
            Flow flow(graph, graph.portals[static_cast<std::size_t>(order[first + i])], limits);
            flow.run();
            outcomes[i] = {flow.take(), flow.cost(), flow.is_coarse()};
        });
        for (std::size_t i = 0; i < size; ++i) {
            FlowPortal& portal = graph.portals[static_cast<std::size_t>(order[first + i])];
            portal.sees = std::move(outcomes[i].sees);
            portal.is_coarse = outcomes[i].is_coarse;
            cost += static_cast<double>(outcomes[i].cost);
        }
        first += size;
        if (tell) tell(static_cast<double>(first) / static_cast<double>(order.size()));
    }
    return cost;
}

/// Rounds of rising depth: what a shallow round rules out for all portals makes the next cheaper. A round that has
/// begun may take as much again as the budget. Returns the portals that stay coarse.
std::vector<int> flow_all(FlowGraph& graph, const PvsOptions& options)
{
    constexpr double kStepsPerSecond = 4e6;  // roughly; a count, not a clock, so that rows stay the same
    constexpr std::uint64_t kLeastSteps = 500;
    const bool has_limit = options.effort != PvsEffort::exact && options.seconds > 0.0;
    const double budget = options.seconds * kStepsPerSecond;
    const double most_over = has_limit ? budget : std::numeric_limits<double>::infinity();
    double left = budget;
    const std::size_t unlimited = graph.portals.size() + 1;
    // Where all of it will be done the rounds before the last cost more than they save.
    const std::vector<std::size_t> depths =
        has_limit ? std::vector<std::size_t>{2, 4, 8, unlimited} : std::vector<std::size_t>{unlimited};
    for (const std::size_t depth : depths) {
        const std::size_t coarse = coarse_portals(graph).size();
        if (coarse == 0) return {};
        const double share = 4.0 * std::max(0.0, left) / static_cast<double>(coarse);
        const std::uint64_t steps = has_limit ? std::max(kLeastSteps, static_cast<std::uint64_t>(share)) : 0;
        left -= flow_round(graph, {depth, steps}, left + most_over, options.progress);
        if (has_limit && left < 0.0) break;
    }
    return coarse_portals(graph);
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
        if (options.effort == PvsEffort::fast) return;
        tbb::parallel_for(std::size_t{0}, flow.portals.size(),
                          [&](std::size_t i) { flow.portals[i].surely = surely_seen(flow, flow.portals[i]); });
        result.coarse_portals = flow_all(flow, options);
    });
    result.rows = LeafRows(graph.leaf_count, graph.leaf_count);
    for (int leaf = 0; leaf < graph.leaf_count; ++leaf) {
        const std::span<std::uint64_t> row = result.rows.row(leaf);
        result.rows.show(leaf, leaf);
        for (const int number : flow.portals_out_of[static_cast<std::size_t>(leaf)]) {
            const LeafBits& sees = flow.portals[static_cast<std::size_t>(number)].sees;
            for (std::size_t word = 0; word < row.size(); ++word) row[word] |= sees[word];
        }
    }
    return result;
}

}  // namespace hw
