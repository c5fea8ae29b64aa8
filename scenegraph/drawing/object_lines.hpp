#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "hatchway/drawing/line_extras.hpp"
#include "hatchway/drawing/line_strokes.hpp"
#include "hatchway/geometry/lines/line_class.hpp"
#include "hatchway/geometry/lines/line_crowding.hpp"
#include "hatchway/geometry/lines/line_source.hpp"

namespace hw {

/// The faces beside a line.
struct LineSides {
    /// Unit normals, equal at a border; zero: not known. Of more than two faces the outermost, or zero where never all
    /// are culled. Where those of two faces disagree about the eye the line is a silhouette.
    glm::vec3 normal_a{0.0f};
    glm::vec3 normal_b{0.0f};
    bool are_culled = false;  ///< The line is not drawn where both look away; an intersection, where either does.
};

/// A line that is drawn from every viewpoint where it is not hidden. Object space.
struct ObjectLine {
    std::array<glm::vec3, 2> ends{};
    LineClass line_class = LineClass::border;
    LineSource source;
    LineSides sides;
    float fold_rad = 0.0f;  ///< Of creases.
    LineStroke stroke;
    std::array<glm::vec4, 2> crowding{};  ///< LineCrowding at both ends.
};

/// All lines of an object but its silhouettes, at one crease angle, class after class.
struct ObjectLines {
    std::vector<ObjectLine> lines;

    /// The line of a source; null for one that these lines do not have.
    const ObjectLine* find(LineSource source) const;

    std::vector<std::uint32_t> by_source;  ///< Places in `lines`, by rising source.
};

/// How an object's surface is drawn, as far as its lines depend on it.
struct ObjectEdges {
    const Surface& surface;
    float crease_rad = 0.7f;
    const ObjectExtras& extras;
    bool is_culled = true;  ///< Faces that look away from the eye are not drawn.
};

/// The lines of an object, not crowded by any.
ObjectLines object_lines(const ObjectEdges& edges);

/// How crowded the lines of an object are, its silhouettes and its extras among them. `places` as LineCrowding says.
LineCrowding crowding_of(const ObjectEdges& edges, std::optional<std::span<const glm::vec3>> places = std::nullopt);

/// Where set_crowding() asks.
std::vector<glm::vec3> crowding_places(const ObjectLines& lines);

/// Sets how crowded the lines of an object are.
void set_crowding(ObjectLines& lines, const LineCrowding& crowding);

}  // namespace hw
