// Each line of the drawing is cut where any line on it begins or ends. In each piece all faces of all objects that meet
// there are looked at together: the piece is a seam when the visible surface goes straight on across it.
#include "hatchway/geometry/lines/seams.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <map>

#include "hatchway/geometry/lines/cross_section.hpp"
#include "hatchway/geometry/lines/line_groups.hpp"
#include "hatchway/geometry/lines/overlaps.hpp"
#include "hatchway/geometry/surface/surface_faces.hpp"
#include "hatchway/geometry/topology/directed_edges.hpp"

namespace hw {
namespace {

constexpr std::uint64_t kMostLookedAt = 20'000'000;    // lines in pieces; past that none is a seam
constexpr std::uint64_t kMostTriangles = 100'000'000;  // looked at for overlaps; past that all lines stay
constexpr std::size_t kLinesTogether = 1024;           // between two looks at that

/// One face at one line of a surface, object space.
struct EdgeSide {
    std::uint32_t edge;
    std::uint32_t apex;  // the corner of the face's plane that is farthest from the line
    bool is_forward;     // the face runs along the edge as the table states it
    bool is_two_sided;   // whatever the object says
    bool is_of_solid;    // of a closed surface: nobody sees its back, whatever the object says
};

std::uint32_t apex_of(const Surface& surface, std::uint32_t face, const std::array<std::uint32_t, 2>& ends)
{
    const glm::dvec3 from = surface.positions[ends[0]], along = glm::dvec3(surface.positions[ends[1]]) - from;
    std::uint32_t apex = kNoFace;
    double farthest = 0.0;
    const std::uint32_t plane = plane_face(surface, face);
    if (plane == kNoFace) return kNoFace;
    for (const std::uint32_t corner : surface.faces[plane]) {
        const double distance = glm::length(glm::cross(along, glm::dvec3(surface.positions[corner]) - from));
        if (distance > farthest) {
            farthest = distance;
            apex = corner;
        }
    }
    return apex;
}

/// Edges by their vertices.
class EdgesByEnds {
 public:
    EdgesByEnds(const Surface& surface, std::span<const EdgeRange> ranges) : first_(surface.positions.size() + 1, 0)
    {
        for_each(surface, ranges, [&](std::uint32_t low, Entry) { ++first_[low + 1]; });
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        entries_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for_each(surface, ranges, [&](std::uint32_t low, Entry entry) { entries_[next[low]++] = entry; });
        for (std::size_t i = 0; i + 1 < first_.size(); ++i)
            std::stable_sort(entries_.begin() + first_[i], entries_.begin() + first_[i + 1], is_before);
    }

    /// kNoFace where there is none; the last of several.
    std::uint32_t find(std::uint32_t a, std::uint32_t b) const
    {
        const auto [low, high] = std::minmax(a, b);
        const auto begin = entries_.begin() + first_[low], end = entries_.begin() + first_[low + 1];
        const auto after = std::upper_bound(begin, end, Entry{high, 0}, is_before);
        return after != begin && (after - 1)->high == high ? (after - 1)->edge : kNoFace;
    }

 private:
    struct Entry {
        std::uint32_t high;
        std::uint32_t edge;
    };
    static bool is_before(const Entry& a, const Entry& b) { return a.high < b.high; }
    template <typename Use>
    static void for_each(const Surface& surface, std::span<const EdgeRange> ranges, Use&& use)
    {
        for (const EdgeRange& range : ranges) {
            for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
                const auto [a, b] = edge_vertices(surface, edge);
                use(std::min(a, b), Entry{std::max(a, b), edge});
            }
        }
    }

