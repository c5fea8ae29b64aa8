// Why coordinates belong to charts and not to pixels: an axis chosen anew for each pixel breaks strokes wherever a
// smooth surface turns past 45 degrees. A chart goes on as long as it can be laid flat without much stretch, and ends
// at edges.
#include "hatchway/geometry/hatching/hatch_coordinates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <unordered_map>

#include "hatchway/core/disjoint_sets.hpp"
#include "hatchway/geometry/hatching/direction_layout.hpp"
#include "hatchway/geometry/surface/smooth_sides.hpp"
#include "hatchway/geometry/topology/weld.hpp"

namespace hw {
namespace {

constexpr float kStaysOnAxis = 0.62f;  // a chart of the box goes on over faces turned by up to 52 degrees
constexpr float kCapCosine = 0.85f;    // flatter faces of a cylinder are its caps
constexpr float kLongShare = 1.5f;     // a mesh this much longer along one axis lies around that axis

/// Coordinates of each corner, before vertices are made of them.
using CornerUv = std::vector<glm::vec2>;

/// The axis a face looks along, 0 to 2, and 3 to 5 where it looks against it. The slight preference decides faces at 45
/// degrees the same way everywhere.
int nearest_axis(const glm::vec3& normal)
{
    const glm::vec3 size = glm::abs(normal) * glm::vec3(1.0f, 1.02f, 1.01f);
    const int axis = size.y >= size.x && size.y >= size.z ? 1 : size.z >= size.x ? 2 : 0;
    return normal[axis] < 0.0f ? axis + 3 : axis;
}

float along_axis(const glm::vec3& normal, int axis)
{
    return axis >= 3 ? -normal[axis - 3] : normal[axis];
}

/// Right and up as someone sees them who looks at the face; on floors x is right and north, -z, is up.
glm::vec2 seen_along(int axis, const glm::vec3& p)
{
    switch (axis) {
        case 0:
            return {-p.z, p.y};
        case 1:
            return {p.x, -p.z};
        case 2:
            return {p.x, p.y};
        case 3:
            return {p.z, p.y};
        case 4:
            return {p.x, p.z};
        default:
            return {-p.x, p.y};
    }
}

/// An axis for each face: the nearest, or a smooth neighbour's as long as that one is near enough. Faces that look most
/// clearly along an axis choose first.
std::vector<int> face_axes(const SmoothSides& sides)
{
    const auto count = static_cast<std::uint32_t>(sides.normals.size());
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::vector<int> axes(count, -1);
    std::vector<float> clarity(count);
    for (std::uint32_t face = 0; face < count; ++face)
        clarity[face] = along_axis(sides.normals[face], nearest_axis(sides.normals[face]));
    std::ranges::stable_sort(order, std::ranges::greater(), [&](std::uint32_t face) { return clarity[face]; });
    for (const std::uint32_t face : order) {
        axes[face] = nearest_axis(sides.normals[face]);
        float best = kStaysOnAxis;
        for (std::uint32_t side = face * 3; side < face * 3 + 3; ++side) {
            if (!sides.is_smooth(side)) continue;
            const int of_neighbour = axes[sides.twin[side] / 3];
            if (of_neighbour < 0 || along_axis(sides.normals[face], of_neighbour) <= best) continue;
            best = along_axis(sides.normals[face], of_neighbour);
            axes[face] = of_neighbour;
        }
    }
    return axes;
}

CornerUv box_coordinates(const WeldedMesh& mesh, const SmoothSides& sides)
{
    const std::vector<int> axes = face_axes(sides);
    CornerUv uv;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
        for (const std::uint32_t corner : mesh.faces[face])
            uv.push_back(seen_along(axes[face], mesh.positions[corner]));
    return uv;
}

/// The axis that a mesh is round about: the longest where one is clearly longest, else the upright one.
int cylinder_axis(const glm::vec3& size)
{
    for (const int axis : {0, 2})
        if (size[axis] > kLongShare * std::max(size[(axis + 1) % 3], size[(axis + 2) % 3])) return axis;
    return 1;
}

CornerUv cylinder_coordinates(const WeldedMesh& mesh, const SmoothSides& sides)
{
    glm::vec3 low(mesh.positions.empty() ? glm::vec3(0.0f) : mesh.positions[0]);
    glm::vec3 high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 middle = 0.5f * (low + high);
    const int axis = cylinder_axis(high - low);
    const int right = axis == 1 ? 2 : (axis + 1) % 3;  // the other two, so that right, up, axis are right-handed
    const int up = axis == 1 ? 0 : (axis + 2) % 3;
    const float radius = 0.25f * ((high - low)[right] + (high - low)[up]);
    const auto angle_of = [&](const glm::vec3& p) { return std::atan2(p[up] - middle[up], p[right] - middle[right]); };
    constexpr float kTurn = 2.0f * std::numbers::pi_v<float>;
    CornerUv uv;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
        const auto& corners = mesh.faces[face];
        const glm::vec3& normal = sides.normals[face];
        if (std::abs(normal[axis]) > kCapCosine) {
            const int cap = normal[axis] < 0.0f ? axis + 3 : axis;
            for (const std::uint32_t corner : corners) uv.push_back(seen_along(cap, mesh.positions[corner]));
            continue;
        }
        const glm::vec3 sum = mesh.positions[corners[0]] + mesh.positions[corners[1]] + mesh.positions[corners[2]];
        const float at = angle_of(sum / 3.0f);
        for (const std::uint32_t corner : corners) {
            const float angle = angle_of(mesh.positions[corner]);
            const float turns = std::round((at - angle) / kTurn);  // whole: one vertex has one angle on either side
            uv.emplace_back(radius * (angle + turns * kTurn), mesh.positions[corner][axis]);
        }
    }
    return uv;
}

/// The direction in which u rises on a face; any in its plane where u does not change.
glm::vec3 rising_direction(const std::array<glm::vec3, 3>& p, const std::array<glm::vec2, 3>& uv,
                           const glm::vec3& normal)
{
    const glm::vec3 gradient =
        glm::cross(normal, (p[2] - p[1]) * uv[0].x + (p[0] - p[2]) * uv[1].x + (p[1] - p[0]) * uv[2].x);
    const float length = glm::length(gradient);
    if (length > 0.0f) return gradient / length;
    const glm::vec3 side = p[1] - p[0];
    const float side_length = glm::length(side);
    return side_length > 0.0f ? side / side_length : glm::vec3(1.0f, 0.0f, 0.0f);
}

struct VertexKey {
    std::uint32_t vertex;
    glm::vec2 uv;
    bool operator==(const VertexKey&) const = default;
};
struct VertexKeyHash {
    std::size_t operator()(const VertexKey& key) const
    {
        const std::hash<float> hash;
        return (key.vertex * 0x9e3779b97f4a7c15ull) ^ (hash(key.uv.x) * 0x85ebca6bu) ^ (hash(key.uv.y) << 17);
    }
};

/// One vertex for each use of a vertex of the mesh with the same coordinates. Triangles that welding removed have no
/// area: they are drawn by nobody and keep vertices of their own.
class VertexMaker {
 public:
    VertexMaker(const MeshData& mesh, HatchCoordinates& result) : mesh_(mesh), result_(result)
    {
        result_.indices.reserve(mesh.indices.size());
    }
    void add(std::uint32_t corner, const glm::vec2& uv, const glm::vec3& direction)
    {
        const std::uint32_t vertex = mesh_.indices[corner];
        const auto [place, is_new] =
            known_.try_emplace({vertex, uv}, static_cast<std::uint32_t>(result_.vertex.size()));
        if (is_new) {
            result_.vertex.push_back(vertex);
            result_.uv.push_back(uv);
            result_.direction.push_back(direction);
        } else {
            result_.direction[place->second] += direction;
        }
        result_.indices.push_back(place->second);
    }
    void finish()
    {
        for (glm::vec3& direction : result_.direction) {
            const float length = glm::length(direction);
            direction = length > 0.0f ? direction / length : glm::vec3(1.0f, 0.0f, 0.0f);
        }
    }

