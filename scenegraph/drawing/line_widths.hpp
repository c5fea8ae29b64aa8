#pragma once

#include <optional>
#include <vector>

#include "hatchway/core/vector_drawing.hpp"
#include "hatchway/drawing/line_looks.hpp"
#include "hatchway/geometry/lines/image_space.hpp"
#include "hatchway/geometry/lines/line_crowding.hpp"

namespace hw {

/// What the width of an object's lines depends on beside the pen.
struct InkedObject {
    const LineObject* object = nullptr;
    glm::dmat4 object_from_world{1.0};
    double metres_per_unit = 1.0;
    std::optional<LineCrowding> crowding;  ///< Where a pen has a far policy.
};

InkedObject inked_object(const LineObject& object);

/// How wide pens draw lines in a picture, by the rules of the renderer's shaders/line.glsl.
class LineWidths {
 public:
    explicit LineWidths(const LineCamera& camera) : space_(camera), eye_world_(camera.eye_world) {}

    /// A visible line in pieces that have one width each, within some percent. Pieces thinner than a twentieth of a
    /// pixel are left out: what presence, distance and the far policy thinned away.
    std::vector<VectorLine> pieces(const VisibleLine& line, const ObjectLineLook& pen, const InkedObject& object) const;

 private:
    double width_at(const ImagePoint& point, std::uint32_t edge, LineClass line_class, const ObjectLineLook& pen,
                    const InkedObject& object) const;
    double far_share(const glm::dvec3& place_object, double distance_m, std::uint32_t edge, LineClass line_class,
                     const FarPolicy& far, const InkedObject& object) const;

    ImageSpace space_;
    glm::dvec3 eye_world_;
};

}  // namespace hw
