#include "hatchway/world/visibility/rows/sight_slices.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <map>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

constexpr double kBehind_m = 1e-3;    // least: what lies in the plane itself is seen
constexpr double kEyeSlack_m = 2e-5;  // eyes may be so far behind: boxes of leaves are rounded
constexpr ClipTolerance kTolerance{1e-9, 1e-7};

/// Makes the bitmaps of slices.
class SliceMaker {
 public:
    SliceMaker(const BspBuild& build, std::span<const LeafContact> contacts, const SliceOptions& options)
        : build_(build), options_(options), step_m_(build.tree.grid.step_m)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box_.min[static_cast<int>(axis)] = static_cast<double>(build.box_min[axis]) * step_m_;
            box_.max[static_cast<int>(axis)] = static_cast<double>(build.box_max[axis]) * step_m_;
        }
        for (const LeafContact& contact : contacts)
            contacts_of_plane_[build.plane_of_node[contact.node]].push_back(&contact);
        for (std::size_t node = 0; node < build.plane_of_node.size(); ++node)
            nodes_of_plane_[build.plane_of_node[node]].push_back(node);
    }

    /// `plane_number` is the plane's in the tree, or -1 for a plane inside of walls.
    SightSlice make(const FlowPlane& plane, int plane_number) const
    {
        SightSlice slice;
        slice.plane = plane;
        slice.margin_m = std::max(slice.margin_m, 8.0 * step_m_);
        const glm::dvec3 a = glm::abs(plane.normal);
        const glm::dvec3 helper = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                                  : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                           : glm::dvec3(0, 0, 1);
        slice.u = glm::normalize(glm::cross(helper, plane.normal));
        slice.v = glm::cross(plane.normal, slice.u);
        const Winding whole = plane_in_box(slice);
        if (whole.count < 3) return slice;
        std::vector<Winding> open, closed;
        const int root = build_.tree.nodes.empty() ? ~0 : 0;
        sort_leaves(plane_number, root, whole, open, closed);
        frame(slice, plane_number, closed);
        if (slice.rows == 0) return slice;
        for (const Winding& piece : open)
            open_polygon(slice, {piece.points.data(), static_cast<std::size_t>(piece.count)}, true, true);
        const auto own = contacts_of_plane_.find(plane_number);
        if (own == contacts_of_plane_.end()) return slice;
        for (const LeafContact* contact : own->second) {
            if (is_solid(contact->front_leaf) || is_solid(contact->back_leaf)) continue;
            for (const auto& opening : contact->forward) open_polygon(slice, opening, true, false);
            for (const auto& opening : contact->backward) open_polygon(slice, opening, false, true);
        }
        return slice;
    }

 private:
    bool is_solid(int leaf) const { return build_.tree.is_solid[static_cast<std::size_t>(leaf)] != 0; }

    Winding plane_in_box(const SightSlice& slice) const
    {
        const glm::dvec3 centre = box_.centre();
        const glm::dvec3 foot = centre - slice.plane.normal * slice.plane.distance(centre);
        const double reach = glm::length(box_.size());
        Winding winding;
        winding.count = 4;
        winding.points[0] = foot - slice.u * reach - slice.v * reach;
        winding.points[1] = foot + slice.u * reach - slice.v * reach;
        winding.points[2] = foot + slice.u * reach + slice.v * reach;
        winding.points[3] = foot - slice.u * reach + slice.v * reach;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 normal(0.0);
            normal[axis] = 1.0;
            if (!clip(winding, {normal, -box_.min[axis]}, kTolerance) ||
                !clip(winding, {-normal, box_.max[axis]}, kTolerance)) {
                winding.count = 0;
                break;
            }
        }
        return winding;
    }

    /// Lays the bitmap around what closes the plane; beyond it all is open.
    void frame(SightSlice& slice, int plane_number, const std::vector<Winding>& closed) const
    {
        constexpr double kNone = std::numeric_limits<double>::infinity();
        glm::dvec2 least(kNone), most(-kNone);
        const auto add = [&](const glm::dvec3& point) {
            const glm::dvec2 place(glm::dot(point, slice.u), glm::dot(point, slice.v));
            least = glm::min(least, place);
            most = glm::max(most, place);
        };
        const auto own = nodes_of_plane_.find(plane_number);
        if (own != nodes_of_plane_.end()) {
            for (const std::size_t node : own->second) {
                for (const BlockingPolygon& polygon : build_.polygons_of_node[node]) {
                    for (const glm::dvec3& corner : polygon.polygon.corners) add(corner * step_m_);
                }
            }
        } else {
            for (const Winding& piece : closed) {
                for (int i = 0; i < piece.count; ++i) add(piece[i]);
            }
        }
        const glm::dvec2 size = most - least;
        if (!(size.x > 0.0 && size.y > 0.0)) return;
        // A rim of one texel: no sight line leaves the scene's box, so what lies beyond it is closed.
        slice.texel_m = std::max(size.x, size.y) / options_.texels;
        slice.first_u = least.x - slice.texel_m;
        slice.first_v = least.y - slice.texel_m;
        slice.columns = static_cast<int>(std::ceil(size.x / slice.texel_m)) + 2;
        slice.rows = static_cast<int>(std::ceil(size.y / slice.texel_m)) + 2;
        slice.words = (slice.columns + 63) / 64;
        slice.open_forward.assign(static_cast<std::size_t>(slice.rows * slice.words), 0);
        slice.open_backward = slice.open_forward;
    }

    /// What of the polygon lies within leaves that are not solid, and in solid ones. What lies on a node of the same
    /// plane is left to its contacts.
    void sort_leaves(int plane_number, int child, const Winding& polygon, std::vector<Winding>& open,
                     std::vector<Winding>& closed) const
    {
        if (child < 0) {
            (is_solid(~child) ? closed : open).push_back(polygon);
            return;
        }
        const std::size_t index = static_cast<std::size_t>(child);
        if (build_.plane_of_node[index] == plane_number) return;
        const BspNode& node = build_.tree.nodes[index];
        const FlowPlane plane{node.plane.unit_normal, node.plane.unit_offset * step_m_};
        Winding front = polygon, back = polygon;
        const bool has_front = clip(front, plane, kTolerance);
        const bool has_back = clip(back, {-plane.normal, -plane.offset}, kTolerance);
        const bool is_on = !has_front && !has_back;
        if (has_front || is_on) sort_leaves(plane_number, node.front, is_on ? polygon : front, open, closed);
        if (has_back || is_on) sort_leaves(plane_number, node.back, is_on ? polygon : back, open, closed);
    }

    const BspBuild& build_;
    SliceOptions options_;
    double step_m_;
    Box box_;
    std::map<int, std::vector<const LeafContact*>> contacts_of_plane_;
    std::map<int, std::vector<std::size_t>> nodes_of_plane_;
};

