#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hatchway/geometry/hatching/hatch_coordinates.hpp"
#include "hatchway/param/param_value.hpp"
#include "hatchway/param/param_visitor.hpp"

namespace hw {

/// Object-space edges that a style draws by Pass::lines(). Adjacency is built only for objects whose style asks for it.
struct EdgeNeed {
    float crease_rad = 0.7f;     ///< Edges folded by more are creases.
    bool intersections = false;  ///< Lines where objects cut each other.
};

/// Extra vertex streams. Made once for each mesh and source, on need.
struct Streams {
    bool hatch_uv = false;   ///< Coordinates that strokes follow, from `hatch_source`.
    bool direction = false;  ///< Where u of `hatch_source` rises; of source model the direction of strongest curvature.
    HatchSource hatch_source = HatchSource::model;
    bool triangle_id = false;  ///< HwSurface::triangle_id. Costs three vertices for each triangle.
};

enum class ShadowNeed : unsigned char { none, main_light };

/// Names one full-screen image: the image pass that makes it and the parameters it is made with. Equal keys are made
/// once a frame. "normal_depth", "object_ids", "triangle_ids", "triangle_corners" and "triangle_stars" are the
/// engine's.
struct ImageKey {
    std::string pass;
    std::map<std::string, ParamValue> params;
    auto operator<=>(const ImageKey&) const = default;
};

/// What a style reads. Depends on its parameters alone. A frame makes the union over visible objects' styles, no more.
struct Needs {
    std::optional<EdgeNeed> edges;
    Streams streams;
    ShadowNeed shadow = ShadowNeed::none;
    bool lightmap = false;
    bool clock = false;  ///< View::time_s and hw_time_s; 0 without. A walk that stands still goes on drawing for it.
    std::vector<ImageKey> images;
    std::map<MapKind, MapName> maps;  ///< Maps of the style, for objects to which the level assigns none of that kind.
};

}  // namespace hw
