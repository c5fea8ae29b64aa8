#include "hatchway/world/collision/collision.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "hatchway/world/collision/segment_distance.hpp"

namespace hw {
namespace {

constexpr std::uint32_t kTrianglesPerLeaf = 4;
constexpr int kMostAdvances = 200;
constexpr double kTouch = 1e-7;  // metres of gap at which an advance counts as arrived

using Triangle = CollisionWorld::Triangle;

Box bounds_of(const Triangle& triangle)
{
    Box box;
    box.add(triangle.a);
    box.add(triangle.b);
    box.add(triangle.c);
    return box;
}

void add_object(const Scene& scene, ObjectId id, std::vector<Triangle>& triangles)
{
    const MeshData& mesh = scene.meshes[static_cast<std::size_t>(scene.objects[id].mesh)];
    const glm::dmat4& matrix = scene.world_from_object(id);
    const auto world = [&](std::uint32_t index) {
        return glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[index]), 1.0));
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Triangle triangle{world(mesh.indices[i]), world(mesh.indices[i + 1]), world(mesh.indices[i + 2]), id};
        const double doubled_area = glm::length(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
        if (doubled_area > 0.0 && std::isfinite(doubled_area)) triangles.push_back(triangle);
    }
}

/// Builds the subtree of [first, last) and returns nothing: the first child follows its parent.
void build_nodes(CollisionWorld& world, std::uint32_t first, std::uint32_t last)
{
    const std::size_t index = world.nodes.size();
    world.nodes.emplace_back();
    Box bounds;
    Box centres;
    for (std::uint32_t i = first; i < last; ++i) {
        const Box box = bounds_of(world.triangles[i]);
        bounds.add(box);
        centres.add(box.centre());
    }
    world.nodes[index].bounds = bounds;
    if (last - first <= kTrianglesPerLeaf) {
        world.nodes[index].first = first;
        world.nodes[index].count = last - first;
        return;
    }
    const glm::dvec3 size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    const auto begin = world.triangles.begin();
    // A stable sort: equal centres must not depend on the library.
    std::stable_sort(begin + first, begin + last, [axis](const Triangle& a, const Triangle& b) {
        return bounds_of(a).centre()[axis] < bounds_of(b).centre()[axis];
    });
    build_nodes(world, first, middle);
    world.nodes[index].first = static_cast<std::uint32_t>(world.nodes.size());
    build_nodes(world, middle, last);
}

template <typename Visit>
void visit_triangles(const CollisionWorld& world, const Box& box, Visit visit)
{
    if (world.nodes.empty()) return;
    std::vector<std::uint32_t> pending{0};
    while (!pending.empty()) {
        const std::uint32_t index = pending.back();
        pending.pop_back();
        const CollisionWorld::BvhNode& node = world.nodes[index];
        if (!node.bounds.overlaps(box)) continue;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const Triangle& triangle = world.triangles[node.first + i];
            if (bounds_of(triangle).overlaps(box)) visit(triangle);
        }
        if (node.count > 0) continue;
        pending.push_back(node.first);
        pending.push_back(index + 1);
    }
}

Segment3 axis_of(const glm::dvec3& foot, const Capsule& capsule)
{
    const double low = capsule.radius_m;
    const double high = std::max(capsule.height_m - capsule.radius_m, low);
    return {foot + glm::dvec3(0.0, low, 0.0), foot + glm::dvec3(0.0, high, 0.0)};
}

Box box_of(const glm::dvec3& foot, const Capsule& capsule, double margin)
{
    const double reach = capsule.radius_m + margin;
    Box box;
    box.add(foot + glm::dvec3(-reach, -margin, -reach));
    box.add(foot + glm::dvec3(reach, std::max(capsule.height_m, 2.0 * capsule.radius_m) + margin, reach));
    return box;
}

struct Contact {
    double gap = 0.0;  ///< Between the capsule's skin and the triangle; negative when they overlap.
    glm::dvec3 normal{0.0};
    glm::dvec3 point{0.0};
};

Contact contact_at(const Triangle& triangle, const glm::dvec3& foot, const Capsule& capsule)
{
    const Segment3 axis = axis_of(foot, capsule);
    const NearestPoints nearest = nearest_points(axis, {triangle.a, triangle.b, triangle.c});
    const glm::dvec3 apart = nearest.on_segment - nearest.on_triangle;
    const double distance = glm::length(apart);
    Contact contact{distance - capsule.radius_m, {}, nearest.on_triangle};
    if (distance > 1e-9) {
        contact.normal = apart / distance;
        return contact;
    }
    // The axis pierces the triangle: the way out is through the side on which most of the capsule is.
    const glm::dvec3 face = glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
    const double side = glm::dot(0.5 * (axis.a + axis.b) - triangle.a, face);
    contact.normal = side >= 0.0 ? face : -face;
    return contact;
}

