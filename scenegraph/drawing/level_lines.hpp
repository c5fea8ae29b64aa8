#pragma once

#include <map>
#include <optional>
#include <vector>

#include "hatchway/core/vector_drawing.hpp"
#include "hatchway/drawing/line_extras.hpp"
#include "hatchway/drawing/line_looks.hpp"
#include "hatchway/drawing/line_pieces.hpp"
#include "hatchway/drawing/object_lines.hpp"
#include "hatchway/drawing/scene_surfaces.hpp"
#include "hatchway/geometry/lines/visible_lines.hpp"

namespace hw {

/// The objects of a scene made ready for find_visible_lines(): surfaces, seams, intersections, and how each is drawn.
/// Built once, good for every camera. The scene must outlive this.
class LevelLines {
 public:
    /// Lines as the styles of the objects draw them; `pens`: one for each object. `crease_rad` goes before what the
    /// styles say.
    LevelLines(const Scene& scene, std::vector<ObjectPens> pens, std::optional<float> crease_rad = {});
    /// Lines of objects that wear no styles: one pen, and paper whose two sides both hide.
    struct OnePen {
        float crease_rad = 0.6981317f;  ///< 40 degrees
        bool has_intersections = true;
    };
    LevelLines(const Scene& scene, const OnePen& pen);
    LevelLines(const LevelLines&) = delete;
    LevelLines& operator=(const LevelLines&) = delete;

    const std::vector<LineObject>& objects() const { return objects_; }
    /// Where objects whose styles want it go through each other.
    const std::vector<IntersectionLine>& intersections() const { return extras_.intersections; }
    const std::string& name(std::uint32_t object) const;

    /// The lines with the widths, colours and strokes of the objects' styles: those thinned away by distance or
    /// presence are left out.
    VectorDrawing drawing(const std::vector<VisibleLine>& lines, const LineCamera& camera);

 private:
    /// What is made of an object's edges at one crease angle; objects without extras share it.
    struct Key {
        SceneSurfaces::Key surface;
        float crease_rad;
        bool is_culled, is_crowded;
        std::optional<ObjectId> owner;
        auto operator<=>(const Key&) const = default;
    };
    struct Made {
        std::optional<LineCrowding> crowding;
        ObjectLines lines;
    };

    void add_object(ObjectId id, bool hides, bool is_culled);
    const Made& made_of(ObjectId id, float crease_rad);
    void append_groups(VectorObject& object, std::span<const VisibleLine> lines, const LinePieces& pieces);

    const Scene& scene_;
    SceneSurfaces surfaces_;
    std::vector<ObjectPens> pens_;
    LineExtras extras_;
    std::vector<LineObject> objects_;
    std::map<Key, Made> made_;
    std::size_t made_bytes_ = 0;  ///< About what they take.
};

}  // namespace hw
