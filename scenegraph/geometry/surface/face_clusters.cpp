#include "hatchway/geometry/surface/face_clusters.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <numeric>

#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// An edge that has found its cluster.
struct PlacedEdge {
    std::uint32_t cluster;
    std::uint32_t own_face;
    std::uint32_t other_face;
    std::uint32_t edge;

    bool is_inner() const { return other_face / FaceClusters::kFaces == cluster; }
};

namespace {

/// The reach of the planes of each cluster's own faces, to see which cluster an edge between two fits better.
struct Reach {
    RoundedPlane low, high;

    void add(const RoundedPlane& plane)
    {
        for (std::size_t i = 0; i < 4; ++i) {
            low[i] = std::min(low[i], plane[i]);
            high[i] = std::max(high[i], plane[i]);
        }
    }
    /// How much a box would grow. Normals count as an eye at three radii sees them.
    int growth(const RoundedPlane& plane) const
    {
        int sum = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            sum += (i < 3 ? 3 : 1) * std::max({0, low[i] - plane[i], plane[i] - high[i]});
        }
        return sum;
    }
};

std::vector<Reach> reaches_of(const Surface& surface, std::uint32_t cluster_count)
{
    std::vector<Reach> reaches(cluster_count);
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        const RoundedPlane plane = surface.filter.planes().at(face);
        Reach& reach = reaches[face / FaceClusters::kFaces];
        if (face % FaceClusters::kFaces == 0) reach = {plane, plane};
        reach.add(plane);
    }
    return reaches;
}

/// An edge between two clusters goes to the one whose box grows less by the other's face.
PlacedEdge placed(std::uint32_t edge, std::uint32_t face_a, std::uint32_t face_b, const StepBlocks& planes,
                  std::span<const Reach> reaches)
{
    const std::uint32_t a = face_a / FaceClusters::kFaces, b = face_b / FaceClusters::kFaces;
    const bool is_of_a = a == b || reaches[a].growth(planes.at(face_b)) <= reaches[b].growth(planes.at(face_a));
    return is_of_a ? PlacedEdge{a, face_a, face_b, edge} : PlacedEdge{b, face_b, face_a, edge};
}

constexpr std::size_t kOwnBlocks = FaceClusters::kFaces / StepBlocks::kPlaces;

std::size_t blocks_for(std::size_t bytes)
{
    return (bytes + sizeof(StepBlocks::Block) - 1) / sizeof(StepBlocks::Block);
}

/// Each once, rising.
std::vector<std::uint32_t> neighbours_of(std::span<const PlacedEdge> edges)
{
    std::vector<std::uint32_t> neighbours;
    for (const PlacedEdge& edge : edges) {
        if (!edge.is_inner()) neighbours.push_back(edge.other_face);
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    return neighbours;
}

/// All edges but loose ones, by cluster; those of a cluster by rising number.
std::vector<PlacedEdge> placed_edges(const Surface& surface, std::uint32_t cluster_count)
{
    const StepBlocks& planes = surface.filter.planes();
    const std::vector<Reach> reaches = reaches_of(surface, cluster_count);
    const EdgeRange range = surface.edges.two_faced();
    std::vector<PlacedEdge> edges;
    edges.reserve(range.size());
    for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
        const auto [a, b] = surface.edges[edge].faces();
        if (b < surface.faces.size()) edges.push_back(placed(edge, a, b, planes, reaches));
    }
    std::vector<std::uint32_t> next(cluster_count + 1, 0);
    for (const PlacedEdge& edge : edges) ++next[edge.cluster + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<PlacedEdge> sorted(edges.size());
    for (const PlacedEdge& edge : edges) sorted[next[edge.cluster]++] = edge;
    return sorted;
}

}  // namespace

FaceClusters::Cluster FaceClusters::cluster(std::uint32_t number) const
{
    const Record& record = records_[number];
    const Block* const planes = memory_.data() + record.first_block;
    const Block* const places = planes + kOwnBlocks + blocks_for(record.neighbour_count * sizeof(RoundedPlane));
    const Block* const edges = places + blocks_for(2 * record.edge_count * sizeof(Place));
    return {planes, record.neighbour_count, record.edge_count, reinterpret_cast<const Place*>(places),
            reinterpret_cast<const std::uint32_t*>(edges)};
}

