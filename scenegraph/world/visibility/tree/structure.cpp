#include "hatchway/world/visibility/tree/structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "hatchway/core/budget.hpp"
#include "hatchway/core/error.hpp"
#include "hatchway/world/named_nodes.hpp"
#include "hatchway/world/open_backs.hpp"
#include "hatchway/world/visibility/tree/coplanar.hpp"
#include "hatchway/world/visibility/tree/large_planes.hpp"

namespace hw {
namespace {

/// Shows each triangle that may block sight: opaque and static ones. Of more than kMostShown only the objects with the
/// fewest.
class BlockingTriangles {
 public:
    BlockingTriangles(const Scene& scene, const Level& level, const Grid& grid)
        : scene_(scene), grid_(grid), is_named_node_(structure_nodes(scene, level)), open_backs_(find_open_backs(scene))
    {
        std::size_t most = 0;  // of one object
        std::vector<std::size_t> counts;
        visit_objects([&](ObjectId id) { counts.push_back(triangle_count(id)); });
        std::sort(counts.begin(), counts.end());
        for (const std::size_t count : counts) {
            all_count_ += count;
            if (all_count_ <= kMostShown) most = count;
        }
        most_of_object_ = all_count_ <= kMostShown ? all_count_ : most;
        visit_chosen([&](ObjectId id) { count_ += triangle_count(id); });
    }

    std::size_t count() const { return count_; }
    std::size_t all_count() const { return all_count_; }

    template <typename Visit>
    void visit(const Visit& visit) const
    {
        visit_chosen([&](ObjectId id) { visit_object(id, visit); });
    }

 private:
    static constexpr std::size_t kMostShown = 12'000'000;

    std::size_t triangle_count(ObjectId id) const { return mesh_of(id).indices.size() / 3; }

    template <typename Visit>
    void visit_chosen(const Visit& visit) const
    {
        std::size_t left = kMostShown;
        visit_objects([&](ObjectId id) {
            const std::size_t count = triangle_count(id);
            if (count > most_of_object_ || count > left) return;
            left -= count;
            visit(id);
        });
    }

    const MeshData& mesh_of(ObjectId id) const
    {
        return scene_.meshes[static_cast<std::size_t>(scene_.objects[id].mesh)];
    }

    template <typename Visit>
    void visit_objects(const Visit& visit) const
    {
        for (ObjectId id = 0; id < scene_.objects.size(); ++id) {
            const Object& object = scene_.objects[id];
            if (scene_.nodes[static_cast<std::size_t>(object.node)].is_animated) continue;
            if (scene_.materials[static_cast<std::size_t>(object.material)].alpha_mode == AlphaMode::opaque) visit(id);
        }
    }

    template <typename Visit>
    void visit_object(ObjectId id, const Visit& visit) const
    {
        const Object& object = scene_.objects[id];
        const MeshData& mesh = mesh_of(id);
        const glm::dmat4& matrix = scene_.world_from_object(id);
        // A mirroring transform turns the winding round, and what is drawn with it.
        const bool is_mirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
        GridTriangle triangle;
        triangle.is_double_sided = open_backs_[id];
        triangle.is_named = is_named_node_[static_cast<std::size_t>(object.node)] != 0;
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const glm::dvec3 position(mesh.positions[mesh.indices[i + corner]]);
                triangle.corners[corner] = snapped(grid_, glm::dvec3(matrix * glm::dvec4(position, 1.0)));
            }
            if (is_mirrored) std::swap(triangle.corners[1], triangle.corners[2]);
            visit(triangle);
        }
    }

    const Scene& scene_;
    const Grid& grid_;
    std::vector<char> is_named_node_;
    std::vector<bool> open_backs_;
    std::size_t all_count_ = 0;
    std::size_t count_ = 0;
    std::size_t most_of_object_ = 0;  ///< Objects of more triangles are passed over.
};

/// About `most` of them, in their order: those in large planes. The others are never held.
std::vector<GridTriangle> chosen_triangles(const BlockingTriangles& all, std::size_t most, double step_m)
{
    std::vector<GridTriangle> triangles;
    LargePlanes planes(step_m);
    const bool are_many = all.count() > most;
    if (are_many) {
        all.visit([&](const GridTriangle& triangle) { planes.add_area(triangle); });
        all.visit([&](const GridTriangle& triangle) { planes.rank(triangle); });
        planes.choose(most);
    }
    all.visit([&](const GridTriangle& triangle) {
        if (!are_many || planes.keeps(triangle)) triangles.push_back(triangle);
    });
    return triangles;
}

void set_box(Structure& structure, const Box& bounds_world)
{
    // A sight line between two points of the box never leaves it, so the box is as tight as can be: what lies in its
    // faces blocks nothing, and there is no outside to look around through.
    structure.box_min = snapped(structure.grid, bounds_world.min);
    structure.box_max = snapped(structure.grid, bounds_world.max);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (structure.box_max[axis] - structure.box_min[axis] >= 128) continue;
        structure.box_min[axis] -= 64;
        structure.box_max[axis] += 64;
    }
}

/// The numbers of the planes of the box's faces.
std::vector<int> box_planes(Structure& structure)
{
    std::vector<int> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const std::int64_t place : {structure.box_min[axis], structure.box_max[axis]}) {
            std::array<std::int64_t, 3> normal{};
            normal[axis] = 1;
            result.push_back(structure.planes.add(make_plane(normal, -static_cast<Int128>(place))).plane);
        }
    }
    return result;
}

