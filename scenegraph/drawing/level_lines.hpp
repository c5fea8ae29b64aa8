#pragma once

#include <optional>
#include <vector>

#include "hatchway/core/vector_drawing.hpp"
#include "hatchway/drawing/line_widths.hpp"
#include "hatchway/geometry/lines/intersections.hpp"
#include "hatchway/geometry/lines/visible_lines.hpp"

namespace hw {

/// The objects of a scene made ready for find_visible_lines(): surfaces, seams, and how each is drawn. Built once, good
/// for every camera.
class LevelLines {
 public:
    /// `pens`: one for each object; none: all objects are drawn with one pen, of paper whose two sides both hide.
    /// `crease_rad` goes before what the styles say. `scene` must outlive this.
    LevelLines(const Scene& scene, std::vector<ObjectPens> pens, std::optional<float> crease_rad);
    LevelLines(const LevelLines&) = delete;
    LevelLines& operator=(const LevelLines&) = delete;

    const std::vector<LineObject>& objects() const { return objects_; }
    /// Where objects whose styles want it go through each other. Found once, on the first call.
    const std::vector<IntersectionLine>& intersections();
    const std::string& name(std::uint32_t object) const;

    /// The lines with the widths and colours of the objects' styles: those thinned away by distance or presence are
    /// left out.
    VectorDrawing drawing(const std::vector<VisibleLine>& lines, const LineCamera& camera);

 private:
    void take_pens(const std::vector<ObjectPens>& pens, std::optional<float> crease_rad);
    void find_object_seams(const std::vector<ObjectPens>& pens);
    void find_crowding();
    void append_groups(VectorObject& object, std::span<const VisibleLine> lines, const LineWidths& widths) const;

    const Scene& scene_;
    std::vector<Surface> surfaces_;
    std::vector<LineObject> objects_;
    std::vector<std::vector<ObjectLineLook>> pens_;
    std::vector<Seams> seams_;  ///< Of the objects whose styles draw edges.
    std::optional<std::vector<IntersectionLine>> intersections_;
    std::vector<InkedObject> inked_;
};

/// find_visible_lines(), so many times; `seconds` gets the median time.
std::vector<VisibleLine> timed_visible_lines(std::span<const LineObject> objects, const LineCamera& camera,
                                             const VisibleLineOptions& options, int runs, double& seconds);

}  // namespace hw
