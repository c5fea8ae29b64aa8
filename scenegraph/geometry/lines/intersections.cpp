// Faces are paired by trees over their boxes. Two faces cut each other in a segment whose ends are each an edge of one
// through the other: which edge pierces which face is decided for the edge and the face alone, whatever face of the
// edge asks, and so neighbours name the same joints. Ties (a vertex in a plane, edges that touch) are decided as if the
// second object were moved by (e, e^2, e^3) for an e as small as is needed: no tie is left, and all answers fit
// together. Source: Edelsbrunner, Muecke. Simulation of Simplicity. ACM Transactions on Graphics 9, 1990, for the idea.
#include "hatchway/geometry/lines/intersections.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <tuple>

#include "hatchway/core/box.hpp"
#include "hatchway/core/disjoint_sets.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/geometry/exact/predicates.hpp"
#include "hatchway/geometry/lines/face_tree.hpp"

namespace hw {
namespace {

constexpr double kOnePlace = 1e-12;  // in sizes of the objects: cuts this short have no length
// Work of all pairs together: so many boxes found, four times as many looked at, or fewer where faces ask, are tested
// and cut each other.
constexpr std::uint64_t kMostWork = 400'000'000;
constexpr std::uint64_t kWorkOfFace = 16, kWorkOfTest = 16, kWorkOfCut = 200;
constexpr std::size_t kFacesAtOnce = 2048;
constexpr std::size_t kMostFaces = 8'000'000;  // of all objects; each takes over a hundred bytes
constexpr std::size_t kPairsAtOnce = 16;
constexpr double kNearlyCoplanar = 0.01;  // sine of the angle below which faces that touch only graze each other

/// An object in the world.
struct Placed {
    const Surface* surface = nullptr;
    std::vector<glm::dvec3> positions;
    std::vector<Box> boxes;         ///< Of the faces, until the tree has them.
    std::optional<FaceTree> faces;  ///< Those that may meet another object, or another component of this one.
    Box box;
    std::vector<char> does_meet_component;  ///< For each face, whether its box meets that of another component.
};

/// Those that the work does not reach are taken to meet another.
std::vector<char> faces_that_meet_components(const Placed& object, std::uint64_t most_work)
{
    const Surface& surface = *object.surface;
    std::vector<char> result(object.boxes.size(), 0);
    if (surface.components.size() < 2) return result;
    std::vector<Box> boxes(surface.components.size());
    for (std::size_t face = 0; face < object.boxes.size(); ++face)
        boxes[surface.face_component[face]].add(object.boxes[face]);
    const FaceTree components(std::move(boxes));
    std::vector<std::uint32_t> found;
    std::uint64_t work = 0;
    for (std::size_t face = 0; face < object.boxes.size(); ++face) {
        found.clear();
        if (work <= most_work) work += components.find(object.boxes[face], found, 2);
        result[face] = found.size() != 1;  // one is its own
    }
    return result;
}

Placed placed(const LineObject& object, std::uint64_t most_work)
{
    Placed result{.surface = object.surface};
    for (const glm::vec3& p : object.surface->positions)
        result.positions.emplace_back(object.world_from_object * glm::dvec4(glm::dvec3(p), 1.0));
    for (const auto& face : object.surface->faces) {
        Box box;
        for (const std::uint32_t corner : face) box.add(result.positions[corner]);
        result.boxes.push_back(box);
        result.box.add(box.min);
        result.box.add(box.max);
    }
    result.does_meet_component = faces_that_meet_components(result, most_work);
    return result;
}

/// An edge of one object through a face of the other: the same for all faces of the edge.
struct Joint {
    bool is_of_first = true;  ///< The edge is the first object's.
    std::uint32_t low = 0, high = 0, face = 0;
    auto operator<=>(const Joint&) const = default;
};

struct Cut {
    std::array<std::uint32_t, 2> faces{};
    std::array<Joint, 2> joints{};
    std::array<glm::dvec3, 2> ends{};
    double depth = 0.0;  ///< How far the faces go through each other's planes.
};

/// The sign of a change that has this gradient when the second object moves by (e, e^2, e^3).
bool does_rise(const glm::dvec3& gradient)
{
    for (int axis = 0; axis < 3; ++axis)
        if (gradient[axis] != 0.0) return gradient[axis] > 0.0;
    return true;
}

/// All cuts between two objects, or between the components of one: there a lower component is the first. None where
/// that takes more than `most_work`.
class PairCuts {
 public:
    PairCuts(const Placed& first, const Placed& second, std::uint64_t most_work)
        : objects_{&first, &second}, most_work_(most_work)
    {
    }