/// A capsule on its way, and the distance that it keeps.
struct Sweep {
    glm::dvec3 from{0.0};
    glm::dvec3 way{0.0};
    Capsule capsule;
    double skin = kCollisionSkin;
};

/// Shortens `hit` if the triangle stops the capsule earlier.
void sweep_against(const Triangle& triangle, const Sweep& sweep, SweepHit& hit)
{
    const auto& [from, way, capsule, skin] = sweep;
    // A way along a wall must not stop for the last bit of the wall's normal.
    const double noise = 1e-8 * glm::length(way);
    double fraction = 0.0;
    for (int step = 0; step < kMostAdvances; ++step) {
        const Contact contact = contact_at(triangle, from + fraction * way, capsule);
        const double approach = -glm::dot(way, contact.normal);  // metres of gap lost over the whole way
        if (approach <= noise) return;  // a plane between two convex bodies that do not come nearer
        const double gap = contact.gap - skin;
        if (gap <= kTouch || step + 1 == kMostAdvances) {
            if (hit.is_hit && fraction >= hit.fraction) return;
            hit = {true, fraction, from + fraction * way, contact.normal, contact.point, triangle.object};
            return;
        }
        fraction += gap / approach;
        if (fraction >= hit.fraction) return;
    }
}

}  // namespace

CollisionWorld build_collision_world(const Scene& scene, std::span<const ObjectLook> looks)
{
    CollisionWorld world;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        if (!looks.empty() && !looks[id].collides) continue;
        if (scene.nodes[static_cast<std::size_t>(scene.objects[id].node)].is_animated) continue;
        add_object(scene, id, world.triangles);
    }
    if (!world.triangles.empty()) build_nodes(world, 0, static_cast<std::uint32_t>(world.triangles.size()));
    return world;
}

SweepHit sweep_capsule(const CollisionWorld& world, const glm::dvec3& from_world, const glm::dvec3& to_world,
                       const Capsule& capsule)
{
    const glm::dvec3 way = to_world - from_world;
    SweepHit hit;
    hit.foot_world = to_world;
    Box swept = box_of(from_world, capsule, 2.0 * kCollisionSkin);
    swept.add(box_of(to_world, capsule, 2.0 * kCollisionSkin));
    // Who starts nearer to a wall than the skin keeps that distance: else the seams of the wall would stop him.
    Sweep sweep{from_world, way, capsule};
    visit_triangles(world, box_of(from_world, capsule, kCollisionSkin), [&](const Triangle& triangle) {
        sweep.skin = std::min(sweep.skin, std::max(0.0, contact_at(triangle, from_world, capsule).gap - kTouch));
    });
    visit_triangles(world, swept, [&](const Triangle& triangle) { sweep_against(triangle, sweep, hit); });
    return hit;
}

bool overlaps(const CollisionWorld& world, const glm::dvec3& foot_world, const Capsule& capsule)
{
    bool result = false;
    visit_triangles(world, box_of(foot_world, capsule, kCollisionSkin), [&](const Triangle& triangle) {
        result = result || contact_at(triangle, foot_world, capsule).gap < 0.5 * kCollisionSkin;
    });
    return result;
}

std::optional<glm::dvec3> push_out(const CollisionWorld& world, const glm::dvec3& foot_world, const Capsule& capsule,
                                   double reach_m)
{
    constexpr int kMostPushes = 64;
    glm::dvec3 foot = foot_world;
    for (int push = 0; push < kMostPushes; ++push) {
        Contact deepest;
        deepest.gap = 0.5 * kCollisionSkin;
        bool is_free = true;
        visit_triangles(world, box_of(foot, capsule, kCollisionSkin), [&](const Triangle& triangle) {
            const Contact contact = contact_at(triangle, foot, capsule);
            if (contact.gap >= deepest.gap) return;
            deepest = contact;
            is_free = false;
        });
        if (is_free) return foot;
        foot += deepest.normal * (kCollisionSkin - deepest.gap);
        if (glm::length(foot - foot_world) > reach_m) return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace hw