struct SlicePlane {
    FlowPlane plane;
    int number = -1;
};

/// The planes with the largest blocking area.
void add_face_planes(const BspBuild& build, const SliceOptions& options, std::vector<SlicePlane>& planes)
{
    std::map<int, double> area_of_plane;
    for (std::size_t node = 0; node < build.polygons_of_node.size(); ++node) {
        for (const BlockingPolygon& polygon : build.polygons_of_node[node])
            area_of_plane[build.plane_of_node[node]] += area(polygon.polygon);
    }
    std::vector<std::pair<double, int>> order;
    for (const auto& [number, plane_area] : area_of_plane) order.emplace_back(-plane_area, number);
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), static_cast<std::size_t>(options.most_faces)));
    for (const auto& [negative_area, number] : order) {
        const ExactPlane& plane = build.planes[number];
        planes.push_back({{plane.unit_normal, plane.unit_offset * build.tree.grid.step_m}, number});
    }
}

/// Planes across an axis where much is solid: the highest places of the solid cross-section along it.
void add_solid_planes(const BspBuild& build, std::span<const Box> leaf_boxes, const SliceOptions& options,
                      std::vector<SlicePlane>& planes)
{
    constexpr int kPlaces = 2048;
    Box box;
    for (const Box& leaf : leaf_boxes) box.add(leaf);
    if (box.is_empty()) return;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::vector<double> area(kPlaces, 0.0);
        const double step = box.size()[axis] / kPlaces;
        if (!(step > 0.0)) continue;
        for (std::size_t leaf = 0; leaf < leaf_boxes.size(); ++leaf) {
            if (!build.tree.is_solid[leaf] || leaf_boxes[leaf].is_empty()) continue;
            const glm::dvec3 size = leaf_boxes[leaf].size();
            const int from = static_cast<int>(std::ceil((leaf_boxes[leaf].min[axis] - box.min[axis]) / step));
            const int to = static_cast<int>(std::floor((leaf_boxes[leaf].max[axis] - box.min[axis]) / step));
            for (int place = std::max(from, 0); place <= std::min(to, kPlaces - 1); ++place)
                area[static_cast<std::size_t>(place)] += size[u] * size[v];
        }
        for (int slice = 0; slice < options.most_solids; ++slice) {
            const auto best = std::max_element(area.begin(), area.end());
            if (*best < 1e-3 * box.size()[u] * box.size()[v]) break;
            const int place = static_cast<int>(best - area.begin());
            glm::dvec3 normal(0.0);
            normal[axis] = 1.0;
            planes.push_back({{normal, -(box.min[axis] + place * step)}, -1});
            const int apart = kPlaces / 256;
            for (int near = std::max(0, place - apart); near <= std::min(kPlaces - 1, place + apart); ++near)
                area[static_cast<std::size_t>(near)] = 0.0;
        }
    }
}

}  // namespace

