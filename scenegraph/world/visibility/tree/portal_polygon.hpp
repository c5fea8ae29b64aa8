#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hw {

/// A plane in floating point: normal.x + offset, unit normal.
struct FlowPlane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
    double distance(const glm::dvec3& point) const { return glm::dot(normal, point) + offset; }
};

/// A convex polygon of bounded size, without allocation.
struct Winding {
    static constexpr int kMostCorners = 64;
    int count = 0;
    std::array<glm::dvec3, kMostCorners> points;

    Winding() {}  // NOLINT: the points stay uninitialised, they are only read below `count`
    explicit Winding(std::span<const glm::dvec3> corners);
    Winding(const Winding& other) { *this = other; }
    Winding& operator=(const Winding& other)
    {
        count = other.count;
        for (int i = 0; i < count; ++i) points[static_cast<std::size_t>(i)] = other.points[static_cast<std::size_t>(i)];
        return *this;
    }
    const glm::dvec3& operator[](int i) const { return points[static_cast<std::size_t>(i)]; }
};

/// How exact a clip is. Everything within `slack` behind the plane is kept; a polygon that nowhere reaches `least` in
/// front of it is gone.
struct ClipTolerance {
    double slack = 1e-9;
    double least = 1e-5;
};

/// Keeps what lies in front of the plane. False if nothing is left. A polygon with no room for another corner is kept
/// whole.
bool clip(Winding& winding, const FlowPlane& plane, const ClipTolerance& tolerance);

/// Clips `target` by the planes through a side of `source` and a corner of `pass` that part the two: what a line
/// through both can reach beyond `pass`. `source_plane` is the plane of `source`, its normal towards `pass`; the
/// winding of `source` runs counter-clockwise about it (`is_reversed`: clockwise). With `keeps_source_side` the part on
/// the side of the source is kept: for sides of the pass, seen from the far end. False if nothing is left.
struct Separation {
    const Winding& source;
    FlowPlane source_plane;
    const Winding& pass;
    bool is_reversed = false;
    bool keeps_source_side = false;
};
bool clip_to_separators(Winding& target, const Separation& between, const ClipTolerance& tolerance);

/// Appends the planes that clip_to_separators() clips by: what is in front of all is left.
void add_separators(const Separation& between, std::vector<FlowPlane>& planes);

}  // namespace hw