    bool has_given_up() const { return work_ > most_work_; }
    std::uint64_t work() const { return work_; }

    std::vector<Cut> run()
    {
        std::array<std::vector<std::uint32_t>, 2> near{near_faces(0), is_alone() ? near_faces(0) : near_faces(1)};
        const int side = near[0].size() <= near[1].size() ? 0 : 1;
        const std::vector<std::uint32_t>& asking = near[side];
        if (has_given_up()) return {};
        std::vector<std::vector<Cut>> parts((asking.size() + kFacesAtOnce - 1) / kFacesAtOnce);
        tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
            const std::size_t first = i * kFacesAtOnce;
            parts[i] = cuts_of(side, std::span(asking).subspan(first, std::min(kFacesAtOnce, asking.size() - first)));
        });
        if (has_given_up()) return {};
        std::vector<Cut> cuts;
        for (const std::vector<Cut>& part : parts) cuts.insert(cuts.end(), part.begin(), part.end());
        std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.faces < b.faces; });
        return cuts;
    }

 private:
    bool is_alone() const { return objects_[0] == objects_[1]; }
    std::uint32_t component(std::uint32_t face) const { return objects_[0]->surface->face_component[face]; }
    const Box& box(int side, std::uint32_t face) const { return objects_[side]->faces->boxes()[face]; }

    /// The faces of one side that may meet the other: of an object alone those that come near another component.
    std::vector<std::uint32_t> near_faces(int side)
    {
        std::vector<std::uint32_t> near;
        work_ += objects_[side]->faces->find(objects_[1 - side]->box, near);
        if (is_alone())
            std::erase_if(near, [&](std::uint32_t face) { return !objects_[0]->does_meet_component[face]; });
        return near;
    }

    /// The cuts of some faces of `side` with those of the other that their boxes meet.
    std::vector<Cut> cuts_of(int side, std::span<const std::uint32_t> faces)
    {
        std::vector<Cut> cuts;
        std::vector<std::uint32_t> met;
        for (const std::uint32_t face : faces) {
            if (has_given_up()) break;
            met.clear();
            std::uint64_t work = kWorkOfFace + objects_[1 - side]->faces->find(box(side, face), met, most_work_);
            for (const std::uint32_t other : met) {
                if (is_alone() && component(face) >= component(other)) continue;
                const auto cut = side == 0 ? cut_of(face, other) : cut_of(other, face);
                work += kWorkOfTest + (cut ? kWorkOfCut : 0);
                if (cut) cuts.push_back(*cut);
            }
            work_ += work;
        }
        return cuts;
    }

    const glm::dvec3& corner(int side, std::uint32_t face, int index) const
    {
        return objects_[side]->positions[objects_[side]->surface->faces[face][index]];
    }

    /// Sides of the corners of a face: true is before the plane of the other object's face.
    std::array<bool, 3> sides(int side, std::uint32_t face, std::uint32_t plane) const
    {
        const glm::dvec3 &a = corner(1 - side, plane, 0), &b = corner(1 - side, plane, 1),
                         &c = corner(1 - side, plane, 2);
        std::array<bool, 3> result;
        for (int i = 0; i < 3; ++i) {
            const int sign = orient3d_sign(a, b, c, corner(side, face, i));
            const double moves = side == 1 ? 1.0 : -1.0;
            result[i] = sign != 0 ? sign > 0 : does_rise(moves * glm::cross(b - a, c - a));
        }
        return result;
    }

    double distance(int side, std::uint32_t face, const glm::dvec3& point) const
    {
        const glm::dvec3& a = corner(side, face, 0);
        const glm::dvec3 normal = glm::cross(corner(side, face, 1) - a, corner(side, face, 2) - a);
        const double length = glm::length(normal);
        return length > 0.0 ? glm::dot(normal, point - a) / length : 0.0;
    }

    /// Whether an edge, from its lower vertex to its higher, passes an edge of the other object on the left.
    bool is_left(int side, std::uint32_t low, std::uint32_t high, std::uint32_t from, std::uint32_t to) const
    {
        const auto& own = objects_[side]->positions;
        const auto& other = objects_[1 - side]->positions;
        const auto [begin, end] = std::minmax(from, to);
        const int sign = orient3d_sign(own[low], own[high], other[begin], other[end]);
        const double moves = side == 0 ? 1.0 : -1.0;
        const bool is_positive =
            sign != 0 ? sign > 0 : does_rise(moves * glm::cross(own[high] - own[low], other[begin] - other[end]));
        return is_positive == (from < to);
    }

    bool does_pierce(const Joint& joint) const
    {
        const int side = joint.is_of_first ? 0 : 1;
        const auto& [a, b, c] = objects_[1 - side]->surface->faces[joint.face];
        const bool ab = is_left(side, joint.low, joint.high, a, b), bc = is_left(side, joint.low, joint.high, b, c),
                   ca = is_left(side, joint.low, joint.high, c, a);
        return ab == bc && bc == ca;
    }

    /// Appends where edges of `face` go through `plane`.
    void add_ends(int side, std::uint32_t face, std::uint32_t plane, const std::array<bool, 3>& is_before, Cut& cut,
                  int& count) const
    {
        const auto& corners = objects_[side]->surface->faces[face];
        for (int i = 0; i < 3 && count < 2; ++i) {
            const int next = (i + 1) % 3;
            if (is_before[i] == is_before[next]) continue;
            const auto [low, high] = std::minmax(corners[i], corners[next]);
            const Joint joint{side == 0, low, high, plane};
            if (!does_pierce(joint)) continue;
            const glm::dvec3 &from = objects_[side]->positions[low], &to = objects_[side]->positions[high];
            const double begin = distance(1 - side, plane, from), end = distance(1 - side, plane, to);
            const double t = begin == end ? 0.5 : std::clamp(begin / (begin - end), 0.0, 1.0);
            cut.joints[count] = joint;
            cut.ends[count++] = glm::mix(from, to, t);
        }
    }

    /// The smaller of how far a face reaches before and behind a plane.
    double depth(int side, std::uint32_t face, std::uint32_t plane) const
    {
        double before = 0.0, behind = 0.0;
        for (int i = 0; i < 3; ++i) {
            const double at = distance(1 - side, plane, corner(side, face, i));
            before = std::max(before, at);
            behind = std::max(behind, -at);
        }
        return std::min(before, behind);
    }

    std::optional<Cut> cut_of(std::uint32_t first, std::uint32_t second) const
    {
        const auto all_same = [](const std::array<bool, 3>& s) { return s[0] == s[1] && s[1] == s[2]; };
        const auto first_sides = sides(0, first, second);
        if (all_same(first_sides)) return std::nullopt;
        const auto second_sides = sides(1, second, first);
        if (all_same(second_sides)) return std::nullopt;
        Cut cut{{first, second}, {}, {}, std::min(depth(0, first, second), depth(1, second, first))};
        int count = 0;
        add_ends(0, first, second, first_sides, cut, count);
        add_ends(1, second, first, second_sides, cut, count);
        return count < 2 ? std::nullopt : std::optional(cut);
    }

    std::array<const Placed*, 2> objects_;
    std::uint64_t most_work_;
    std::atomic<std::uint64_t> work_{0};
};

