#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "hatchway/world/scene.hpp"
#include "measure/lines/eye_rays.hpp"
#include "measure/lines/judged_edges.hpp"

namespace hw {

/// A polyline of a drawing to be judged, pixels, origin top left, y down. A closed one repeats its first point.
struct JudgedLine {
    std::vector<glm::dvec2> points_px;
    bool is_intersection = false;  ///< Where objects go through each other: no edge of a mesh lies there.
};

/// Lengths in pixels.
struct RayVerdict {
    double candidates_px = 0.0;  ///< Of all borders, creases and contours in the picture, hidden ones included.
    double visible_px = 0.0;     ///< Of those, what rays reach and where the surface does not run straight on.
    double missed_px = 0.0;      ///< Of that, without a line within the reach that runs like it.
    double crossed_px = 0.0;     ///< Of visible_px, not missed: only a line where objects go through each other is in
                                 ///< reach and runs like it. Where an object ends in a face of another, it is one line.
    double thinned_px =
        0.0;                ///< Of visible_px, found, but without a drawn line within the reach: left out by the style.
    double found_px = 0.0;  ///< Of the found lines, without those where objects go through each other.
    double extra_px = 0.0;  ///< Of that, without an edge within the reach that rays reach or nearly reach, and
                            ///< across which what is seen is not surely one plane.
    double noticed_px = 0.0;   ///< Of the found length: on an edge that counts as visible, no other line like it in
                               ///< reach. Had the line been left out, this would be missed.
    double unsure_px = 0.0;    ///< Of the found length: neither extra nor on an edge that counts as visible.
    double unjudged_px = 0.0;  ///< Where objects go through each other.
    std::uint64_t rays = 0;

    void add(const RayVerdict& other);
};

/// What a pixel shows of a verdict.
enum JudgedPixel : std::uint8_t { judged_paper, judged_found, judged_missed, judged_thinned, judged_extra };

/// Judges visible lines by brute force: every edge of every object that is a border, a crease, a contour from the eye
/// or marked by the artist is walked pixel by pixel, and a ray decides about each. Nothing of geometry/lines,
/// geometry/surface or geometry/silhouettes is used. Distances are compared to a thousandth of themselves: what lies
/// between "surely seen" and "surely hidden" is neither missed nor extra. A line stands for an edge within the reach of
/// 1 px that runs like it (LineMask), so in crowds of lines it sees less than where they stand alone: noticed_px tells
/// how much. A line where objects go through each other is not judged, and an edge that has no other is told apart.
class RayJudge {
 public:
    /// All objects of a scene wear lines of one crease angle. The scene must outlive this.
    RayJudge(const Scene& scene, double crease_rad);

    /// `found`: the visible lines. `drawn`: those of them that a style draws, at least a quarter of a pixel wide.
    /// `to_show`, when not null, receives for every pixel judged_found, judged_missed ... or 0.
    RayVerdict judge(const JudgeCamera& camera, std::span<const JudgedLine> found, std::span<const JudgedLine> drawn,
                     std::vector<std::uint8_t>* to_show = nullptr) const;

 private:
    struct Look;

    std::vector<JudgedEdge> edges_;
    std::vector<HidingTriangle> triangles_;
};

}  // namespace hw