void FaceClusters::prepare(const Surface& surface)
{
    count_ = static_cast<std::uint32_t>((surface.faces.size() + kFaces - 1) / kFaces);
    const std::vector<PlacedEdge> edges = placed_edges(surface, count_);
    const EdgeRange range = surface.edges.two_faced();
    for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
        if (surface.edges[edge].face_b >= surface.faces.size()) loose_edges_.push_back(edge);
    }
    std::vector<RoundedPlane> group;
    auto begin = edges.begin();
    for (std::uint32_t number = 0; number < count_; ++number) {
        const auto end = std::find_if(begin, edges.end(), [&](const PlacedEdge& e) { return e.cluster != number; });
        const std::vector<RoundedPlane> planes = add_cluster(surface, {begin, end});
        begin = end;
        cluster_boxes_.add(planes);
        group.insert(group.end(), planes.begin(), planes.end());
        if (number % kGroupClusters != kGroupClusters - 1 && number + 1 != count_) continue;
        group_boxes_.add(group);
        group.clear();
    }
    memory_.resize(memory_.size() + 2);  // places are read 64 at a time
}

std::vector<RoundedPlane> FaceClusters::add_cluster(const Surface& surface, std::span<const PlacedEdge> edges)
{
    const auto number = static_cast<std::uint32_t>(records_.size()), first = number * kFaces;
    const auto end = std::min(static_cast<std::uint32_t>(surface.faces.size()), first + kFaces);
    const std::vector<std::uint32_t> neighbours = neighbours_of(edges);
    records_.push_back({static_cast<std::uint32_t>(memory_.size()), static_cast<std::uint16_t>(neighbours.size()),
                        static_cast<std::uint16_t>(edges.size())});
    memory_.resize(memory_.size() + kOwnBlocks + blocks_for(neighbours.size() * sizeof(RoundedPlane)) +
                   blocks_for(2 * edges.size() * sizeof(Place)) + blocks_for(edges.size() * sizeof(std::uint32_t)));

    // cluster() tells where each part begins; the memory is ours to write.
    const Cluster parts = cluster(number);
    auto* const blocks = const_cast<Block*>(parts.planes);
    std::vector<RoundedPlane> planes;
    for (std::uint32_t face = first; face < end; ++face) planes.push_back(surface.filter.planes().at(face));
    for (const std::uint32_t face : neighbours) planes.push_back(surface.filter.planes().at(face));
    for (std::uint32_t i = 0; i < planes.size(); ++i)
        put_plane(planes[i], blocks, i < end - first ? i : i + kFaces - (end - first));
    auto* const places = const_cast<Place*>(parts.places);
    auto* const numbers = const_cast<std::uint32_t*>(parts.edges);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto at =
            std::lower_bound(neighbours.begin(), neighbours.end(), edges[i].other_face) - neighbours.begin();
        const auto other = edges[i].is_inner() ? edges[i].other_face % kFaces : kFaces + static_cast<std::uint32_t>(at);
        places[i] = static_cast<Place>(edges[i].own_face % kFaces);
        places[edges.size() + i] = static_cast<Place>(other);
        numbers[i] = edges[i].edge;
    }
    return planes;
}

std::uint32_t FaceClusters::find_mixed(const EyeSteps& eye, const SideBits& bits, std::span<std::uint32_t> mixed) const
{
    group_boxes_.decide(0, group_count(), eye, bits);
    std::uint32_t count = 0;
    for (std::uint32_t word = 0; 32 * word < group_count(); ++word) {
        for (std::uint32_t groups = bits.open[word]; groups != 0; groups &= groups - 1) {
            const std::uint32_t group = 32 * word + static_cast<std::uint32_t>(std::countr_zero(groups));
            const std::uint32_t first = group * kGroupClusters;
            std::uint32_t front = 0, open = 0;
            cluster_boxes_.decide(first, std::min(kGroupClusters, count_ - first), eye, {{&front, 1}, {&open, 1}});
            for (; open != 0; open &= open - 1) {
                mixed[count++] = first + static_cast<std::uint32_t>(std::countr_zero(open));
            }
        }
    }
    return count;
}

std::size_t FaceClusters::bytes() const
{
    return memory_.size() * sizeof(Block) + records_.size() * sizeof(Record) +
           loose_edges_.size() * sizeof(std::uint32_t) + cluster_boxes_.bytes() + group_boxes_.bytes();
}

}  // namespace hw
