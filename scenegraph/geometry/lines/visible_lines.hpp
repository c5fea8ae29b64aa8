#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/line_class.hpp"
#include "hatchway/geometry/lines/line_source.hpp"
#include "hatchway/geometry/lines/seams.hpp"
#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// The camera of a line drawing, world space.
struct LineCamera {
    glm::dvec3 eye_world{0.0};
    glm::dvec3 target_world{0.0, 0.0, -1.0};  ///< Not the eye.
    double fov_rad = 1.0471975512;            ///< Vertical, in (0, pi).
    /// A parallel projection so high, in place of the angle; above 0.
    std::optional<double> orthographic_height_m = {};
    glm::ivec2 size_px{1280, 720};  ///< At least 1 x 1.
    double near_m = 0.01;           ///< What is closer is cut away. Above 0, or in a parallel projection 0.
    double far_m = 1000.0;  ///< Of a parallel projection: everything is nearer; depths are told apart relative to it.
    double roll_rad = 0.0;  ///< About the line of sight: see picture_up().
};

/// Objects that enter each other by less than this share of the larger one's size only touch, as do components of one:
/// kits and exporters place them no better. They cut no line and hide nothing of each other there.
inline constexpr double kContactShare = 1e-5;

/// One object of a line drawing. All objects hide each other.
struct LineObject {
    const Surface* surface = nullptr;
    glm::dmat4 world_from_object{1.0};
    float crease_rad = 0.7f;
    std::span<const float> more_crease_rad;  ///< For each, all its lines once more: those of another style.
    const Seams* seams = nullptr;            ///< Lines that are left out, or null.
    bool is_drawn = true;                    ///< False: it only hides others.
    bool hides = true;                       ///< False: it is seen through.
    bool with_intersections = true;          ///< Where it goes through others, it has lines.
    bool is_culled = false;  ///< Faces that look away are not there: they hide nothing and carry no lines.
};

inline bool shows_intersections(const LineObject& object)
{
    return object.is_drawn && object.with_intersections;
}

struct IntersectionLine;  // geometry/lines/intersections.hpp

/// Silhouettes and borders are always among the lines.
struct VisibleLineOptions {
    bool with_hidden = false;  ///< The hidden parts too, as lines of their own.
    bool with_creases = true;  ///< Ridges and valleys.
    bool with_artist = true;   ///< The artist's edges.
    /// Where objects go through each other: find_intersections() of the same objects, or none. A line belongs to the
    /// first of its two objects that shows such lines.
    std::span<const IntersectionLine> intersections;
};

/// A polyline of the drawing. All of it belongs to one object and class and is visible, or all of it is hidden.
struct VisibleLine {
    std::uint32_t object = 0;  ///< Index into the objects given.
    std::uint8_t set = 0;      ///< Of the object's lines: 0 of its crease_rad, the others of more_crease_rad.
    LineClass line_class = LineClass::silhouette;
    bool is_visible = true;
    bool is_closed = false;             ///< The last point is joined to the first, which is not repeated.
    std::vector<glm::dvec2> points_px;  ///< Two at least. Origin top left, y down, clipped to the picture.
    /// Of each point: 1 / distance from the plane of the eye, 1 / m. In a parallel projection 2 at near_m and 1 at
    /// far_m.
    std::vector<double> inverse_depths;
    std::vector<LineSource> sources;  ///< Of each segment, the closing one included.
};

/// Throws hw::Error where a drawing of objects with so many positions and faces in all, instances counted each time,
/// would hold more than its budget. Asked before anything of that size is allocated.
void require_line_room(std::uint64_t positions, std::uint64_t faces);

/// Hidden-line removal on the meshes themselves, not on pixels. Every line is cut where its visibility can change:
/// where it crosses a silhouette or a border in the picture, and where it goes through a face. Of each piece the middle
/// is tested against all faces before it: exactly within a component of an object, between components and objects
/// with a tolerance, so that lines on a face of another stay visible (line_occluders.hpp). Pieces are
/// joined to polylines at common vertices.
///
/// The result is sorted by object, set and class and does not depend on the number of threads. Throws hw::Error where
/// a budget of bytes or steps runs out (core/budget.hpp).
/// Source: Appel. The Notion of Quantitative Invisibility and the Machine Rendering of Solids. ACM 1967, for where
/// visibility changes.
std::vector<VisibleLine> find_visible_lines(std::span<const LineObject> objects, const LineCamera& camera,
                                            const VisibleLineOptions& options = {});

}  // namespace hw