double largest_side(const Box& box)
{
    const glm::dvec3 s = box.size();
    return std::max({s.x * s.y, s.y * s.z, s.z * s.x});
}

struct FlatPlanes {
    std::vector<SidePlane> of_polygon;
    std::vector<double> area;  ///< Of all polygons in the plane of each polygon, by polygon; squares of grid steps.
};

FlatPlanes planes_of(const std::vector<FlatPolygon>& polygons, Structure& structure)
{
    FlatPlanes planes;
    std::vector<double> area_of_plane;
    for (const FlatPolygon& flat : polygons) {
        planes.of_polygon.push_back(structure.planes.add(flat.plane));
        area_of_plane.resize(static_cast<std::size_t>(structure.planes.size()));
        area_of_plane[static_cast<std::size_t>(planes.of_polygon.back().plane)] += flat.area;
    }
    for (const SidePlane& plane : planes.of_polygon)
        planes.area.push_back(area_of_plane[static_cast<std::size_t>(plane.plane)]);
    return planes;
}

/// Polygons of planes with much area first.
std::vector<std::size_t> largest_first(const std::vector<FlatPolygon>& polygons, const FlatPlanes& planes)
{
    std::vector<std::size_t> order(polygons.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return planes.area[a] != planes.area[b] ? planes.area[a] > planes.area[b] : polygons[a].area > polygons[b].area;
    });
    return order;
}

BlockingPolygon blocking_polygon(const FlatPolygon& flat, const SidePlane& plane, bool is_detail, Structure& structure)
{
    BlockingPolygon polygon;
    polygon.polygon = polygon_over_ring(structure.planes, plane.plane, flat.ring);
    polygon.blocks_from_front = plane.is_flipped ? flat.blocks_from_back : flat.blocks_from_front;
    polygon.blocks_from_back = plane.is_flipped ? flat.blocks_from_front : flat.blocks_from_back;
    polygon.is_detail = is_detail;
    return polygon;
}

/// The planes of the polygons; the area in each is what counts: a wall may be made of many small panels.
void choose_polygons(const std::vector<FlatPolygon>& polygons, const Level& level, const StructureOptions& options,
                     Structure& structure)
{
    const double square_m = structure.grid.step_m * structure.grid.step_m;
    const std::vector<int> of_box = box_planes(structure);
    const FlatPlanes planes = planes_of(polygons, structure);
    const double least = options.least_area_share * structure.scene_side_m2 / square_m;
    const double least_named = 0.1 * least;
    int detail_count = 0;
    for (const std::size_t i : largest_first(polygons, planes)) {
        const SidePlane& plane = planes.of_polygon[i];
        if (std::find(of_box.begin(), of_box.end(), plane.plane) != of_box.end()) continue;
        const bool may_split =
            level.structure ? polygons[i].is_named && planes.area[i] >= least_named : planes.area[i] >= least;
        const bool is_detail = !may_split || structure.structure_count >= options.max_structure;
        if (is_detail && detail_count >= options.max_details) {
            ++structure.left_out;
            continue;
        }
        BlockingPolygon polygon = blocking_polygon(polygons[i], plane, is_detail, structure);
        if (is_detail && may_split)
            structure.demoted_world.push_back(structure.grid.origin_world +
                                              polygon.polygon.corners[0] * structure.grid.step_m);
        detail_count += is_detail;
        structure.structure_count += !is_detail;
        structure.area_m2 += area(polygon.polygon) * square_m;
        structure.polygons.push_back(std::move(polygon));
    }
    if (structure.structure_count > 0) return;
    // Without structure there is one cluster, and nothing in it needs to be sealed.
    structure.polygons.clear();
    structure.area_m2 = 0.0;
}

}  // namespace

std::vector<char> structure_nodes(const Scene& scene, const Level& level)
{
    std::vector<char> result(scene.nodes.size(), 0);
    if (!level.structure) return result;
    Budget budget;
    for (std::size_t entry = 0; entry < level.structure->size(); ++entry)
        mark_named_nodes(scene, {(*level.structure)[entry], level.file.string(), fmt::format("/structure/{}", entry)},
                         budget, result);
    return result;
}

Structure choose_structure(const Scene& scene, const Level& level, const StructureOptions& options)
{
    Structure structure;
    structure.grid = grid_for(scene.bounds_world);
    if (scene.bounds_world.is_empty()) {
        structure.box_min = {-1, -1, -1};
        structure.box_max = {1, 1, 1};
        return structure;
    }
    set_box(structure, {scene.bounds_world.min - options.margin_m, scene.bounds_world.max + options.margin_m});
    structure.scene_side_m2 = largest_side(scene.bounds_world);

    const BlockingTriangles all(scene, level, structure.grid);
    const std::vector<GridTriangle> triangles = chosen_triangles(all, options.max_triangles, structure.grid.step_m);
    structure.left_out = all.all_count() - triangles.size();
    std::vector<FlatPolygon> polygons = merge_coplanar(triangles, structure.grid.scaled(1e-5) / structure.grid.step_m);
    choose_polygons(polygons, level, options, structure);
    return structure;
}

}  // namespace hw
