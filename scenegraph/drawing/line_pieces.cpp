#include "hatchway/drawing/line_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/drawing/line_width.hpp"

namespace hw {
namespace {

constexpr double kThinnestPx = 0.05;
constexpr double kAlike = 1.1;    // widths that differ by less are one
constexpr double kStep = 1.15;    // from piece to piece of a segment whose ends differ more
constexpr int kMostPieces = 24;   // of a segment that is ruled
constexpr int kMostSteps = 4096;  // of one that is drawn by hand
constexpr double kShortestPx = 0.02;
constexpr float kAtEnd = 1e-4f;  // share of a line

/// Takes so much from the beginning of a polyline, but leaves a dot of it.
void shorten(std::vector<glm::dvec2>& points, double by_px)
{
    while (by_px > 0.0 && points.size() > 1) {
        const double own = glm::distance(points[0], points[1]);
        const bool is_last = points.size() == 2;
        if (own > by_px || is_last) {
            const double share = own > 0.0 ? std::min(by_px, std::max(own - kShortestPx, 0.0)) / own : 0.0;
            points[0] = glm::mix(points[0], points[1], share);
            return;
        }
        points.erase(points.begin());
        by_px -= own;
    }
}

double length_of(const std::vector<glm::dvec2>& points)
{
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) length += glm::distance(points[i], points[i + 1]);
    return length;
}

}  // namespace

/// A part of a visible line that lies on one line of the object, and the look that draws it.
struct LinePieces::Segment {
    LineClass line_class;
    const ObjectLineLook& pen;
    const PennedObject& object;
    const StrokeShape& shape;
    const ImageSpace& space;
    const ObjectLine* line;  ///< Null: a silhouette that is another edge in every view.
    ImagePoint from{0.0};
    ImagePoint to{0.0};

    glm::dvec3 in_object(const ImagePoint& point) const
    {
        return glm::dvec3(object.object_from_world * glm::dvec4(space.world_of(point), 1.0));
    }
    /// How far along the object's line, 0 to 1.
    float share_at(const ImagePoint& point) const
    {
        const glm::vec3 along = line->ends[1] - line->ends[0];
        const float t = glm::dot(glm::vec3(in_object(point)) - line->ends[0], along);
        return std::clamp(t / std::max(glm::dot(along, along), 1e-30f), 0.0f, 1.0f);
    }
    float arc_at(const ImagePoint& point) const
    {
        return glm::mix(line->stroke.from, line->stroke.to, share_at(point));
    }
    float px_per_unit(const ImagePoint& point) const
    {
        return static_cast<float>(space.px_per_m(point) * object.metres_per_unit);
    }
    bool is_by_hand() const { return !shape.is_ruled(); }
};

struct LinePieces::Stretch {
    glm::dvec2 from, to;
    double width;
    bool is_cut_before = false;  ///< A dash begins here.
    bool is_cut_after = false;
    bool begins = false;  ///< Nothing goes on into it: what runs on beyond an end.
    bool ends = false;
};

struct LinePieces::Piece {
    VectorLine line;
    bool is_cut_before = false;
    bool is_cut_after = false;
};

double LinePieces::width_at(const Segment& segment, const ImagePoint& point) const
{
    const ObjectLine* const line = segment.line;
    const PennedObject& object = segment.object;
    const glm::dvec3 place_world = space_.world_of(point);
    // In a parallel projection nothing is far away.
    const double distance_m = space_.is_parallel() ? 0.0 : glm::distance(place_world, eye_world_);
    PenPlace place{
        .line_class = segment.line_class,
        .fold_rad = line != nullptr ? line->fold_rad : 0.0f,
        .distance_m = static_cast<float>(distance_m),
        .px_per_m = static_cast<float>(space_.is_parallel() ? space_.focal_px() : space_.focal_px() / distance_m)};
    if (segment.pen.look.far.is_on && object.crowding != nullptr) {
        place.window_m = static_cast<float>(object.crowding->window() * object.metres_per_unit);
        place.crowding = line != nullptr ? glm::mix(line->crowding[0], line->crowding[1], segment.share_at(point))
                                         : object.crowding->at(glm::vec3(segment.in_object(point)));
        if (line != nullptr && line->line_class != LineClass::intersection) {
            const glm::vec3 middle = 0.5f * (line->ends[0] + line->ends[1]);
            const Viewpoint viewer = space_.viewpoint();
            const glm::vec3 eye(
                glm::dvec3(object.object_from_world * glm::dvec4(viewer.eye, viewer.is_orthographic ? 0.0 : 1.0)));
            place.inside =
                insideness(line->sides.normal_a, line->sides.normal_b, viewer.is_orthographic ? eye : eye - middle);
        }
    }
    double width = line_width_px(segment.pen.look, segment.pen.crease_rad, place) * segment.pen.presence(place_world.y);
    if (segment.line != nullptr && segment.is_by_hand())
        width *= segment.shape.taper(line->stroke, segment.arc_at(point), segment.px_per_unit(point));
    return width;
}