 private:
    const MeshData& mesh_;
    HatchCoordinates& result_;
    std::unordered_map<VertexKey, std::uint32_t, VertexKeyHash> known_;
};

void make_vertices(const MeshData& mesh, const WeldedMesh& welded, const SmoothSides& sides, const CornerUv& uv,
                   HatchCoordinates& result)
{
    VertexMaker maker(mesh, result);
    std::size_t face = 0;
    for (std::uint32_t triangle = 0; triangle < mesh.triangle_count(); ++triangle) {
        if (face < welded.face_triangle.size() && welded.face_triangle[face] == triangle) {
            std::array<glm::vec3, 3> p;
            for (int c = 0; c < 3; ++c) p[c] = welded.positions[welded.faces[face][c]];
            const std::array<glm::vec2, 3> corner_uv{uv[face * 3], uv[face * 3 + 1], uv[face * 3 + 2]};
            const glm::vec3 direction =
                rising_direction(p, corner_uv, sides.normals[face]) * (sides.areas[face] + 1e-20f);
            for (std::uint32_t c = 0; c < 3; ++c) maker.add(triangle * 3 + c, corner_uv[c], direction);
            ++face;
            continue;
        }
        for (std::uint32_t c = 0; c < 3; ++c) maker.add(triangle * 3 + c, glm::vec2(0.0f), glm::vec3(0.0f));
    }
    maker.finish();
}

/// Counts smooth edges over which coordinates break, and the pieces between all breaks.
void count_charts(const SmoothSides& sides, const CornerUv& uv, HatchReport& report)
{
    DisjointSets charts(sides.normals.size());
    const auto next = [](std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
    for (std::uint32_t side = 0; side < sides.twin.size(); ++side) {
        const std::uint32_t twin = sides.twin[side];
        if (twin == kNoSide || twin < side || sides.is_crease[side]) continue;
        if (uv[side] == uv[next(twin)] && uv[next(side)] == uv[twin])
            charts.join(side / 3, twin / 3);
        else
            ++report.chart_border_edges;
    }
    for (std::uint32_t face = 0; face < charts.size(); ++face)
        if (charts.of(face) == face) ++report.charts;
    report.crease_edges = sides.crease_edges;
}

}  // namespace

HatchCoordinates make_hatch_coordinates(const MeshData& mesh, HatchSource source, float crease_rad)
{
    const WeldedMesh welded = weld(mesh);
    const SmoothSides sides = find_smooth_sides(welded, crease_rad);
    HatchCoordinates result;
    CornerUv uv;
    if (source == HatchSource::principal) {
        const DirectionField field = principal_field(welded, sides);
        result.report.singularities = field.singularities;
        uv = lay_out(welded, sides, field);
    } else {
        uv = source == HatchSource::cylinder ? cylinder_coordinates(welded, sides) : box_coordinates(welded, sides);
    }
    count_charts(sides, uv, result.report);
    make_vertices(mesh, welded, sides, uv, result);
    return result;
}

}  // namespace hw