/// Numbers for joints, and which cuts hang together.
class CutGroups {
 public:
    std::uint32_t joint(const Joint& joint)
    {
        const auto [at, is_new] = ids_.try_emplace(joint, sets_.size());
        if (is_new) {
            sets_.add();
            depth_.push_back(0.0);
        }
        return at->second;
    }
    void join(std::uint32_t a, std::uint32_t b, double depth)
    {
        depth = std::max({depth_[find(a)], depth_[find(b)], depth});
        depth_[sets_.join(a, b)] = depth;
    }
    double depth_of(std::uint32_t joint) { return depth_[find(joint)]; }
    std::uint32_t size() const { return sets_.size(); }
    std::uint32_t find(std::uint32_t index) { return sets_.of(index); }

 private:
    std::map<Joint, std::uint32_t> ids_;
    DisjointSets sets_;
    std::vector<double> depth_;
};

/// Whether two faces lie in almost one plane: where they cut each other is a matter of rounding.
bool do_graze(const Placed& a, std::uint32_t face_a, const Placed& b, std::uint32_t face_b)
{
    const auto normal = [](const Placed& object, std::uint32_t face) {
        const auto& [p, q, r] = object.surface->faces[face];
        const glm::dvec3 area =
            glm::cross(object.positions[q] - object.positions[p], object.positions[r] - object.positions[p]);
        const double length = glm::length(area);
        return length > 0.0 ? area / length : glm::dvec3(0.0);
    };
    return glm::length(glm::cross(normal(a, face_a), normal(b, face_b))) < kNearlyCoplanar;
}