SightSlices::SightSlices(const BspBuild& build, std::span<const LeafContact> contacts, std::span<const Box> leaf_boxes,
                         const SliceOptions& options)
{
    behind_m_ = std::max(kBehind_m, 64.0 * build.tree.grid.step_m);
    HW_ASSERT(options.most_faces + 3 * options.most_solids <= static_cast<int>(kMostSlices));
    std::vector<SlicePlane> planes;
    add_face_planes(build, options, planes);
    add_solid_planes(build, leaf_boxes, options, planes);
    const SliceMaker maker(build, contacts, options);
    slices_.resize(planes.size());
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, planes.size(),
                          [&](std::size_t i) { slices_[i] = maker.make(planes[i].plane, planes[i].number); });
    });
    std::erase_if(slices_, [](const SightSlice& slice) { return slice.rows == 0; });
    for (const SightSlice& slice : slices_) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            normals_[axis].push_back(slice.plane.normal[static_cast<int>(axis)]);
        offsets_.push_back(slice.plane.offset);
    }
}

std::size_t SightSlices::between(const Box& eyes, const Box& target, std::span<int> found) const
{
    const glm::dvec3 from = eyes.centre(), to = target.centre();
    const glm::dvec3 from_half = 0.5 * eyes.size(), to_half = 0.5 * target.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
        const double x = normals_[0][i], y = normals_[1][i], z = normals_[2][i];
        const double near = x * from.x + y * from.y + z * from.z + offsets_[i];
        const double far = x * to.x + y * to.y + z * to.z + offsets_[i];
        const double near_reach = std::abs(x) * from_half.x + std::abs(y) * from_half.y + std::abs(z) * from_half.z;
        const double far_reach = std::abs(x) * to_half.x + std::abs(y) * to_half.y + std::abs(z) * to_half.z;
        found[count] = static_cast<int>(i);
        count +=
            static_cast<std::size_t>(((near > 0.0) != (far > 0.0)) & (std::abs(near) - near_reach >= -kEyeSlack_m) &
                                     (std::abs(far) - far_reach >= behind_m_));
    }
    return count;
}

bool SightSlices::parts(std::size_t slice, const Box& eyes, const Box& target) const
{
    const FlowPlane& plane = slices_[slice].plane;
    const double near = plane.distance(eyes.centre()), far = plane.distance(target.centre());
    const glm::dvec3 reach = glm::abs(plane.normal);
    return (near > 0.0) != (far > 0.0) && std::abs(near) - 0.5 * glm::dot(reach, eyes.size()) >= -kEyeSlack_m &&
           std::abs(far) - 0.5 * glm::dot(reach, target.size()) >= behind_m_;
}

bool SightSlices::hides(std::size_t number, const Box& eyes, const Box& target) const
{
    const SightSlice& slice = slices_[number];
    const glm::dvec3 from = eyes.centre(), to = target.centre();
    const double near = slice.plane.distance(from), far = slice.plane.distance(to);
    return !is_open_at(slice, near, from + (to - from) * (near / (near - far))) && is_closed(slice, near, eyes, target);
}

bool SightSlices::cuts(std::size_t number, const glm::dvec3& from, const glm::dvec3& to) const
{
    const SightSlice& slice = slices_[number];
    const double near = slice.plane.distance(from), far = slice.plane.distance(to);
    return !is_open_at(slice, near, from + (to - from) * (near / (near - far)));
}

bool SightSlices::hides(const Box& eyes, const Box& target, int& last) const
{
    const auto asks_last = [&](const std::size_t slice) {
        return parts(slice, eyes, target) && hides(slice, eyes, target);
    };
    if (last >= 0 && asks_last(static_cast<std::size_t>(last))) return true;
    std::array<int, kMostSlices + 1> found;  // NOLINT: filled below `count`
    const std::size_t count = between(eyes, target, found);
    for (std::size_t i = 0; i < count; ++i) {
        if (found[i] == last || !hides(static_cast<std::size_t>(found[i]), eyes, target)) continue;
        last = found[i];
        return true;
    }
    return false;
}

int SightSlices::cut(const glm::dvec3& from, const glm::dvec3& to, int last) const
{
    const Box eye{from, from}, target{to, to};
    if (last >= 0 && parts(static_cast<std::size_t>(last), eye, target) &&
        cuts(static_cast<std::size_t>(last), from, to))
        return last;
    std::array<int, kMostSlices + 1> found;  // NOLINT: filled below `count`
    const std::size_t count = between(eye, target, found);
    for (std::size_t i = 0; i < count; ++i) {
        if (cuts(static_cast<std::size_t>(found[i]), from, to)) return found[i];
    }
    return -1;
}

}  // namespace hw
