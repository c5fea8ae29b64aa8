#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/render/view/mirror_view.hpp"
#include "hatchway/style/view.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

struct Visibility;

/// A run of a mesh's indices.
struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// An object that may be seen, placed for this view. Matrices are relative to the eye and made in double, so that
/// pictures keep their precision far from the origin.
struct VisibleObject {
    ObjectId object = 0;
    glm::mat4 clip_from_object{1.0f};
    glm::mat4 relative_from_object{1.0f};  ///< World directions, origin at the eye.
    glm::mat3 normal_from_object{1.0f};
    float facing = 1.0f;      ///< -1 where either the transform or the view mirrors.
    float handedness = 1.0f;  ///< -1 where the transform mirrors.
    float scale = 1.0f;       ///< Metres per unit of object space, mean.
    double distance_m = 0.0;  ///< From the eye, or along a parallel view, to the object's bounds: the order of drawing.
    std::uint32_t first_range = 0;
    std::uint32_t range_count = 0;
};

struct VisibleSet {
    std::vector<VisibleObject> objects;  ///< Near before far; equal distances by id.
    std::vector<IndexRange> ranges;      ///< Of the objects, one object's after another's.
    int leaves_visible = 0;

    std::uint64_t triangle_count() const;
};

struct VisibilityQuery {
    const Scene* scene = nullptr;
    std::span<const MeshChunks> chunks;      ///< Empty: whole meshes.
    std::span<const Box> mesh_bounds;        ///< Of each mesh, object space.
    const Visibility* visibility = nullptr;  ///< Null: everything.
    std::span<const std::uint8_t> left_out;  ///< 1 for each object that is not drawn anyway; empty: none is.
    const Mirror* mirror = nullptr;          ///< That shows the view: left out, and the PVS is that of its leaves.
    PictureWindow window = {};               ///< The part of the picture that is drawn.
};

/// Objects whose chunks the PVS and the frustum leave; in a parallel projection the frustum alone. An object's place in
/// the order and its matrices do not depend on what else is visible, so that pictures do not depend on the PVS.
void find_visible(const VisibilityQuery& query, const View& view, VisibleSet& result);

/// The same set, its ranges cut into pieces of at most so many triangles.
VisibleSet in_pieces(const VisibleSet& whole, std::uint32_t triangles);
/// Those ranges that are marked, one byte for each, joined where they meet. Objects keep their places.
VisibleSet only_marked(const VisibleSet& pieces, std::span<const std::uint8_t> marks);

/// Places one object for a view; ranges stay empty.
VisibleObject place_object(const Scene& scene, ObjectId object, const View& view);

}  // namespace hw