/// Appends the cuts of a pair as lines, joints counted from `first_joint`; returns how many joints there are.
std::uint32_t append_lines(const Placed& a, const Placed& b, const std::array<std::uint32_t, 2>& pair,
                           const std::vector<Cut>& cuts, std::uint32_t first_joint, const IntersectionOptions& options,
                           std::vector<IntersectionLine>& lines)
{
    const double size = std::max(glm::length(a.box.size()), glm::length(b.box.size()));
    const double contact = options.contact_share * size;
    CutGroups groups, places;
    for (const Cut& cut : cuts) {
        const std::uint32_t from = groups.joint(cut.joints[0]), to = groups.joint(cut.joints[1]);
        groups.join(from, to, cut.depth);
        // Where an edge meets an edge, a cut has no length and its ends are one place.
        places.joint(cut.joints[0]);
        places.joint(cut.joints[1]);
        if (glm::distance(cut.ends[0], cut.ends[1]) <= kOnePlace * size) places.join(from, to, 0.0);
    }
    for (const Cut& cut : cuts) {
        const std::uint32_t from = groups.joint(cut.joints[0]), to = groups.joint(cut.joints[1]);
        if (groups.depth_of(from) <= contact) continue;
        if (cut.depth <= contact && do_graze(a, cut.faces[0], b, cut.faces[1])) continue;
        if (glm::distance(cut.ends[0], cut.ends[1]) <= kOnePlace * size) continue;
        const std::array<std::uint32_t, 2> joints{first_joint + places.find(from), first_joint + places.find(to)};
        lines.push_back({pair, cut.faces, cut.ends, joints});
    }
    return groups.size();
}

using Pair = std::array<std::uint32_t, 2>;

/// Pairs of objects whose boxes meet and of which one shows such lines, sorted; no more than work can be done for.
std::vector<Pair> meeting_pairs(std::span<const LineObject> objects, const std::vector<Placed>& world,
                                std::uint64_t& left_out)
{
    constexpr std::size_t kMostPairs = kMostWork / kWorkOfCut, kMostFound = 20'000'000;
    std::size_t found_left = kMostFound;
    std::vector<Box> boxes;
    for (const Placed& object : world) boxes.push_back(object.box);
    const FaceTree tree(std::move(boxes));
    std::vector<Pair> pairs;
    std::vector<std::uint32_t> found;
    for (std::uint32_t a = 0; a < objects.size(); ++a) {
        if (shows_intersections(objects[a]) && objects[a].surface->components.size() > 1) pairs.push_back({a, a});
        found.clear();
        tree.find(world[a].box, found, found_left);
        found_left -= std::min(found_left, found.size());
        if (found_left == 0) {
            left_out += objects.size() - a;
            break;
        }
        std::sort(found.begin(), found.end());
        for (const std::uint32_t b : found) {
            if (b <= a || !(shows_intersections(objects[a]) || shows_intersections(objects[b]))) continue;
            if (pairs.size() == kMostPairs) {
                ++left_out;
                continue;
            }
            pairs.push_back({a, b});
        }
    }
    return pairs;
}