/// Where the hand draws a point of the line.
glm::dvec2 LinePieces::drawn_at(const Segment& segment, const ImagePoint& point) const
{
    const glm::dvec2 exact(point);
    if (!segment.is_by_hand()) return exact;
    const glm::dvec2 way = glm::dvec2(segment.to) - glm::dvec2(segment.from);
    const double length = glm::length(way);
    if (length <= 0.0) return exact;
    const glm::dvec2 left = glm::dvec2(way.y, -way.x) / length;  // y runs down
    const float scale = segment.px_per_unit(point);
    if (segment.line == nullptr) {
        const glm::dvec2 stray = segment.shape.silhouette_stray(glm::vec3(segment.in_object(point)), scale);
        return exact + glm::dot(glm::dvec2(stray.x, -stray.y), left) * left;
    }
    const double rises = segment.arc_at(segment.to) >= segment.arc_at(segment.from) ? 1.0 : -1.0;
    return exact + rises * segment.shape.stray(segment.arc_at(point), segment.line->stroke.seed, scale) * left;
}

/// The parts of a piece of a segment that have ink, where its stroke is dashed.
void LinePieces::add_dashes(const Segment& segment, const ImagePoint& from, const ImagePoint& to, double width,
                            std::vector<Stretch>& stretches) const
{
    const glm::dvec2 drawn_from = drawn_at(segment, from), drawn_to = drawn_at(segment, to);
    if (segment.line == nullptr || !segment.shape.is_dashed()) {
        stretches.push_back({drawn_from, drawn_to, width});
        return;
    }
    const float arcs[2] = {segment.arc_at(from), segment.arc_at(to)};
    const float period = segment.shape.dash_period(segment.px_per_unit(0.5 * (from + to)));
    const double share = segment.shape.dash_share(), seed = segment.line->stroke.seed;
    const double begin = arcs[0] / period + seed, end = arcs[1] / period + seed;  // in dashes
    const double low = std::min(begin, end), high = std::max(begin, end);
    std::vector<Stretch> inked;
    for (double dash = std::floor(low); dash < high || dash == low; dash += 1.0) {
        const double first = std::max(dash, low), last = std::min(dash + share, high);
        if (last < first || (last == first && low != high)) continue;
        const auto place = [&](double at) {
            const double t = low == high ? (at == last ? 1.0 : 0.0) : (at - begin) / (end - begin);
            return glm::mix(drawn_from, drawn_to, std::clamp(t, 0.0, 1.0));
        };
        if (low == high)
            inked.push_back({drawn_from, drawn_to, width});
        else if (begin < end)
            inked.push_back({place(first), place(last), width, first == dash, last == dash + share});
        else
            inked.push_back({place(last), place(first), width, last == dash + share, first == dash});
        if (low == high) break;
    }
    if (begin > end) std::reverse(inked.begin(), inked.end());
    stretches.insert(stretches.end(), inked.begin(), inked.end());
}

/// What a stroke that ends here runs on beyond its end.
void LinePieces::add_overshoot(const Segment& segment, const ImagePoint& end, const ImagePoint& other,
                               std::vector<Stretch>& stretches) const
{
    if (segment.line == nullptr || !segment.is_by_hand()) return;
    const float share = segment.share_at(end);
    if (share > kAtEnd && share < 1.0f - kAtEnd) return;
    const double beyond_px = segment.shape.overshoot_px(segment.line->stroke, share > 0.5f ? 1 : 0);
    const glm::dvec2 way = glm::dvec2(end) - glm::dvec2(other);
    const double length = glm::length(way);
    if (beyond_px <= 0.0 || length <= 0.0) return;
    if (segment.shape.is_dashed()) {
        const float period = segment.shape.dash_period(segment.px_per_unit(end));
        const float phase = segment.shape.dash_phase(segment.arc_at(end), segment.line->stroke.seed, period);
        if (phase > segment.shape.dash_share()) return;
    }
    const glm::dvec2 near = drawn_at(segment, end), far = near + beyond_px / length * way;
    const double width = width_at(segment, end);
    const bool is_before = end == segment.from;
    if (is_before)
        stretches.push_back({.from = far, .to = near, .width = width, .begins = true});
    else
        stretches.push_back({.from = near, .to = far, .width = width, .ends = true});
}