    std::vector<std::uint32_t> first_;  // of the entries of each lower vertex
    std::vector<Entry> entries_;
};

/// The faces at every line that is drawn from all viewpoints.
std::vector<EdgeSide> sides_of_lines(const Surface& surface, float crease_rad)
{
    const EdgeClasses classes = classes_at(surface, crease_rad);
    std::vector<EdgeRange> ranges{classes.borders};
    ranges.insert(ranges.end(), classes.ridges.begin(), classes.ridges.end());
    ranges.insert(ranges.end(), classes.valleys.begin(), classes.valleys.end());
    ranges.insert(ranges.end(), classes.artist.begin(), classes.artist.end());
    const EdgesByEnds edges(surface, ranges);

    std::vector<EdgeSide> sides;
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = surface.faces[face][corner], to = surface.faces[face][(corner + 1) % 3];
            const std::uint32_t edge = edges.find(from, to);
            if (edge == kNoFace) continue;
            const std::uint32_t apex = apex_of(surface, face, {from, to});
            if (apex == kNoFace) continue;
            sides.push_back({edge, apex, edge_vertices(surface, edge)[0] == from, surface.is_two_sided(face),
                             surface.components[surface.face_component[face]].is_closed});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.apex < b.apex;
    });
    return sides;
}

/// A drawn line of one object in the world.
struct SeamLine {
    std::uint32_t object;
    std::uint32_t edge;
    std::uint32_t first_side;
    std::uint32_t side_count;
};

class SeamSearch {
 public:
    SeamSearch(std::span<const SeamObject> objects, const SeamOptions& options) : objects_(objects), options_(options)
    {
        for (std::uint32_t object = 0; object < objects.size(); ++object) add_lines(object);
        hidden_.resize(lines_.size());
    }

    std::vector<Seams> run()
    {
        for (const auto& group : group_by_line(segments_, options_.tolerance_m)) look_along(group);
        look_at_complex_edges();
        look_at_overlaps();
        std::vector<Seams> result(objects_.size());
        for (std::uint32_t line = 0; line < lines_.size(); ++line) report(line, result[lines_[line].object]);
        for (Seams& seams : result) {
            std::sort(seams.hidden.begin(), seams.hidden.end());
            std::sort(seams.partly_hidden.begin(), seams.partly_hidden.end());
        }
        return result;
    }

 private:
    void add_lines(std::uint32_t object)
    {
        const Surface& surface = *objects_[object].surface;
        auto found = sides_.find(&surface);
        if (found == sides_.end()) {
            found = sides_.emplace(&surface, sides_of_lines(surface, options_.crease_rad)).first;
        }
        const std::vector<EdgeSide>& sides = found->second;
        for (std::uint32_t first = 0; first < sides.size();) {
            std::uint32_t end = first + 1;
            while (end < sides.size() && sides[end].edge == sides[first].edge) ++end;
            const auto [a, b] = edge_vertices(surface, sides[first].edge);
            segments_.push_back({in_world(object, a), in_world(object, b), objects_[object].style});
            lines_.push_back({object, sides[first].edge, first, end - first});
            first = end;
        }
    }

    glm::dvec3 in_world(std::uint32_t object, std::uint32_t position) const
    {
        const SeamObject& o = objects_[object];
        return glm::dvec3(o.world_from_object * glm::dvec4(o.surface->positions[position], 1.0));
    }

    Interval along(std::uint32_t line, const Segment& axis) const
    {
        const glm::dvec3 direction = glm::normalize(axis.to - axis.from);
        const double a = glm::dot(segments_[line].from - axis.from, direction);
        const double b = glm::dot(segments_[line].to - axis.from, direction);
        return {std::min(a, b), std::max(a, b)};
    }

