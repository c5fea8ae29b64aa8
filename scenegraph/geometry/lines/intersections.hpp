#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/visible_lines.hpp"

namespace hw {

/// A straight piece of a line along which two objects go through each other, or two components of one.
struct IntersectionLine {
    std::array<std::uint32_t, 2> objects{};  ///< Indices into the objects given, rising; equal for components of one.
    std::array<std::uint32_t, 2> faces{};    ///< One of each object, Surface::faces.
    std::array<glm::dvec3, 2> ends_world{};
    std::array<std::uint32_t, 2> joints{};  ///< Pieces meet where these are equal.
};

/// The first of its two objects that shows such lines.
inline std::uint32_t owner_of(const IntersectionLine& line, std::span<const LineObject> objects)
{
    return line.objects[shows_intersections(objects[line.objects[0]]) ? 0 : 1];
}

struct IntersectionOptions {
    /// Objects that enter each other by less than this share of their size are in contact: no line. A line is judged as
    /// a whole, so that it has no gaps where a face is entered by little.
    double contact_share = kContactShare;
};

/// All lines in which objects cut each other, and components of one object, for every view: the world space positions
/// decide, rounded to doubles, by exact predicates with one tie rule, so that lines join from face to face without
/// gaps. Pairs of which neither shows such lines are left out; so are cuts of a component with itself. Sorted by
/// objects, then faces of the first. Pairs past a fixed amount of work have no lines, and a warning says how many.
std::vector<IntersectionLine> find_intersections(std::span<const LineObject> objects,
                                                 const IntersectionOptions& options = {});

}  // namespace hw
