#include "hatchway/world/visibility/rows/leaf_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <queue>
#include <set>

#include "hatchway/world/visibility/rows/opening_hulls.hpp"

namespace hw {
namespace {

double total_area(std::span<const Opening> openings)
{
    double sum = 0.0;
    for (const Opening& opening : openings) sum += area_of(opening);
    return sum;
}

/// What two clusters have in common.
struct Border {
    double open_m2 = 0.0;  ///< Mean of both ways.
    double whole_m2 = 0.0;
};

/// Clusters as a graph that shrinks.
class Merger {
 public:
    /// `group_of_leaf`: clusters of different groups are never merged; empty: all may be.
    Merger(const BspTree& tree, std::span<const LeafContact> contacts, std::span<const int> group_of_leaf)
        : owner_(static_cast<std::size_t>(tree.cluster_count)),
          boxes_(owner_.size()),
          borders_(owner_.size()),
          lower_(owner_.size())
    {
        std::iota(owner_.begin(), owner_.end(), 0);
        const auto group = [&](int leaf) {
            return group_of_leaf.empty() ? 0 : group_of_leaf[static_cast<std::size_t>(leaf)];
        };
        group_.resize(owner_.size());
        for (int leaf = 0; leaf < tree.leaf_count; ++leaf)
            group_[static_cast<std::size_t>(tree.cluster_of_leaf[static_cast<std::size_t>(leaf)])] = group(leaf);
        for (const LeafContact& contact : contacts) {
            if (group(contact.front_leaf) == group(contact.back_leaf)) add(tree, contact);
        }
    }

    /// `open`: those that count, `count` of them.
    void merge(int count, std::span<const std::uint8_t> open, const LeafClusterOptions& options)
    {
        for (std::size_t a = 0; a < borders_.size(); ++a) {
            for (const auto& [b, border] : borders_[a]) offer(static_cast<int>(a), b, options);
        }
        while (count > options.most && !queue_.empty()) {
            const Candidate best = queue_.top();
            queue_.pop();
            if (owner_of(best.a) != best.a || owner_of(best.b) != best.b || size_of(best.a, best.b) != best.size)
                continue;
            join(best.a, best.b, options);
            --count;
        }
        if (count > options.most_at_all) merge_any(count - options.most_at_all, open);
    }

    std::vector<glm::dvec3> take_places() { return std::move(places_); }

    int owner_of(int cluster)
    {
        while (owner_[static_cast<std::size_t>(cluster)] != cluster) {
            int& up = owner_[static_cast<std::size_t>(cluster)];
            up = owner_[static_cast<std::size_t>(up)];
            cluster = up;
        }
        return cluster;
    }

 private:
    struct Candidate {
        double size = 0.0;
        int a = 0;
        int b = 0;
        bool operator<(const Candidate& other) const
        {
            return size != other.size ? size > other.size : a != other.a ? a > other.a : b > other.b;
        }
    };

    void add(const BspTree& tree, const LeafContact& contact)
    {
        const std::size_t front = static_cast<std::size_t>(contact.front_leaf);
        const std::size_t back = static_cast<std::size_t>(contact.back_leaf);
        if (tree.is_solid[front] || tree.is_solid[back]) return;
        const int a = tree.cluster_of_leaf[front];
        const int b = tree.cluster_of_leaf[back];
        for (const auto* openings : {&contact.forward, &contact.backward}) {
            for (const Opening& opening : *openings) {
                for (const glm::dvec3& corner : opening) {
                    boxes_[static_cast<std::size_t>(a)].add(corner);
                    boxes_[static_cast<std::size_t>(b)].add(corner);
                }
            }
        }
        if (a == b) return;
        Border& border = border_of(a, b);
        border.open_m2 += 0.5 * (total_area(contact.forward) + total_area(contact.backward));
        border.whole_m2 += contact.area_m2;
    }

