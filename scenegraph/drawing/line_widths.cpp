#include "hatchway/drawing/line_widths.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace hw {
namespace {

constexpr double kThinnestPx = 0.05;
constexpr double kAlike = 1.1;       // widths that differ by less are one
constexpr double kStep = 1.15;       // from piece to piece of a segment whose ends differ more
constexpr int kMostPieces = 24;      // of a segment
constexpr double kInsideFrom = 0.2;  // sine of the angle from which on a face is seen for good

double smooth_step(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

glm::dvec3 unit_normal(const Surface& surface, std::uint32_t face)
{
    const auto& [a, b, c] = surface.faces[face];
    const glm::dvec3 p(surface.positions[a]);
    const glm::dvec3 area = glm::cross(glm::dvec3(surface.positions[b]) - p, glm::dvec3(surface.positions[c]) - p);
    const double length = glm::length(area);
    return length > 0.0 ? area / length : glm::dvec3(0.0);
}

/// 1 where both faces of an edge are seen from the eye, 0 where it is an outline now or nobody knows.
double insideness(const LineObject& object, std::uint32_t edge, const glm::dvec3& eye_object)
{
    const Surface& surface = *object.surface;
    if (edge == kNoEdge || !object.is_culled || surface.report.flipped_faces != 0) return 0.0;
    const auto [a, b] = surface.edges[edge].faces();
    if (a >= surface.faces.size() || b >= surface.faces.size()) return 0.0;
    const auto [from, to] = edge_vertices(surface, edge);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(surface.positions[from]) + glm::dvec3(surface.positions[to]));
    const glm::dvec3 to_eye = glm::normalize(eye_object - middle);
    return smooth_step(0.0, kInsideFrom,
                       std::min(glm::dot(unit_normal(surface, a), to_eye), glm::dot(unit_normal(surface, b), to_eye)));
}

/// As render's lines have it: linear between the edge's ends.
glm::vec4 crowding_on_edge(const InkedObject& object, std::uint32_t edge, const glm::vec3& place_object)
{
    const Surface& surface = *object.object->surface;
    const auto [first, second] = edge_vertices(surface, edge);
    const glm::vec3 a = surface.positions[first], b = surface.positions[second], along = b - a;
    const LineCrowding& crowding = *object.crowding;
    const auto ends = crowding_of_line(crowding.at(a), crowding.at(b), crowding.at(0.5f * (a + b)));
    const float t = glm::dot(place_object - a, along) / std::max(glm::dot(along, along), 1e-30f);
    return glm::mix(ends[0], ends[1], std::clamp(t, 0.0f, 1.0f));
}

/// A piece of a line with the width in its middle.
struct Stretch {
    glm::dvec2 from, to;
    double width;
};

/// Joins stretches that follow each other and are as wide.
std::vector<VectorLine> joined(const std::vector<Stretch>& stretches, bool is_closed)
{
    std::vector<VectorLine> lines;
    double first_width = 0.0, weighted = 0.0, length = 0.0;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const Stretch& s = stretches[i];
        const bool goes_on = i > 0 && !lines.empty() && lines.back().points_px.back() == s.from &&
                             s.width < kAlike * first_width && first_width < kAlike * s.width;
        if (s.width < kThinnestPx) {
            first_width = 0.0;
            continue;
        }
        if (!goes_on) {
            lines.push_back({{s.from}, false, s.width});
            first_width = s.width;
            weighted = length = 0.0;
        }
        const double own = glm::distance(s.from, s.to);
        weighted += own * s.width;
        length += own;
        lines.back().points_px.push_back(s.to);
        if (length > 0.0) lines.back().width_px = weighted / length;
    }
    if (is_closed && lines.size() == 1 && lines[0].points_px.size() == stretches.size() + 1) {
        lines[0].points_px.pop_back();
        lines[0].is_closed = true;
    }
    return lines;
}

}  // namespace

