#include "hatchway/drawing/object_lines.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <optional>

#include "hatchway/geometry/surface/complex_edges.hpp"
#include "hatchway/geometry/surface/surface_faces.hpp"

namespace hw {
namespace {

/// Normals around an edge. Where half a turn holds all of them, all look away from where the outermost two do.
class OutermostNormals {
 public:
    explicit OutermostNormals(const glm::vec3& along) : along_(glm::normalize(along)) {}

    void add(const glm::vec3& normal)
    {
        if (has_gap_) return;
        has_gap_ = normal == glm::vec3(0.0f);
        if (first_ == glm::vec3(0.0f)) first_ = low_.normal = high_.normal = normal;
        const float angle = std::atan2(glm::dot(glm::cross(first_, normal), along_), glm::dot(first_, normal));
        if (angle < low_.angle) low_ = {angle, normal};
        if (angle > high_.angle) high_ = {angle, normal};
    }
    /// None where no half turn holds all, or one had no direction.
    std::optional<std::array<glm::vec3, 2>> found() const
    {
        if (has_gap_ || high_.angle - low_.angle > std::numbers::pi_v<float>) return std::nullopt;
        return std::array{low_.normal, high_.normal};
    }

 private:
    struct Turned {
        float angle = 0.0f;
        glm::vec3 normal{0.0f};
    };

    glm::vec3 along_, first_{0.0f};
    Turned low_, high_;
    bool has_gap_ = false;
};

class LineCollector {
 public:
    explicit LineCollector(const ObjectEdges& edges)
        : surface_(edges.surface), seams_(edges.extras.seams), is_culled_(edges.is_culled)
    {
    }

    void add(EdgeRange range, LineClass line_class)
    {
        for (std::uint32_t id = range.begin; id < range.end; ++id) {
            if (is_hidden(id)) continue;
            const auto [a, b] = edge_vertices(surface_, id);
            lines.push_back({.ends = {surface_.positions[a], surface_.positions[b]},
                             .line_class = line_class,
                             .source = {LineSource::Kind::edge, id},
                             .sides = sides_of(id),
                             .fold_rad = is_crease(line_class) ? fold_rad(surface_, id) : 0.0f});
        }
    }
    void add_kept()
    {
        for (std::uint32_t i = 0; i < seams_.kept.size(); ++i)
            lines.push_back({.ends = seams_.kept[i].ends,
                             .line_class = LineClass::border,
                             .source = {LineSource::Kind::kept, i},
                             .sides = sides_of(seams_.kept[i].edge)});
    }
    void add(const ObjectIntersection& piece)
    {
        const auto& [a, b] = piece.culled_normals;
        lines.push_back({.ends = piece.ends,
                         .line_class = LineClass::intersection,
                         .source = {LineSource::Kind::intersection, piece.index},
                         .sides = {a, b, a != glm::vec3(0.0f) || b != glm::vec3(0.0f)}});
    }

    std::vector<ObjectLine> lines;

 private:
    bool is_hidden(std::uint32_t id) const
    {
        const auto is_among = [&](const std::vector<std::uint32_t>& rising) {
            return std::binary_search(rising.begin(), rising.end(), id);
        };
        return is_among(seams_.hidden) || is_among(seams_.partly_hidden);
    }
    glm::vec3 normal_of(std::uint32_t face) const
    {
        const std::uint32_t plane = plane_face(surface_, face);
        if (plane == kNoFace) return glm::vec3(0.0f);
        const auto& corners = surface_.faces[plane];
        const glm::vec3& p = surface_.positions[corners[0]];
        const glm::vec3 area = glm::cross(surface_.positions[corners[1]] - p, surface_.positions[corners[2]] - p);
        const float size = face < surface_.faces.size() ? glm::length(area) : -glm::length(area);  // twins look back
        return size != 0.0f ? area / size : glm::vec3(0.0f);
    }
    bool is_culled(std::uint32_t face) const
    {
        return is_culled_ && face < surface_.faces.size() && !surface_.is_two_sided(face);
    }
    LineSides sides_of(std::uint32_t id) const
    {
        const auto [a, b] = surface_.edges[id].faces();
        if (b == kNoFace) return {normal_of(a), normal_of(a), is_culled(a)};
        if (id < surface_.edges.two_faced().begin) return sides_of_complex(id);
        const LineSides both{normal_of(a), normal_of(b), is_culled(a) && is_culled(b)};
        const bool has_both = both.normal_a != glm::vec3(0.0f) && both.normal_b != glm::vec3(0.0f);
        return has_both ? both : LineSides{};
    }
    /// The outermost two of those that show the edge, where from somewhere all are culled.
    LineSides sides_of_complex(std::uint32_t id) const
    {
        const auto [from, to] = edge_vertices(surface_, id);
        OutermostNormals outermost(surface_.positions[to] - surface_.positions[from]);
        bool are_culled = true;
        for (const std::uint32_t face : faces_that_show(surface_, id)) {
            outermost.add(normal_of(face));
            are_culled &= is_culled(face);
        }
        const auto sides = outermost.found();
        return are_culled && sides ? LineSides{(*sides)[0], (*sides)[1], true} : LineSides{};
    }

