// Every border is strewn into cells along its length, and every corner of a border asks its neighbourhood for the
// borders that it lies on.
#include "hatchway/geometry/topology/t_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <unordered_map>

namespace hw {
namespace {

constexpr std::uint64_t kMostLookedAt = 20'000'000;  // borders near corners; past that the rest stay as they are
constexpr std::uint32_t kMostSamples = 4096;
constexpr double kSmallestCell = 64.0;  // in tolerances
constexpr double kFoldedBack = 0.9;     // cosine between two faces of which one lies on the other

struct Border {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t apex;  ///< The third corner of its face.
    bool is_two_sided;
};

/// A corner on a border, away from its ends.
struct Junction {
    std::uint32_t border;
    std::uint32_t position;
    double along;     ///< From the border's beginning.
    bool is_against;  ///< A border there runs the other way.
    bool goes_on;     ///< A border there has its face elsewhere than this one has it.
};

std::uint64_t key_of(std::uint32_t a, std::uint32_t b)
{
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

class TJunctions {
 public:
    TJunctions(std::span<const glm::vec3> positions, std::span<const FaceCorners> faces,
               std::span<const DirectedEdge> uses, const std::vector<bool>& two_sided_faces, float tolerance)
        : positions_(positions), tolerance_(tolerance)
    {
        for_each_edge(uses, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() > 1) return;
            const auto& [low, high, face, corner, is_forward] = edge[0];
            const bool is_two_sided = !two_sided_faces.empty() && two_sided_faces[face];
            borders_.push_back(
                {is_forward ? low : high, is_forward ? high : low, faces[face][(corner + 2) % 3], is_two_sided});
        });
        // By place, so that the order of faces decides nothing.
        std::sort(borders_.begin(), borders_.end(), [&](const Border& a, const Border& b) {
            return a.from != b.from ? is_before(a.from, b.from) : is_before(a.to, b.to);
        });
        for (std::uint32_t i = 0; i < borders_.size(); ++i) {
            at_[borders_[i].from].push_back(i);
            at_[borders_[i].to].push_back(i);
        }
    }

    /// In the order of borders, then along each.
    std::vector<Junction> find()
    {
        strew();
        for (std::uint32_t border = 0; border < borders_.size(); ++border)
            for (const std::uint32_t end : {borders_[border].from, borders_[border].to})
                if (at_[end].front() == border) look_around(end);
        std::sort(found_.begin(), found_.end(), [this](const Junction& a, const Junction& b) {
            if (a.border != b.border) return a.border < b.border;
            return a.along != b.along ? a.along < b.along : is_before(a.position, b.position);
        });
        const auto repeats = [&](const Junction& a, const Junction& b) {
            return a.border == b.border && (a.position == b.position || b.along - a.along <= tolerance_);
        };
        found_.erase(std::unique(found_.begin(), found_.end(), repeats), found_.end());
        return std::move(found_);
    }

    const Border& border(std::uint32_t index) const { return borders_[index]; }

 private:
    glm::dvec3 place(std::uint32_t position) const { return glm::dvec3(positions_[position]); }
    bool is_before(std::uint32_t a, std::uint32_t b) const
    {
        const glm::vec3 &p = positions_[a], &q = positions_[b];
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    }
    double length(const Border& border) const { return glm::distance(place(border.from), place(border.to)); }