    void add_faces(std::uint32_t line, const Segment& axis, std::vector<FaceAtLine>& faces) const
    {
        const glm::dvec3 u = glm::normalize(axis.to - axis.from);
        const glm::dvec3 x = glm::normalize(std::abs(u.y) < 0.9 ? glm::cross(u, glm::dvec3(0, 1, 0))
                                                                : glm::cross(u, glm::dvec3(1, 0, 0)));
        const glm::dvec3 y = glm::cross(u, x);
        const SeamLine& l = lines_[line];
        const SeamObject& object = objects_[l.object];
        const bool is_mirrored = glm::determinant(glm::dmat3(object.world_from_object)) < 0.0;
        const std::vector<EdgeSide>& sides = sides_.at(object.surface);
        const bool runs_with_axis = glm::dot(segments_[line].to - segments_[line].from, u) > 0.0;
        for (std::uint32_t i = l.first_side; i < l.first_side + l.side_count; ++i) {
            const glm::dvec3 out = in_world(l.object, sides[i].apex) - segments_[line].from;
            // Running along the axis with the face on the left, its front is where the angle rises.
            const bool looks_ccw = (sides[i].is_forward == runs_with_axis) != is_mirrored;
            faces.push_back({.angle_rad = std::atan2(glm::dot(out, y), glm::dot(out, x)),
                             .looks_ccw = looks_ccw || object.is_double_sided || sides[i].is_two_sided,
                             .looks_cw = !looks_ccw || object.is_double_sided || sides[i].is_two_sided});
        }
    }

    void look_along(const std::vector<std::uint32_t>& group)
    {
        std::uint32_t longest = group[0];
        for (const std::uint32_t line : group) {
            if (length(line) > length(longest)) longest = line;
        }
        const Segment axis = segments_[longest];
        std::vector<Interval> spans;
        std::vector<double> cuts;
        for (const std::uint32_t line : group) {
            spans.push_back(along(line, axis));
            cuts.push_back(spans.back().from);
            cuts.push_back(spans.back().to);
        }
        std::sort(cuts.begin(), cuts.end());
        std::vector<std::uint32_t> order(group.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](auto a, auto b) { return spans[a].from < spans[b].from; });