    const Surface& surface_;
    const Seams& seams_;
    bool is_culled_;
};

void set_strokes(std::vector<ObjectLine>& lines)
{
    std::vector<StrokeSegment> segments;
    segments.reserve(lines.size());
    for (const ObjectLine& line : lines) segments.push_back({line.ends, line.line_class});
    const std::vector<LineStroke> strokes = find_strokes(segments);
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i].stroke = strokes[i];
}

}  // namespace

const ObjectLine* ObjectLines::find(LineSource source) const
{
    const auto found = std::lower_bound(by_source.begin(), by_source.end(), source,
                                        [&](std::uint32_t line, LineSource s) { return lines[line].source < s; });
    return found != by_source.end() && lines[*found].source == source ? &lines[*found] : nullptr;
}

ObjectLines object_lines(const ObjectEdges& edges)
{
    const EdgeClasses classes = classes_at(edges.surface, edges.crease_rad);
    LineCollector collector(edges);
    collector.add(classes.borders, LineClass::border);
    collector.add_kept();
    for (const ObjectIntersection& piece : edges.extras.intersections) collector.add(piece);
    for (const EdgeRange range : classes.artist) collector.add(range, LineClass::artist);
    for (const EdgeRange range : classes.ridges) collector.add(range, LineClass::ridge);
    for (const EdgeRange range : classes.valleys) collector.add(range, LineClass::valley);

    ObjectLines result{.lines = std::move(collector.lines), .by_source = {}};
    set_strokes(result.lines);
    result.by_source.resize(result.lines.size());
    std::iota(result.by_source.begin(), result.by_source.end(), 0u);
    tbb::parallel_sort(result.by_source.begin(), result.by_source.end(), [&](std::uint32_t a, std::uint32_t b) {
        return result.lines[a].source < result.lines[b].source;
    });
    return result;
}

LineCrowding crowding_of(const ObjectEdges& edges, std::optional<std::span<const glm::vec3>> places)
{
    std::vector<std::array<glm::vec3, 2>> pieces;
    for (const ObjectIntersection& piece : edges.extras.intersections) pieces.push_back(piece.ends);
    return LineCrowding(crowding_lines(edges.surface, edges.crease_rad, &edges.extras.seams, pieces), places);
}

std::vector<glm::vec3> crowding_places(const ObjectLines& lines)
{
    std::vector<glm::vec3> places;  // of each line both ends and the middle
    places.reserve(3 * lines.lines.size());
    for (const ObjectLine& line : lines.lines) {
        const auto& [a, b] = line.ends;
        places.insert(places.end(), {a, b, 0.5f * (a + b)});
    }
    return places;
}

void set_crowding(ObjectLines& lines, const LineCrowding& crowding)
{
    const std::vector<glm::vec4> crowds = crowding.at(crowding_places(lines));
    for (std::size_t i = 0; i < lines.lines.size(); ++i)
        lines.lines[i].crowding = crowding_of_line(crowds[3 * i], crowds[3 * i + 1], crowds[3 * i + 2]);
}

}  // namespace hw
