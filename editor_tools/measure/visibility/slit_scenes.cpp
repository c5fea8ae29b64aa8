#include "measure/visibility/slit_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "measure/visibility/pvs_rays.hpp"

namespace hw::measure {
namespace {

constexpr double kWall = 1.0;  // so thick that a line through a slit can hardly turn
constexpr double kLow = -5.0;  // of every room, in y and z
constexpr double kHigh = 5.0;
constexpr double kRoom = 8.0;    // from wall to wall, along x
constexpr double kTarget = 0.5;  // half a side

struct Quad {
    glm::dvec3 a, b, c, d;
};

ObjectId add_object(Scene& scene, const std::vector<Quad>& quads)
{
    MeshData mesh;
    Object object;
    for (const Quad& quad : quads) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec3& corner : {quad.a, quad.b, quad.c, quad.d}) {
            mesh.positions.emplace_back(corner);
            object.bounds_world.add(corner);
        }
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
    }
    object.node = static_cast<int>(scene.nodes.size());
    object.mesh = static_cast<int>(scene.meshes.size());
    object.material = 0;
    scene.bounds_world.add(object.bounds_world);
    scene.nodes.push_back({.name = "n", .path = fmt::format("n{}", object.node)});
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back(object);
    return static_cast<ObjectId>(scene.objects.size() - 1);
}

/// Drawn from outside, or from inside: a room.
ObjectId add_box(Scene& scene, const glm::dvec3& low, const glm::dvec3& high, bool is_room = false)
{
    const auto at = [&](int i) {
        return glm::dvec3((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z);
    };
    std::vector<Quad> quads{{at(0), at(2), at(3), at(1)}, {at(4), at(5), at(7), at(6)}, {at(0), at(1), at(5), at(4)},
                            {at(2), at(6), at(7), at(3)}, {at(0), at(4), at(6), at(2)}, {at(1), at(3), at(7), at(5)}};
    if (is_room) {
        for (Quad& quad : quads) std::swap(quad.b, quad.d);
    }
    return add_object(scene, quads);
}

/// A wall from floor to ceiling whose near side is at `x`, with an upright slit in it; none where `width` is 0.
void add_wall(Scene& scene, double x, double width, double slit_z = 0.0)
{
    if (width == 0.0) {
        add_box(scene, {x, kLow, kLow}, {x + kWall, kHigh, kHigh});
        return;
    }
    add_box(scene, {x, kLow, kLow}, {x + kWall, kHigh, slit_z - 0.5 * width});
    add_box(scene, {x, kLow, slit_z + 0.5 * width}, {x + kWall, kHigh, kHigh});
}

/// `rooms` in a row along x with space for walls between; the eye is in the first, the target in the last.
SlitScene rooms_in_a_row(const std::string& name, int rooms, bool is_seen)
{
    SlitScene result{.name = name, .eye = {2.0, 0.0, 0.0}, .is_seen = is_seen};
    result.scene.materials.resize(1);
    const double length = rooms * kRoom + (rooms - 1) * kWall;
    add_box(result.scene, {0.0, kLow, kLow}, {length, kHigh, kHigh}, true);
    const glm::dvec3 middle(length - 2.0, 0.0, 0.0);
    result.target = add_box(result.scene, middle - kTarget, middle + kTarget);
    return result;
}

SlitScene one_wall(const std::string& name, double width, bool is_seen)
{
    SlitScene result = rooms_in_a_row(name, 2, is_seen);
    add_wall(result.scene, kRoom, width);
    return result;
}

SlitScene two_walls(const std::string& name, double width, double first_z, double second_z, bool is_seen)
{
    SlitScene result = rooms_in_a_row(name, 3, is_seen);
    add_wall(result.scene, kRoom, width, first_z);
    add_wall(result.scene, 2.0 * kRoom + kWall, width, second_z);
    return result;
}

/// The eye looks over the wall; the target stands on the height of the eye.
SlitScene half_high()
{
    SlitScene result = rooms_in_a_row("half-high wall, above it", 2, true);
    add_box(result.scene, {kRoom, kLow, kLow}, {kRoom + kWall, -1.0, kHigh});
    return result;
}

SlitScene one_sided(const std::string& name, bool from_behind)
{
    SlitScene result = rooms_in_a_row(name, 2, from_behind);
    Quad wall{{kRoom, kLow, kLow}, {kRoom, kLow, kHigh}, {kRoom, kHigh, kHigh}, {kRoom, kHigh, kLow}};
    if (from_behind) std::swap(wall.b, wall.d);
    add_object(result.scene, {wall});
    return result;
}

}  // namespace

std::vector<SlitScene> slit_scenes()
{
    std::vector<SlitScene> result;
    for (const double width : {1.0, 0.1, 0.01, 0.001}) {
        result.push_back(one_wall(fmt::format("slit {} m", width), width, true));
    }
    for (const double width : {1.0, 0.1, 0.01, 0.001}) {
        result.push_back(two_walls(fmt::format("two slits {} m in a row", width), width, 0.0, 0.0, true));
    }
    result.push_back(two_walls("two slits 0.01 m, 6 m aside", 0.01, -3.0, 3.0, false));
    result.push_back(one_wall("closed wall", 0.0, false));
    result.push_back(half_high());
    result.push_back(one_sided("one-sided wall, from behind", true));
    result.push_back(one_sided("one-sided wall, from its front", false));
    return result;
}

bool is_target_met(const SlitScene& slit)
{
    std::vector<MeshChunks> chunks;
    Scene scene = slit.scene;
    for (MeshData& mesh : scene.meshes) chunks.push_back(split_into_chunks(mesh));
    const std::vector<SightTriangle> triangles = sight_triangles(scene, chunks);
    Visibility numbering;
    number_slots(scene, chunks, numbering);
    const Box& box = scene.objects[slit.target].bounds_world;
    // Aside of the middle in height, where no edge between triangles is.
    const glm::dvec3 way = 0.5 * (box.min + box.max) + glm::dvec3(0.0, 0.125, 0.0) - slit.eye;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const bool is_of_target = triangles[i].slot >= numbering.first_slot_of_object[slit.target] &&
                                  triangles[i].slot < numbering.first_slot_of_object[slit.target + 1];
        if (is_of_target && is_seen_exactly(triangles, slit.eye, way, i)) return true;
    }
    return false;
}

bool reads_row(const SlitScene& slit, const Visibility& visibility)
{
    const int leaf = leaf_at(visibility.tree, slit.eye);
    return leaf >= 0 && !visibility.tree.is_solid[static_cast<std::size_t>(leaf)];
}

bool is_target_shown(const SlitScene& slit, const Visibility& visibility)
{
    std::vector<std::uint8_t> is_visible;
    visible_chunks(visibility, slit.eye, 0.0, is_visible);
    const auto first = is_visible.begin() + visibility.first_slot_of_object[slit.target];
    const auto last = is_visible.begin() + visibility.first_slot_of_object[slit.target + 1];
    return std::find(first, last, 1) != last;
}

}  // namespace hw::measure
