#include "hatchway/render/view/visible_set.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <utility>

#include "hatchway/render/view/frame_block.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw {
namespace {

using Planes = std::array<glm::dvec4, 6>;

/// The planes of the frustum through a window of the picture, in object space, pointing inward, from the rows of the
/// matrix (Gribb and Hartmann 2001).
Planes frustum_planes(const glm::mat4& clip_from_object, const PictureWindow& window)
{
    const glm::dmat4 m = glm::transpose(glm::dmat4(clip_from_object));
    return {m[0] - window.min.x * m[3],
            window.max.x * m[3] - m[0],
            m[1] - window.min.y * m[3],
            window.max.y * m[3] - m[1],
            m[3] + m[2],
            m[3] - m[2]};
}

bool is_outside(const Box& box, const Planes& planes)
{
    for (const glm::dvec4& plane : planes) {
        const glm::dvec3 farthest(plane.x > 0.0 ? box.max.x : box.min.x, plane.y > 0.0 ? box.max.y : box.min.y,
                                  plane.z > 0.0 ? box.max.z : box.min.z);
        // A hair of tolerance: the matrix is rounded to float and the rasteriser's edge belongs to the picture.
        const double reach = std::abs(plane.x * farthest.x) + std::abs(plane.y * farthest.y) +
                             std::abs(plane.z * farthest.z) + std::abs(plane.w);
        if (glm::dot(glm::dvec3(plane), farthest) + plane.w < -1e-5 * reach) return true;
    }
    return false;
}

double distance_to(const Box& box, const glm::dvec3& eye)
{
    return glm::length(glm::max(glm::max(box.min - eye, eye - box.max), glm::dvec3(0.0)));
}

/// The order of drawing: from the eye, or in a parallel projection along the view.
double drawing_distance(const Box& box, const View& view)
{
    if (!view.is_orthographic()) return distance_to(box, view.eye_world);
    const glm::dvec3 forward = -glm::normalize(view.to_viewer_world);
    return glm::dot(box.centre() - view.eye_world, forward) - 0.5 * glm::dot(glm::abs(forward), box.size());
}

/// Radius of the sphere about the eye that holds the near plane's corners; of a perspective.
double near_radius(const View& view)
{
    const double near_plane = depth_range(view).x;
    const double x = 1.0 / view.clip_from_view[0][0];
    const double y = 1.0 / view.clip_from_view[1][1];
    return near_plane * std::sqrt(1.0 + x * x + y * y);
}

void add_range(VisibleSet& result, VisibleObject& item, IndexRange range)
{
    if (range.count == 0) return;
    if (item.range_count > 0 && result.ranges.back().first + result.ranges.back().count == range.first) {
        result.ranges.back().count += range.count;
        return;
    }
    result.ranges.push_back(range);
    ++item.range_count;
}

/// Collects the ranges of an object's chunks that may be seen. `seen` is one byte for each chunk, empty for all.
void collect_ranges(const MeshChunks& chunks, const Planes& planes, std::span<const std::uint8_t> seen,
                    VisibleSet& result, VisibleObject& item)
{
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        if (!seen.empty() && seen[i] == 0) continue;
        if (chunks.size() > 1 && is_outside(chunks[i].bounds_object, planes)) continue;
        add_range(result, item, {chunks[i].first_index, chunks[i].index_count});
    }
}

}  // namespace

std::uint64_t VisibleSet::triangle_count() const
{
    std::uint64_t indices = 0;
    for (const IndexRange& range : ranges) indices += range.count;
    return indices / 3;
}

VisibleObject place_object(const Scene& scene, ObjectId object, const View& view)
{
    const glm::dmat4& world_from_object = scene.world_from_object(object);
    glm::dmat4 relative = world_from_object;
    relative[3] -= glm::dvec4(view.eye_world, 0.0);
    const glm::dmat4 view_from_relative = glm::dmat4(glm::dmat3(glm::dmat4(view.view_from_world)));
    const double determinant = glm::determinant(glm::dmat3(world_from_object));
    VisibleObject item;
    item.object = object;
    item.clip_from_object = glm::mat4(glm::dmat4(view.clip_from_view) * view_from_relative * relative);
    item.relative_from_object = glm::mat4(relative);
    item.facing = (determinant < 0.0) != view.is_mirrored ? -1.0f : 1.0f;
    item.handedness = determinant < 0.0 ? -1.0f : 1.0f;
    item.scale = static_cast<float>(std::cbrt(std::abs(determinant)));
    // Of a matrix that flattens there is no inverse; any finite normals do.
    item.normal_from_object =
        determinant == 0.0 ? glm::mat3(relative) : glm::mat3(glm::inverseTranspose(glm::dmat3(world_from_object)));
    item.distance_m = drawing_distance(scene.objects[object].bounds_world, view);
    return item;
}