    static std::uint64_t cell_key(const glm::dvec3& cell)
    {
        const auto part = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) & 0x1fffff; };
        return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);  // cells that share a key cost comparisons only
    }

    void strew()
    {
        double sum = 0.0;
        for (const Border& border : borders_) sum += length(border);
        cell_ = std::max(kSmallestCell * tolerance_, sum / std::max(1.0, static_cast<double>(borders_.size())));
        for (std::uint32_t i = 0; i < borders_.size(); ++i) {
            const double own = length(borders_[i]);
            if (own <= 2.0 * tolerance_) continue;
            const auto count = static_cast<std::uint32_t>(std::min(1.0 * kMostSamples, 1.0 + 2.0 * own / cell_));
            const glm::dvec3 from = place(borders_[i].from), to = place(borders_[i].to);
            std::uint64_t last = ~std::uint64_t{0};
            for (std::uint32_t k = 0; k <= count; ++k) {
                const std::uint64_t key =
                    cell_key(glm::floor(glm::mix(from, to, static_cast<double>(k) / count) / cell_));
                if (key != last) cells_[key].push_back(i);
                last = key;
            }
        }
    }

    /// Samples are half a cell apart, so that a point of a border is within a quarter of a cell of one of them.
    void look_around(std::uint32_t position)
    {
        const double reach = 0.25 * cell_ + tolerance_;
        const glm::dvec3 low = glm::floor((place(position) - reach) / cell_),
                         high = glm::floor((place(position) + reach) / cell_);
        seen_.clear();
        for (double x = low.x; x <= high.x; ++x)
            for (double y = low.y; y <= high.y; ++y)
                for (double z = low.z; z <= high.z; ++z) {
                    const auto cell = cells_.find(cell_key({x, y, z}));
                    if (cell == cells_.end() || looked_at_ > kMostLookedAt) continue;
                    looked_at_ += cell->second.size();
                    seen_.insert(seen_.end(), cell->second.begin(), cell->second.end());
                }
        std::sort(seen_.begin(), seen_.end());
        seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
        for (const std::uint32_t border : seen_) look_at(border, position);
    }

    void look_at(std::uint32_t index, std::uint32_t position)
    {
        const Border& border = borders_[index];
        looked_at_ += at_[position].size();
        if (looked_at_ > kMostLookedAt) return;
        if (position == border.from || position == border.to) return;
        const glm::dvec3 from = place(border.from);
        const double own = length(border);
        const glm::dvec3 direction = (place(border.to) - from) / own;
        const double along = glm::dot(place(position) - from, direction);
        if (along <= tolerance_ || along >= own - tolerance_) return;
        const auto is_on_line = [&](std::uint32_t p) {
            const glm::dvec3 offset = place(p) - from;
            return glm::length(offset - glm::dot(offset, direction) * direction) <= tolerance_;
        };
        if (!is_on_line(position)) return;
        Junction junction{index, position, along, false, false};
        for (const std::uint32_t other : at_[position]) {
            const Border& b = borders_[other];
            if (other == index || !is_on_line(b.from) || !is_on_line(b.to)) continue;
            const bool has_direction = !border.is_two_sided && !b.is_two_sided;
            junction.is_against |= has_direction && glm::dot(place(b.to) - place(b.from), direction) < 0.0;
            junction.goes_on |= glm::dot(across(border, direction), across(b, direction)) < kFoldedBack;
        }
        if (junction.is_against || junction.goes_on) found_.push_back(junction);
    }

    /// From the border to its face, at right angles to `direction`.
    glm::dvec3 across(const Border& border, const glm::dvec3& direction) const
    {
        const glm::dvec3 apex = place(border.apex) - place(border.from);
        const glm::dvec3 offset = apex - glm::dot(apex, direction) * direction;
        const double length = glm::length(offset);
        return length > 0.0 ? offset / length : offset;
    }

    std::span<const glm::vec3> positions_;
    double tolerance_;
    double cell_ = 1.0;
    std::vector<Border> borders_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at_;     // position -> borders that end there
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;  // -> borders
    std::vector<std::uint32_t> seen_;
    std::vector<Junction> found_;
    std::uint64_t looked_at_ = 0;
};

/// Puts caps on borders, as long as no edge gets more than two faces by them.
class Caps {
 public:
    /// Two-sided faces count as wound both ways.
    Caps(std::vector<FaceCorners>& faces, std::span<const DirectedEdge> uses, const std::vector<bool>& two_sided_faces)
        : faces_(faces)
    {
        for (const DirectedEdge& use : uses) {
            Uses& counts = uses_[key_of(use.low, use.high)];
            const bool is_two_sided = !two_sided_faces.empty() && two_sided_faces[use.face];
            ++counts.faces;
            for (const bool is_forward : {false, true})
                counts.wound[is_forward] += is_two_sided || use.is_forward == is_forward;
        }
    }

    /// `with_winding`: only where both faces of each edge wind alike.
    bool add(const Border& border, std::span<const Junction> junctions, bool with_winding)
    {
        std::vector<FaceCorners> caps;
        std::uint32_t last = border.from;
        for (const Junction& junction : junctions) {
            caps.push_back({border.to, last, junction.position});
            last = junction.position;
        }
        for (std::size_t i = 0; i < caps.size(); ++i) {
            if (use(caps[i], with_winding)) continue;
            for (std::size_t k = 0; k <= i; ++k) take_back(caps[k]);
            return false;
        }
        faces_.insert(faces_.end(), caps.begin(), caps.end());
        return true;
    }

 private:
    struct Uses {
        std::array<std::uint32_t, 2> wound{};  ///< Backward, forward.
        std::uint32_t faces = 0;
    };