    /// Of two neighbours; they become so.
    Border& border_of(int a, int b)
    {
        lower_[static_cast<std::size_t>(std::max(a, b))].insert(std::min(a, b));
        return borders_[static_cast<std::size_t>(std::min(a, b))][std::max(a, b)];
    }

    Border take_border(int a, int b)
    {
        lower_[static_cast<std::size_t>(std::max(a, b))].erase(std::min(a, b));
        return borders_[static_cast<std::size_t>(std::min(a, b))].extract(std::max(a, b)).mapped();
    }

    double size_of(int a, int b) const
    {
        Box box = boxes_[static_cast<std::size_t>(a)];
        box.add(boxes_[static_cast<std::size_t>(b)]);
        if (box.is_empty()) return 0.0;
        const glm::dvec3 size = box.size();
        return size.x + size.y + size.z;
    }

    /// The smallest, whatever is between them.
    void merge_any(int times, std::span<const std::uint8_t> open)
    {
        std::vector<std::pair<double, int>> smallest;
        for (int cluster = 0; cluster < static_cast<int>(owner_.size()); ++cluster)
            if (open[static_cast<std::size_t>(cluster)] && owner_of(cluster) == cluster)
                smallest.emplace_back(size_of(cluster, cluster), cluster);
        std::sort(smallest.begin(), smallest.end());
        std::map<int, int> last_of_group;
        for (const auto& [size, cluster] : smallest) {
            if (times == 0) return;
            const auto [last, is_first] = last_of_group.emplace(group_[static_cast<std::size_t>(cluster)], cluster);
            if (is_first) continue;
            take_over(cluster, last->second);
            last->second = cluster;
            --times;
        }
    }

    void offer(int a, int b, const LeafClusterOptions& options)
    {
        const Border& border = borders_[static_cast<std::size_t>(std::min(a, b))][std::max(a, b)];
        if (border.open_m2 < options.least_open_share * border.whole_m2) return;
        queue_.push({size_of(a, b), std::min(a, b), std::max(a, b)});
    }

    /// The neighbours of a cluster, both those numbered higher and lower.
    std::vector<int> neighbours_of(int cluster) const
    {
        std::vector<int> result;
        for (const auto& [other, border] : borders_[static_cast<std::size_t>(cluster)]) result.push_back(other);
        const std::set<int>& lower = lower_[static_cast<std::size_t>(cluster)];
        result.insert(result.end(), lower.begin(), lower.end());
        return result;
    }

    void take_over(int a, int b)
    {
        const Box& added = boxes_[static_cast<std::size_t>(b)];
        places_.push_back(added.is_empty() ? glm::dvec3(0.0) : added.centre());
        owner_[static_cast<std::size_t>(b)] = a;
        boxes_[static_cast<std::size_t>(a)].add(added);
    }

    /// b becomes part of a.
    void join(int a, int b, const LeafClusterOptions& options)
    {
        const Box before = boxes_[static_cast<std::size_t>(a)];
        take_over(a, b);
        std::vector<int> changed;
        for (const int other : neighbours_of(b)) {
            const Border old = take_border(b, other);
            if (other == a) continue;
            Border& border = border_of(a, other);
            border.open_m2 += old.open_m2;
            border.whole_m2 += old.whole_m2;
            changed.push_back(other);
        }
        const Box& after = boxes_[static_cast<std::size_t>(a)];
        const bool is_larger = before.min != after.min || before.max != after.max;
        for (const int other : is_larger ? neighbours_of(a) : changed) offer(a, other, options);
    }