void find_visible(const VisibilityQuery& query, const View& view, VisibleSet& result)
{
    result = {};
    const Scene& scene = *query.scene;
    std::vector<std::uint8_t> seen;
    // A parallel projection is seen from a whole plane, not from a place whose sight is known: the frustum alone
    // decides. What a mirror shows of it is seen from the mirror all the same, but one rule is enough.
    const Visibility* const visibility = view.is_orthographic() ? nullptr : query.visibility;
    if (visibility != nullptr && query.mirror != nullptr) {
        chunks_before_pane(*visibility, query.mirror->outline_world, seen);
    } else if (visibility != nullptr) {
        visible_chunks(*visibility, view.eye_world, near_radius(view), seen);
        result.leaves_visible = visible_leaf_count(*visibility, view.eye_world, near_radius(view));
    }
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        if (!query.left_out.empty() && query.left_out[id] != 0) continue;
        if (query.mirror != nullptr && query.mirror->object == id) continue;
        const int mesh = scene.objects[id].mesh;
        std::span<const std::uint8_t> seen_chunks;
        if (visibility != nullptr) {
            const std::uint32_t first = visibility->first_slot_of_object[id];
            const std::uint32_t end = visibility->first_slot_of_object[id + 1];
            seen_chunks = std::span(seen).subspan(first, end - first);
            if (std::find(seen_chunks.begin(), seen_chunks.end(), 1) == seen_chunks.end()) continue;
        }
        VisibleObject item = place_object(scene, id, view);
        item.first_range = static_cast<std::uint32_t>(result.ranges.size());
        const Planes planes = frustum_planes(item.clip_from_object, query.window);
        if (is_outside(query.mesh_bounds[mesh], planes)) continue;
        if (query.chunks.empty())
            add_range(result, item, {0, static_cast<std::uint32_t>(scene.meshes[mesh].indices.size())});
        else
            collect_ranges(query.chunks[mesh], planes, seen_chunks, result, item);
        if (item.range_count > 0) result.objects.push_back(item);
    }
    std::sort(result.objects.begin(), result.objects.end(), [](const VisibleObject& a, const VisibleObject& b) {
        return a.distance_m != b.distance_m ? a.distance_m < b.distance_m : a.object < b.object;
    });
}

VisibleSet in_pieces(const VisibleSet& whole, std::uint32_t triangles)
{
    VisibleSet pieces;
    pieces.leaves_visible = whole.leaves_visible;
    const std::uint32_t most = 3 * triangles;
    for (VisibleObject object : whole.objects) {
        const std::span<const IndexRange> ranges =
            std::span(whole.ranges).subspan(object.first_range, object.range_count);
        object.first_range = static_cast<std::uint32_t>(pieces.ranges.size());
        for (const IndexRange& range : ranges)
            for (std::uint32_t done = 0; done < range.count; done += most)
                pieces.ranges.push_back({range.first + done, std::min(most, range.count - done)});
        object.range_count = static_cast<std::uint32_t>(pieces.ranges.size()) - object.first_range;
        pieces.objects.push_back(object);
    }
    return pieces;
}

VisibleSet only_marked(const VisibleSet& pieces, std::span<const std::uint8_t> marks)
{
    VisibleSet marked;
    marked.leaves_visible = pieces.leaves_visible;
    for (VisibleObject object : pieces.objects) {
        const std::uint32_t first = object.first_range;
        const std::uint32_t count = std::exchange(object.range_count, 0);
        object.first_range = static_cast<std::uint32_t>(marked.ranges.size());
        for (std::uint32_t i = first; i < first + count; ++i)
            if (marks[i] != 0) add_range(marked, object, pieces.ranges[i]);
        marked.objects.push_back(object);
    }
    return marked;
}

}  // namespace hw