    bool use(const FaceCorners& cap, bool with_winding)
    {
        bool is_free = true;
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t from = cap[i], to = cap[(i + 1) % 3];
            Uses& counts = uses_[key_of(from, to)];
            const bool winds_alike = ++counts.wound[from < to] == 1;
            is_free &= ++counts.faces <= 2 && (winds_alike || !with_winding);
        }
        return is_free;
    }
    void take_back(const FaceCorners& cap)
    {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t from = cap[i], to = cap[(i + 1) % 3];
            Uses& counts = uses_[key_of(from, to)];
            --counts.wound[from < to];
            --counts.faces;
        }
    }

    std::vector<FaceCorners>& faces_;
    std::unordered_map<std::uint64_t, Uses> uses_;
};

/// A border with its junctions.
using JunctionRun = std::span<const Junction>;

std::vector<JunctionRun> runs_of(std::span<const Junction> junctions)
{
    std::vector<JunctionRun> runs;
    for (std::size_t begin = 0, end = 0; begin < junctions.size(); begin = end) {
        while (end < junctions.size() && junctions[end].border == junctions[begin].border) ++end;
        runs.push_back(junctions.subspan(begin, end - begin));
    }
    return runs;
}

/// Caps a border at those of its junctions that are such.
template <typename IsSuch>
bool cap_at(Caps& caps, const Border& border, JunctionRun run, bool with_winding, const IsSuch& is_such)
{
    std::vector<Junction> such;
    std::copy_if(run.begin(), run.end(), std::back_inserter(such), is_such);
    return !such.empty() && caps.add(border, such, with_winding);
}

bool cap_against(Caps& caps, const Border& border, JunctionRun run)
{
    return cap_at(caps, border, run, true, [](const Junction& junction) { return junction.is_against; });
}

bool cap_any_way(Caps& caps, const Border& border, JunctionRun run)
{
    return cap_at(caps, border, run, false, [](const Junction& junction) { return junction.goes_on; });
}

/// Of each face, whether each edge of all that is connected with it has two faces.
std::vector<bool> faces_of_closed(std::span<const FaceCorners> faces)
{
    const std::vector<DirectedEdge> uses = sorted_directed_edges(faces);
    const std::vector<FaceCorners> neighbours = face_neighbours(faces.size(), uses);
    std::vector<bool> is_closed(faces.size(), false), is_seen(faces.size(), false);
    std::vector<std::uint32_t> component;
    for (std::uint32_t seed = 0; seed < faces.size(); ++seed) {
        if (is_seen[seed]) continue;
        bool is_whole = is_seen[seed] = true;
        component.assign({seed});
        for (std::size_t next = 0; next < component.size(); ++next)
            for (const std::uint32_t other : neighbours[component[next]]) {
                is_whole &= other != kNoFace;
                if (other == kNoFace || is_seen[other]) continue;
                is_seen[other] = true;
                component.push_back(other);
            }
        if (is_whole)
            for (const std::uint32_t face : component) is_closed[face] = true;
    }
    return is_closed;
}

/// Which borders belong to what is closed once they are capped whichever way their neighbours run.
std::vector<bool> runs_that_close(const TJunctions& search, std::span<const JunctionRun> runs,
                                  std::vector<FaceCorners> faces, std::span<const DirectedEdge> uses,
                                  const std::vector<bool>& two_sided_faces)
{
    Caps caps(faces, uses, two_sided_faces);
    std::vector<std::size_t> first_cap(runs.size(), faces.size());
    std::vector<bool> is_capped(runs.size(), false);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        first_cap[i] = faces.size();
        is_capped[i] = cap_any_way(caps, search.border(runs[i][0].border), runs[i]);
    }
    const std::vector<bool> is_closed = faces_of_closed(faces);
    for (std::size_t i = 0; i < runs.size(); ++i) is_capped[i] = is_capped[i] && is_closed[first_cap[i]];
    return is_capped;
}

}  // namespace

std::uint32_t close_t_junctions(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                                std::span<const DirectedEdge> uses, const std::vector<bool>& two_sided_faces,
                                float tolerance)
{
    if (!(tolerance > 0.0f)) return 0;
    TJunctions search(positions, faces, uses, two_sided_faces, tolerance);
    const std::vector<Junction> junctions = search.find();
    if (junctions.empty()) return 0;
    const std::vector<JunctionRun> runs = runs_of(junctions);
    const std::vector<bool> does_close = runs_that_close(search, runs, faces, uses, two_sided_faces);
    Caps caps(faces, uses, two_sided_faces);
    std::uint32_t closed = 0;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (does_close[i]) closed += cap_any_way(caps, search.border(runs[i][0].border), runs[i]);
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (!does_close[i]) closed += cap_against(caps, search.border(runs[i][0].border), runs[i]);
    return closed;
}

}  // namespace hw
