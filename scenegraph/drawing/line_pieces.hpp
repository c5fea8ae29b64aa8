#pragma once

#include <vector>

#include "hatchway/core/vector_drawing.hpp"
#include "hatchway/drawing/line_looks.hpp"
#include "hatchway/drawing/object_lines.hpp"
#include "hatchway/drawing/stroke_shape.hpp"
#include "hatchway/geometry/lines/image_space.hpp"

namespace hw {

/// What the widths and strokes of an object's lines depend on beside the look.
struct PennedObject {
    const ObjectLines& lines;
    const LineCrowding* crowding = nullptr;  ///< Null where no look thins far lines.
    glm::dmat4 object_from_world{1.0};
    double metres_per_unit = 1.0;
};

/// Draws visible lines with looks, as vectors.
class LinePieces {
 public:
    explicit LinePieces(const LineCamera& camera) : space_(camera), eye_world_(camera.eye_world) {}

    /// A visible line in pieces that have one width each, within some percent, as the look's hand draws it: with its
    /// dashes, bends, overshoot and taper. Pieces thinner than a twentieth of a pixel are left out: what presence,
    /// distance and the far policy thinned away.
    std::vector<VectorLine> of(const VisibleLine& line, const ObjectLineLook& pen, const PennedObject& object) const;

 private:
    struct Segment;
    struct Stretch;
    struct Piece;

    double width_at(const Segment& segment, const ImagePoint& point) const;
    glm::dvec2 drawn_at(const Segment& segment, const ImagePoint& point) const;
    void add_stretches(const Segment& segment, std::vector<Stretch>& stretches) const;
    void add_overshoot(const Segment& segment, const ImagePoint& end, const ImagePoint& other,
                       std::vector<Stretch>& stretches) const;
    void add_dashes(const Segment& segment, const ImagePoint& from, const ImagePoint& to, double width,
                    std::vector<Stretch>& stretches) const;
    static bool may_go_on(const Stretch& from, const Stretch& to);
    static std::vector<Piece> joined(const std::vector<Stretch>& stretches, bool is_closed);

    ImageSpace space_;
    glm::dvec3 eye_world_;
};

}  // namespace hw