void LinePieces::add_stretches(const Segment& segment, std::vector<Stretch>& stretches) const
{
    const ImagePoint &from = segment.from, &to = segment.to;
    add_overshoot(segment, from, to, stretches);
    const auto [thin, wide] = std::minmax({width_at(segment, from), width_at(segment, to)});
    const double steps = wide > kThinnestPx ? std::log(wide / std::max(thin, kThinnestPx)) / std::log(kStep) : 0.0;
    int parts = std::clamp(static_cast<int>(std::ceil(steps)), 1, kMostPieces);
    if (segment.is_by_hand()) {
        const double length = glm::distance(glm::dvec2(from), glm::dvec2(to)) / segment.shape.step_px();
        parts = std::clamp(static_cast<int>(std::ceil(std::min(length, 1.0 * kMostSteps))), parts, kMostSteps);
    }
    for (int k = 0; k < parts; ++k) {
        const ImagePoint a = k == 0 ? from : glm::mix(from, to, static_cast<double>(k) / parts);
        const ImagePoint b = k + 1 == parts ? to : glm::mix(from, to, (k + 1.0) / parts);
        const double width = width_at(segment, 0.5 * (a + b));
        if (segment.is_by_hand())
            add_dashes(segment, a, b, width, stretches);
        else
            stretches.push_back({glm::dvec2(a), glm::dvec2(b), width});
    }
    add_overshoot(segment, to, from, stretches);
}

bool LinePieces::may_go_on(const Stretch& from, const Stretch& to)
{
    return !from.is_cut_after && !from.ends && !to.is_cut_before && !to.begins;
}

std::vector<LinePieces::Piece> LinePieces::joined(const std::vector<Stretch>& stretches, bool is_closed)
{
    std::vector<Piece> pieces;
    double first_width = 0.0, weighted = 0.0, length = 0.0;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const Stretch& s = stretches[i];
        const bool goes_on = i > 0 && !pieces.empty() && pieces.back().line.points_px.back() == s.from &&
                             may_go_on(stretches[i - 1], s) && s.width < kAlike * first_width &&
                             first_width < kAlike * s.width;
        if (s.width < kThinnestPx) {
            first_width = 0.0;
            continue;
        }
        if (!goes_on) {
            pieces.push_back({{{s.from}, false, s.width}, s.is_cut_before, false});
            first_width = s.width;
            weighted = length = 0.0;
        }
        const double own = glm::distance(s.from, s.to);
        weighted += own * s.width;
        length += own;
        Piece& piece = pieces.back();
        piece.line.points_px.push_back(s.to);
        piece.is_cut_after = s.is_cut_after;
        if (length > 0.0) piece.line.width_px = weighted / length;
    }
    if (is_closed && pieces.size() == 1 && pieces[0].line.points_px.size() == stretches.size() + 1) {
        pieces[0].line.points_px.pop_back();
        pieces[0].line.is_closed = true;
    }
    return pieces;
}

std::vector<VectorLine> LinePieces::of(const VisibleLine& line, const ObjectLineLook& pen,
                                       const PennedObject& object) const
{
    const StrokeShape shape(pen.look.stroke);
    const std::size_t count = line.points_px.size();
    const auto point = [&](std::size_t i) {
        return ImagePoint(line.points_px[i % count], line.inverse_depths[i % count]);
    };
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < line.sources.size(); ++i) {
        const Segment segment{.line_class = line.line_class,
                              .pen = pen,
                              .object = object,
                              .shape = shape,
                              .space = space_,
                              .line = object.lines.find(line.sources[i]),
                              .from = point(i),
                              .to = point(i + 1)};
        const std::size_t first = stretches.size();
        add_stretches(segment, stretches);
        // At a corner the hand strays to another side: the line goes on from where it is.
        if (!segment.is_by_hand() || first == 0 || first == stretches.size()) continue;
        if (!may_go_on(stretches[first - 1], stretches[first])) continue;
        const double apart = glm::distance(stretches[first].from, stretches[first - 1].to);
        if (apart < 2.5 * pen.look.stroke.wobble_px) stretches[first].from = stretches[first - 1].to;
    }
    std::vector<VectorLine> lines;
    for (Piece& piece : joined(stretches, line.is_closed)) {
        // The ends of lines are round; a dash has its length with them.
        const double most = 0.5 * length_of(piece.line.points_px);
        const double cap = std::min(0.5 * piece.line.width_px, most);
        if (piece.is_cut_before) shorten(piece.line.points_px, cap);
        if (piece.is_cut_after) {
            std::reverse(piece.line.points_px.begin(), piece.line.points_px.end());
            shorten(piece.line.points_px, cap);
            std::reverse(piece.line.points_px.begin(), piece.line.points_px.end());
        }
        lines.push_back(std::move(piece.line));
    }
    return lines;
}

}  // namespace hw