    std::vector<int> owner_;
    std::vector<int> group_;
    std::vector<Box> boxes_;
    std::vector<std::map<int, Border>> borders_;  ///< By the lower number, then by the higher.
    std::vector<std::set<int>> lower_;            ///< The neighbours of lower numbers.
    std::priority_queue<Candidate> queue_;
    std::vector<glm::dvec3> places_;  ///< Of the merges.
};

/// Openings between two clusters in one plane.
struct Passage {
    int plane = 0;
    int from = 0;
    int to = 0;
    bool is_forward = false;
    auto operator<=>(const Passage&) const = default;
};

/// Makes each part of a cluster that has no opening to the others a cluster of its own: the inside of a chimney is not
/// the room around it.
void part_clusters(BspTree& tree, std::span<const LeafContact> contacts)
{
    std::vector<int> part(static_cast<std::size_t>(tree.leaf_count));
    std::iota(part.begin(), part.end(), 0);
    const auto part_of = [&](int leaf) {
        while (part[static_cast<std::size_t>(leaf)] != leaf) {
            int& up = part[static_cast<std::size_t>(leaf)];
            up = part[static_cast<std::size_t>(up)];
            leaf = up;
        }
        return leaf;
    };
    for (const LeafContact& contact : contacts) {
        const std::size_t front = static_cast<std::size_t>(contact.front_leaf);
        const std::size_t back = static_cast<std::size_t>(contact.back_leaf);
        const bool is_within = tree.cluster_of_leaf[front] == tree.cluster_of_leaf[back];
        if (!is_within || tree.is_solid[front] != tree.is_solid[back]) continue;
        if (contact.forward.empty() && contact.backward.empty()) continue;
        const int a = part_of(contact.front_leaf);
        const int b = part_of(contact.back_leaf);
        part[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::vector<int> number(part.size(), -1);
    tree.cluster_count = 0;
    for (int leaf = 0; leaf < tree.leaf_count; ++leaf) {
        int& cluster = number[static_cast<std::size_t>(part_of(leaf))];
        if (cluster < 0) cluster = tree.cluster_count++;
        tree.cluster_of_leaf[static_cast<std::size_t>(leaf)] = cluster;
    }
}

/// Returns a place for each merge.
std::vector<glm::dvec3> merge_open(BspTree& tree, std::span<const LeafContact> contacts,
                                   std::span<const int> group_of_leaf, const LeafClusterOptions& options)
{
    Merger merger(tree, contacts, group_of_leaf);
    std::vector<std::uint8_t> is_open(static_cast<std::size_t>(tree.cluster_count));
    for (std::size_t leaf = 0; leaf < tree.is_solid.size(); ++leaf) {
        if (!tree.is_solid[leaf]) is_open[static_cast<std::size_t>(tree.cluster_of_leaf[leaf])] = 1;
    }
    merger.merge(static_cast<int>(std::count(is_open.begin(), is_open.end(), std::uint8_t{1})), is_open, options);
    std::vector<int> number(is_open.size(), 0);
    int count = 1;
    for (std::size_t cluster = 0; cluster < is_open.size(); ++cluster) {
        const int owner = merger.owner_of(static_cast<int>(cluster));
        if (is_open[cluster] && owner == static_cast<int>(cluster)) number[cluster] = count++;
    }
    for (std::size_t leaf = 0; leaf < tree.is_solid.size(); ++leaf) {
        const int owner = merger.owner_of(tree.cluster_of_leaf[leaf]);
        tree.cluster_of_leaf[leaf] = tree.is_solid[leaf] ? 0 : number[static_cast<std::size_t>(owner)];
    }
    tree.cluster_count = count;
    return merger.take_places();
}

}  // namespace

std::vector<glm::dvec3> merge_clusters(BspTree& tree, std::span<const LeafContact> contacts,
                                       const LeafClusterOptions& options)
{
    part_clusters(tree, contacts);
    return merge_open(tree, contacts, {}, options);
}

std::vector<int> split_into_cells(BspBuild& build, std::span<const LeafContact> contacts,
                                  const LeafClusterOptions& options)
{
    BspTree& tree = build.tree;
    const std::vector<int> cluster_of_leaf = tree.cluster_of_leaf;
    std::map<std::pair<int, int>, int> numbers;
    for (std::size_t leaf = 0; leaf < cluster_of_leaf.size(); ++leaf) {
        const std::pair key(cluster_of_leaf[leaf], build.part_of_leaf[leaf]);
        tree.cluster_of_leaf[leaf] = numbers.emplace(key, static_cast<int>(numbers.size())).first->second;
    }
    tree.cluster_count = static_cast<int>(numbers.size());
    merge_open(tree, contacts, cluster_of_leaf, options);
    std::vector<int> cluster_of_cell(static_cast<std::size_t>(tree.cluster_count), 0);
    for (std::size_t leaf = 0; leaf < cluster_of_leaf.size(); ++leaf) {
        if (!tree.is_solid[leaf])
            cluster_of_cell[static_cast<std::size_t>(tree.cluster_of_leaf[leaf])] = cluster_of_leaf[leaf];
    }
    return cluster_of_cell;
}

PortalGraph cluster_portals(const BspBuild& build, std::span<const LeafContact> contacts)
{
    const BspTree& tree = build.tree;
    std::map<Passage, std::vector<Opening>> passages;
    for (const LeafContact& contact : contacts) {
        const std::size_t front = static_cast<std::size_t>(contact.front_leaf);
        const std::size_t back = static_cast<std::size_t>(contact.back_leaf);
        if (tree.is_solid[front] || tree.is_solid[back]) continue;
        const int a = tree.cluster_of_leaf[front];
        const int b = tree.cluster_of_leaf[back];
        if (a == b) continue;
        const auto collect = [&](const Passage& passage, const std::vector<Opening>& openings) {
            if (openings.empty()) return;
            std::vector<Opening>& all = passages[passage];
            all.insert(all.end(), openings.begin(), openings.end());
        };
        const int plane = build.plane_of_node[contact.node];
        collect({plane, a, b, false}, contact.backward);
        collect({plane, b, a, true}, contact.forward);
    }
    PortalGraph graph;
    graph.leaf_count = tree.cluster_count;
    for (auto& [passage, openings] : passages) {
        const ExactPlane& plane = build.planes[passage.plane];
        const double sign = passage.is_forward ? 1.0 : -1.0;
        const glm::dvec3 normal = sign * plane.unit_normal;
        for (Opening& opening : joined_by_hulls(std::move(openings), normal)) {
            if (glm::dot(area_vector(opening), normal) < 0.0) std::reverse(opening.begin(), opening.end());
            graph.portals.push_back(
                {passage.from, passage.to, normal, sign * plane.unit_offset * tree.grid.step_m, std::move(opening)});
        }
    }
    return graph;
}

std::vector<Box> leaf_boxes(const BspTree& tree, std::span<const LeafContact> contacts)
{
    std::vector<Box> boxes(static_cast<std::size_t>(tree.leaf_count));
    for (const LeafContact& contact : contacts) {
        boxes[static_cast<std::size_t>(contact.front_leaf)].add(contact.bounds);
        boxes[static_cast<std::size_t>(contact.back_leaf)].add(contact.bounds);
    }
    // A corner of a leaf lies on a contact, unless it is a corner of the whole box.
    const Box& whole = tree.bounds_world;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point((corner & 1) ? whole.max.x : whole.min.x, (corner & 2) ? whole.max.y : whole.min.y,
                               (corner & 4) ? whole.max.z : whole.min.z);
        boxes[static_cast<std::size_t>(leaf_at(tree, point))].add(point - tree.grid.origin_world);
    }
    return boxes;
}

std::vector<Box> cluster_boxes(const BspTree& tree, std::span<const Box> boxes_of_leaves)
{
    std::vector<Box> boxes(static_cast<std::size_t>(tree.cluster_count));
    for (std::size_t leaf = 0; leaf < boxes_of_leaves.size(); ++leaf)
        boxes[static_cast<std::size_t>(tree.cluster_of_leaf[leaf])].add(boxes_of_leaves[leaf]);
    for (Box& box : boxes) box = {box.min + tree.grid.origin_world, box.max + tree.grid.origin_world};
    return boxes;
}

}  // namespace hw