InkedObject inked_object(const LineObject& object)
{
    const glm::dmat4& world = object.world_from_object;
    return {.object = &object,
            .object_from_world = glm::inverse(world),
            .metres_per_unit = std::cbrt(std::abs(glm::determinant(glm::dmat3(world)))),
            .crowding = {}};
}

double LineWidths::far_share(const glm::dvec3& place_object, double distance_m, std::uint32_t edge,
                             LineClass line_class, const FarPolicy& far, const InkedObject& object) const
{
    if (!far.is_on || !object.crowding) return 1.0;
    const double window_m = far.full_spacing_px / kFullSpacingInWindows * distance_m / space_.focal_px();
    const double windows = window_m / (object.crowding->window() * object.metres_per_unit);
    const glm::vec4 crowding = edge != kNoEdge && line_class != LineClass::silhouette
                                   ? crowding_on_edge(object, edge, glm::vec3(place_object))
                                   : object.crowding->at(glm::vec3(place_object));
    const double share = crowded_share(crowding, static_cast<float>(windows));
    if (is_contour(line_class)) return share;
    const double gone = FarPolicy::kInnerGone;
    const double inside = std::clamp((share - gone) / (1.0 - gone), 0.0, 1.0);
    const glm::dvec3 eye_object(object.object_from_world * glm::dvec4(eye_world_, 1.0));
    return glm::mix(share, inside, insideness(*object.object, edge, eye_object));
}

double LineWidths::width_at(const ImagePoint& point, std::uint32_t edge, LineClass line_class,
                            const ObjectLineLook& pen, const InkedObject& object) const
{
    const LineLook& look = pen.look;
    const auto index = static_cast<std::size_t>(line_class);
    if (!look.pens[index].is_drawn) return 0.0;
    const glm::dvec3 place_world = space_.world_of(point);
    double width = look.pens[index].width_px * pen.presence(place_world.y);
    if (is_crease(line_class) && edge != kNoEdge) {
        const double least = pen.crease_rad, whole = 0.5 * std::numbers::pi;
        const double fold = std::clamp((fold_rad(*object.object->surface, edge) - least) / (whole - least), 0.0, 1.0);
        width *= glm::mix(1.0, glm::mix(0.25, 1.0, fold), static_cast<double>(look.fold_weight));
    }
    const double distance_m = glm::distance(place_world, eye_world_);
    if (look.depth_taper > 0.0f && distance_m > look.taper_from_m)
        width *= glm::mix(1.0, look.taper_from_m / distance_m, static_cast<double>(look.depth_taper));
    const glm::dvec3 place_object(object.object_from_world * glm::dvec4(place_world, 1.0));
    return width * far_share(place_object, distance_m, edge, line_class, look.far, object);
}

std::vector<VectorLine> LineWidths::pieces(const VisibleLine& line, const ObjectLineLook& pen,
                                           const InkedObject& object) const
{
    const std::size_t count = line.points_px.size();
    const auto point = [&](std::size_t i) {
        return ImagePoint(line.points_px[i % count], line.inverse_depths[i % count]);
    };
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < line.edges.size(); ++i) {
        const ImagePoint from = point(i), to = point(i + 1);
        const auto width = [&](const ImagePoint& at) {
            return width_at(at, line.edges[i], line.line_class, pen, object);
        };
        const auto [thin, wide] = std::minmax(width(from), width(to));
        const double steps = wide > kThinnestPx ? std::log(wide / std::max(thin, kThinnestPx)) / std::log(kStep) : 0.0;
        const int parts = std::clamp(static_cast<int>(std::ceil(steps)), 1, kMostPieces);
        for (int k = 0; k < parts; ++k) {
            const ImagePoint a = k == 0 ? from : glm::mix(from, to, static_cast<double>(k) / parts);
            const ImagePoint b = k + 1 == parts ? to : glm::mix(from, to, (k + 1.0) / parts);
            stretches.push_back({glm::dvec2(a), glm::dvec2(b), width(0.5 * (a + b))});
        }
    }
    return joined(stretches, line.is_closed);
}

}  // namespace hw