/// The faces that triangles of the model are, and whose boxes meet one of `others` or another component.
std::vector<std::uint32_t> faces_that_may_meet(const Placed& object, std::vector<Box> others)
{
    const FaceTree tree(std::move(others));
    std::vector<std::uint32_t> result, found;
    for (std::uint32_t face = 0; face < object.boxes.size(); ++face) {
        if (object.surface->face_triangle[face] == kNoFace) continue;
        found.clear();
        if (!object.does_meet_component[face]) tree.find(object.boxes[face], found, 1);
        if (object.does_meet_component[face] || !found.empty()) result.push_back(face);
    }
    return result;
}

/// Gives trees to the objects of the pairs.
void grow_trees(std::vector<Placed>& world, std::span<const Pair> pairs)
{
    std::vector<char> is_wanted(world.size(), 0);
    std::vector<std::vector<Box>> others(world.size());
    for (const auto& [a, b] : pairs) {
        is_wanted[a] = is_wanted[b] = 1;
        if (a == b) continue;
        others[a].push_back(world[b].box);
        others[b].push_back(world[a].box);
    }
    tbb::parallel_for(std::size_t{0}, world.size(), [&](std::size_t i) {
        if (!is_wanted[i]) return;
        std::vector<std::uint32_t> faces = faces_that_may_meet(world[i], std::move(others[i]));
        world[i].faces.emplace(std::move(world[i].boxes), std::move(faces));
    });
}

/// The cuts of a few pairs, and whether each has them.
struct CutsAtOnce {
    std::array<std::vector<Cut>, kPairsAtOnce> cuts;
    std::array<std::uint64_t, kPairsAtOnce> work{};
    std::array<bool, kPairsAtOnce> is_left_out{};
};

CutsAtOnce cuts_of(const std::vector<Placed>& world, std::span<const Pair> pairs, std::uint64_t work_left)
{
    CutsAtOnce result;
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
        PairCuts search(world[pairs[i][0]], world[pairs[i][1]], work_left / 4);
        result.cuts[i] = search.run();
        result.work[i] = std::min(search.work(), work_left / 4);  // where it gave up, threads differ in when
        result.is_left_out[i] = search.has_given_up();
    });
    return result;
}

}  // namespace

std::vector<IntersectionLine> find_intersections(std::span<const LineObject> objects,
                                                 const IntersectionOptions& options)
{
    std::size_t faces = 0;
    for (const LineObject& object : objects) faces += object.surface->faces.size();
    if (faces > kMostFaces) {
        log_warning(
            fmt::format("{} triangles are too many for lines where objects cut each other; they are left out", faces));
        return {};
    }
    std::vector<Placed> world(objects.size());
    tbb::parallel_for(std::size_t{0}, objects.size(),
                      [&](std::size_t i) { world[i] = placed(objects[i], kMostWork / objects.size()); });
    std::uint64_t left_out = 0;
    const std::vector<Pair> pairs = meeting_pairs(objects, world, left_out);
    grow_trees(world, pairs);
    const std::uint64_t pair_count = pairs.size() + left_out;
    std::vector<IntersectionLine> lines;
    std::uint32_t first_joint = 0;
    std::uint64_t work_left = kMostWork;
    for (std::size_t first = 0; first < pairs.size(); first += kPairsAtOnce) {
        if (work_left < kWorkOfCut) {
            left_out += pairs.size() - first;
            break;
        }
        const auto some = std::span(pairs).subspan(first, std::min(kPairsAtOnce, pairs.size() - first));
        const CutsAtOnce found = cuts_of(world, some, work_left);
        for (std::size_t i = 0; i < some.size(); ++i) {
            first_joint +=
                append_lines(world[some[i][0]], world[some[i][1]], some[i], found.cuts[i], first_joint, options, lines);
            work_left -= std::min(work_left, found.work[i]);
            left_out += found.is_left_out[i];
        }
    }
    if (left_out > 0)
        log_warning(
            fmt::format("{} of {} or more pairs of objects that may cut each other are left without lines there: the "
                        "work for all would be too much",
                        left_out, pair_count));
    return lines;
}

}  // namespace hw
