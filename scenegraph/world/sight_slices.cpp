#include "world/sight_slices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <map>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/error.hpp"

namespace hw {
namespace {

constexpr double kBehind_m = 1e-3;    // a target must be so far behind the plane: what lies in it is seen
constexpr double kEyeSlack_m = 2e-5;  // eyes may be so far behind: boxes of leaves are rounded
constexpr double kMargin_m = 1e-4;    // by which a cross-section grows: the drawn surface was snapped
constexpr ClipTolerance kTolerance{1e-9, 1e-7};

/// The columns that a convex polygon touches in each row.
class RowSpans {
 public:
    RowSpans(int rows, double first_v, double texel_m) : first_v_(first_v), texel_m_(texel_m)
    {
        least_.assign(static_cast<std::size_t>(rows), std::numeric_limits<double>::infinity());
        most_.assign(static_cast<std::size_t>(rows), -std::numeric_limits<double>::infinity());
    }

    /// A side of the polygon, grown by `margin_m`.
    void add(double u0, double v0, double u1, double v1, double margin_m)
    {
        if (v0 > v1) std::swap(u0, u1), std::swap(v0, v1);
        const int rows = static_cast<int>(least_.size());
        const int from = std::max(0, static_cast<int>(std::floor((v0 - margin_m - first_v_) / texel_m_)));
        const int to = std::min(rows - 1, static_cast<int>(std::floor((v1 + margin_m - first_v_) / texel_m_)));
        const double slope = v1 - v0 > 1e-12 ? (u1 - u0) / (v1 - v0) : 0.0;
        for (int row = from; row <= to; ++row) {
            const double low = std::clamp(first_v_ + row * texel_m_ - margin_m, v0, v1);
            const double high = std::clamp(first_v_ + (row + 1) * texel_m_ + margin_m, v0, v1);
            double a = u0 + slope * (low - v0), b = u0 + slope * (high - v0);
            if (v1 - v0 <= 1e-12) a = u0, b = u1;
            double& least = least_[static_cast<std::size_t>(row)];
            double& most = most_[static_cast<std::size_t>(row)];
            least = std::min({least, a - margin_m, b - margin_m});
            most = std::max({most, a + margin_m, b + margin_m});
        }
    }
    double least(int row) const { return least_[static_cast<std::size_t>(row)]; }
    double most(int row) const { return most_[static_cast<std::size_t>(row)]; }