        std::vector<std::uint32_t> active;
        std::size_t next = 0;
        for (std::size_t cut = 0; cut + 1 < cuts.size(); ++cut) {
            const Interval piece{cuts[cut], cuts[cut + 1]};
            if (piece.to - piece.from <= options_.tolerance_m) continue;
            const double middle = 0.5 * (piece.from + piece.to);
            while (next < order.size() && spans[order[next]].from < middle) active.push_back(order[next++]);
            std::erase_if(active, [&](std::uint32_t i) { return spans[i].to < middle; });
            look_at_piece(group, active, axis, piece);
        }
    }

    void look_at_piece(const std::vector<std::uint32_t>& group, const std::vector<std::uint32_t>& active,
                       const Segment& axis, const Interval& piece)
    {
        if (active.size() < 2 || looked_at_ > kMostLookedAt) return;
        looked_at_ += active.size();
        faces_.clear();
        for (const std::uint32_t i : active) add_faces(group[i], axis, faces_);
        if (!is_flat_across(faces_, options_.flat_rad)) return;
        for (const std::uint32_t i : active) {
            const Interval own = along(group[i], segments_[group[i]]);
            const Interval placed = along(group[i], axis);
            const bool runs_with_axis =
                glm::dot(segments_[group[i]].to - segments_[group[i]].from, axis.to - axis.from) > 0.0;
            const double from = runs_with_axis ? piece.from - placed.from : placed.to - piece.to;
            hidden_[group[i]].push_back({std::max(0.0, from), std::min(own.to, from + piece.to - piece.from)});
        }
    }

    /// Edges of three and more faces can be seams without a neighbour.
    void look_at_complex_edges()
    {
        for (std::uint32_t line = 0; line < lines_.size(); ++line) {
            if (lines_[line].side_count < 3 || !hidden_[line].empty()) continue;
            faces_.clear();
            add_faces(line, segments_[line], faces_);
            if (length(line) > 0.0 && is_flat_across(faces_, options_.flat_rad)) {
                hidden_[line].push_back({0.0, length(line)});
            }
        }
    }

    /// Pieces that lie into one another: the end of one lies on a coplanar face of the other, where no line is.
    void look_at_overlaps()
    {
        const Overlaps overlaps(objects_, options_);
        std::uint64_t looked_at = 0;
        for (std::size_t first = 0; first < lines_.size() && looked_at < kMostTriangles; first += kLinesTogether) {
            const std::size_t count = std::min(kLinesTogether, lines_.size() - first);
            looked_at += tbb::parallel_reduce(
                tbb::blocked_range<std::size_t>(first, first + count), std::uint64_t{0},
                [&](const auto& lines, std::uint64_t sum) {
                    for (std::size_t line = lines.begin(); line < lines.end(); ++line)
                        sum += look_at_overlaps_of(static_cast<std::uint32_t>(line), overlaps);
                    return sum;
                },
                std::plus<>());
        }
    }

    /// How many triangles it looked at.
    std::uint64_t look_at_overlaps_of(std::uint32_t line, const Overlaps& overlaps)
    {
        const SeamLine& l = lines_[line];
        const Segment& segment = segments_[line];
        const SeamObject& object = objects_[l.object];
        const std::vector<EdgeSide>& sides = sides_.at(object.surface);
        const bool is_mirrored = glm::determinant(glm::dmat3(object.world_from_object)) < 0.0;
        std::vector<FaceAtSegment> faces;
        for (std::uint32_t i = l.first_side; i < l.first_side + l.side_count; ++i) {
            const glm::dvec3 apex = in_world(l.object, sides[i].apex);
            const glm::dvec3 area = glm::cross(segment.to - segment.from, apex - segment.from);
            const double size = glm::length(area);
            if (!(size > 0.0)) continue;
            faces.push_back({apex, (sides[i].is_forward != is_mirrored ? area : -area) / size,
                             sides[i].is_two_sided || (object.is_double_sided && !sides[i].is_of_solid)});
        }
        return overlaps.find(segment.from, segment.to, object.style, faces, hidden_[line]);
    }

    double length(std::uint32_t line) const { return glm::distance(segments_[line].from, segments_[line].to); }

    void report(std::uint32_t line, Seams& seams)
    {
        std::vector<Interval>& hidden = hidden_[line];
        if (hidden.empty()) return;
        std::sort(hidden.begin(), hidden.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
        const double whole = length(line), gap = 2.0 * options_.tolerance_m;
        std::vector<Interval> kept;
        double reached = 0.0;
        for (const Interval& piece : hidden) {
            if (piece.from - reached > gap) kept.push_back({reached, piece.from});
            reached = std::max(reached, piece.to);
        }
        if (whole - reached > gap) kept.push_back({reached, whole});
        if (kept.empty()) {
            seams.hidden.push_back(lines_[line].edge);
            return;
        }
        seams.partly_hidden.push_back(lines_[line].edge);
        const Surface& surface = *objects_[lines_[line].object].surface;
        const auto [a, b] = edge_vertices(surface, lines_[line].edge);
        const glm::dvec3 from = surface.positions[a], to = surface.positions[b];
        for (const Interval& piece : kept) {
            seams.kept.push_back(
                {{glm::vec3(glm::mix(from, to, piece.from / whole)), glm::vec3(glm::mix(from, to, piece.to / whole))},
                 lines_[line].edge});
        }
    }

    std::span<const SeamObject> objects_;
    const SeamOptions& options_;
    std::map<const Surface*, std::vector<EdgeSide>> sides_;
    std::vector<Segment> segments_;
    std::vector<SeamLine> lines_;
    std::vector<std::vector<Interval>> hidden_;  // for each line, in world lengths from its first end
    std::vector<FaceAtLine> faces_;
    std::uint64_t looked_at_ = 0;  // lines, of all pieces so far
};

}  // namespace

std::vector<Seams> find_seams(std::span<const SeamObject> objects, const SeamOptions& options)
{
    return SeamSearch(objects, options).run();
}

}  // namespace hw