 private:
    double first_v_;
    double texel_m_;
    std::vector<double> least_, most_;
};

int column_of(const SightSlice& slice, double u)
{
    return static_cast<int>(std::floor((u - slice.first_u) / slice.texel_m));
}

int row_of(const SightSlice& slice, double v)
{
    return static_cast<int>(std::floor((v - slice.first_v) / slice.texel_m));
}

/// Sets the bits of columns [from, to] of a row.
void set_columns(std::vector<std::uint64_t>& bits, const SightSlice& slice, int row, int from, int to)
{
    for (int column = std::max(from, 0); column <= std::min(to, slice.columns - 1); ++column) {
        const std::size_t word = static_cast<std::size_t>(row * slice.words + column / 64);
        bits[word] |= std::uint64_t{1} << (column % 64);
    }
}

/// Whether any of the columns [from, to] of a row is open.
bool any_open(const std::vector<std::uint64_t>& bits, const SightSlice& slice, int row, int from, int to)
{
    const int first_word = from / 64, last_word = to / 64;
    for (int word = first_word; word <= last_word; ++word) {
        std::uint64_t mask = ~std::uint64_t{0};
        if (word == first_word) mask &= ~std::uint64_t{0} << (from % 64);
        if (word == last_word) mask &= ~std::uint64_t{0} >> (63 - to % 64);
        if (bits[static_cast<std::size_t>(row * slice.words + word)] & mask) return true;
    }
    return false;
}

void open_polygon(SightSlice& slice, std::span<const glm::dvec3> corners, bool forward, bool backward)
{
    RowSpans spans(slice.rows, slice.first_v, slice.texel_m);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        spans.add(glm::dot(a, slice.u), glm::dot(a, slice.v), glm::dot(b, slice.u), glm::dot(b, slice.v), 1e-9);
    }
    for (int row = 0; row < slice.rows; ++row) {
        if (spans.least(row) > spans.most(row)) continue;
        const int from = column_of(slice, spans.least(row)), to = column_of(slice, spans.most(row));
        if (forward) set_columns(slice.open_forward, slice, row, from, to);
        if (backward) set_columns(slice.open_backward, slice, row, from, to);
    }
}

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

std::array<glm::dvec3, 8> corners_of(const Box& box)
{
    std::array<glm::dvec3, 8> result;
    for (std::size_t i = 0; i < 8; ++i) {
        result[i] = {(i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y, (i & 4) ? box.max.z : box.min.z};
    }
    return result;
}

struct FlatPoint {
    double u, v;
};

/// The convex hull, in place; returns its size. Andrew's monotone chain.
std::size_t make_hull(std::array<FlatPoint, 64>& points, std::array<FlatPoint, 130>& hull)
{
    std::sort(points.begin(), points.end(),
              [](const FlatPoint& a, const FlatPoint& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
    const auto turns_right = [](const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
        return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u) <= 0.0;
    };
    std::size_t count = 0;
    for (const FlatPoint& point : points) {
        while (count >= 2 && turns_right(hull[count - 2], hull[count - 1], point)) --count;
        hull[count++] = point;
    }
    const std::size_t lower = count + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) {
        while (count >= lower && turns_right(hull[count - 2], hull[count - 1], points[i])) --count;
        hull[count++] = points[i];
    }
    return count;
}

bool is_open_at(const SightSlice& slice, const std::vector<std::uint64_t>& open, double u, double v)
{
    const int column = column_of(slice, u), row = row_of(slice, v);
    if (column < 0 || row < 0 || column >= slice.columns || row >= slice.rows) return true;
    return (open[static_cast<std::size_t>(row * slice.words + column / 64)] >> (column % 64) & 1) != 0;
}

/// `side` is positive for sight from the front.
bool is_open_at(const SightSlice& slice, double side, const glm::dvec3& point)
{
    const std::vector<std::uint64_t>& open = side > 0.0 ? slice.open_backward : slice.open_forward;
    return is_open_at(slice, open, glm::dot(point, slice.u), glm::dot(point, slice.v));
}

/// Whether all lines from corner to corner cross closed texels: their hull is the cross-section of the shaft.
bool is_closed(const SightSlice& slice, double side, const Box& eyes, const Box& target)
{
    const std::vector<std::uint64_t>& open = side > 0.0 ? slice.open_backward : slice.open_forward;
    const auto from = corners_of(eyes), to = corners_of(target);
    std::array<FlatPoint, 64> points;
    std::array<double, 8> to_distance, to_u, to_v;
    for (std::size_t k = 0; k < 8; ++k) {
        to_distance[k] = std::abs(slice.plane.distance(to[k]));
        to_u[k] = glm::dot(to[k], slice.u);
        to_v[k] = glm::dot(to[k], slice.v);
    }
    double least_u = std::numeric_limits<double>::infinity(), least_v = least_u, most_u = -least_u, most_v = -least_u;
    for (std::size_t i = 0; i < 8; ++i) {
        // Eyes a hair behind the plane count as in it.
        const double distance = std::max(0.0, std::copysign(1.0, side) * slice.plane.distance(from[i]));
        const double u = glm::dot(from[i], slice.u), v = glm::dot(from[i], slice.v);
        for (std::size_t k = 0; k < 8; ++k) {
            const double share = distance / (distance + to_distance[k]);
            const FlatPoint p{u + share * (to_u[k] - u), v + share * (to_v[k] - v)};
            if (is_open_at(slice, open, p.u, p.v)) return false;
            points[8 * i + k] = p;
            least_u = std::min(least_u, p.u);
            most_u = std::max(most_u, p.u);
            least_v = std::min(least_v, p.v);
            most_v = std::max(most_v, p.v);
        }
    }
    const int from_row = row_of(slice, least_v - kMargin_m), to_row = row_of(slice, most_v + kMargin_m);
    const int from_column = column_of(slice, least_u - kMargin_m), to_column = column_of(slice, most_u + kMargin_m);
    if (from_row < 0 || to_row >= slice.rows || from_column < 0 || to_column >= slice.columns) return false;
    bool is_rectangle_closed = true;
    for (int row = from_row; row <= to_row && is_rectangle_closed; ++row)
        is_rectangle_closed = !any_open(open, slice, row, from_column, to_column);
    if (is_rectangle_closed) return true;
    std::array<FlatPoint, 130> hull;
    const std::size_t count = make_hull(points, hull);
    RowSpans spans(to_row - from_row + 1, slice.first_v + from_row * slice.texel_m, slice.texel_m);
    for (std::size_t i = 0; i < count; ++i) {
        const FlatPoint &a = hull[i], &b = hull[(i + 1) % count];
        spans.add(a.u, a.v, b.u, b.v, kMargin_m);
    }
    for (int row = from_row; row <= to_row; ++row) {
        const double least = spans.least(row - from_row), most = spans.most(row - from_row);
        if (least > most) continue;
        if (any_open(open, slice, row, column_of(slice, least), column_of(slice, most))) return false;
    }
    return true;
}

}  // namespace

SightSlices::SightSlices(const BspBuild& build, std::span<const LeafContact> contacts, std::span<const Box> leaf_boxes,
                         const SliceOptions& options)
{
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
                                     (std::abs(far) - far_reach >= kBehind_m));
    }
    return count;
}

bool SightSlices::hides(const Box& eyes, const Box& target, int& last) const
{
    std::array<int, kMostSlices + 1> found;
    const std::size_t count = between(eyes, target, found);
    const auto first = std::find(found.begin(), found.begin() + count, last);
    if (first != found.begin() + count) std::swap(*first, found[0]);
    const glm::dvec3 from = eyes.centre(), to = target.centre();
    for (std::size_t i = 0; i < count; ++i) {
        const SightSlice& slice = slices_[static_cast<std::size_t>(found[i])];
        const double near = slice.plane.distance(from), far = slice.plane.distance(to);
        if (is_open_at(slice, near, from + (to - from) * (near / (near - far)))) continue;
        if (!is_closed(slice, near, eyes, target)) continue;
        last = found[i];
        return true;
    }
    return false;
}

int SightSlices::cut(const glm::dvec3& from, const glm::dvec3& to) const
{
    std::array<int, kMostSlices + 1> found;
    const std::size_t count = between({from, from}, {to, to}, found);
    for (std::size_t i = 0; i < count; ++i) {
        const SightSlice& slice = slices_[static_cast<std::size_t>(found[i])];
        const double near = slice.plane.distance(from), far = slice.plane.distance(to);
        if (!is_open_at(slice, near, from + (to - from) * (near / (near - far)))) return found[i];
    }
    return -1;
}

}  // namespace hw
