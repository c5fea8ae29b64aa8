#include "hatchway/walk/pick.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace hw {
namespace {

using Triangle = CollisionWorld::Triangle;

struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;
    glm::dvec3 inverse;  ///< 1 / direction; infinite where that is 0.
};

bool meets(const Ray& ray, const Box& box, double nearest)
{
    double enter = 0.0, leave = nearest;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        const double b = (box.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        // A ray within a side's plane gives 0 * infinity: such a pair limits nothing.
        if (std::isnan(a) || std::isnan(b)) continue;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

/// Distance along the ray; `is_front` tells from which side, by the winding.
std::optional<double> distance_to(const Ray& ray, const Triangle& triangle, bool& is_front)
{
    const glm::dvec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const glm::dvec3 across = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, across);
    if (determinant == 0.0) return std::nullopt;
    const glm::dvec3 from_a = ray.origin - triangle.a;
    const double u = glm::dot(from_a, across) / determinant;
    const glm::dvec3 along = glm::cross(from_a, ab);
    const double v = glm::dot(ray.direction, along) / determinant;
    const double distance = glm::dot(ac, along) / determinant;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0)) return std::nullopt;
    is_front = determinant > 0.0;
    return distance;
}

void look_at(const PickWorld& world, const Ray& ray, const Triangle& triangle, std::optional<PickHit>& hit)
{
    bool is_front = false;
    const auto distance = distance_to(ray, triangle, is_front);
    if (!distance || (hit && *distance >= hit->distance_m)) return;
    const Material& material = world.scene->materials[world.scene->objects[triangle.object].material];
    if (!material.is_double_sided && is_front == (world.is_mirrored[triangle.object] != 0)) return;
    hit = PickHit{triangle.object, *distance};
}

void add_moving(const Scene& scene, ObjectId id, std::vector<Triangle>& triangles)
{
    const MeshData& mesh = scene.meshes[scene.objects[id].mesh];
    const auto corner = [&](std::size_t i) {
        return glm::dvec3(scene.world_from_object(id) * glm::dvec4(mesh.positions[mesh.indices[i]], 1.0));
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        triangles.push_back({corner(i), corner(i + 1), corner(i + 2), id});
}

}  // namespace

PickWorld build_pick_world(const Scene& scene)
{
    PickWorld world{.scene = &scene, .still = build_collision_world(scene, {})};
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        world.is_mirrored.push_back(glm::determinant(glm::dmat3(scene.world_from_object(id))) < 0.0);
        if (scene.nodes[scene.objects[id].node].is_animated) add_moving(scene, id, world.moving);
    }
    return world;
}

std::optional<PickHit> pick(const PickWorld& world, const glm::dvec3& eye_world, const glm::dvec3& direction)
{
    const Ray ray{eye_world, direction, 1.0 / direction};
    std::optional<PickHit> hit;
    for (const Triangle& triangle : world.moving) look_at(world, ray, triangle, hit);
    std::vector<std::uint32_t> pending;
    if (!world.still.nodes.empty()) pending.push_back(0);
    while (!pending.empty()) {
        const std::uint32_t index = pending.back();
        pending.pop_back();
        const CollisionWorld::BvhNode& node = world.still.nodes[index];
        if (!meets(ray, node.bounds, hit ? hit->distance_m : std::numeric_limits<double>::infinity())) continue;
        for (std::uint32_t i = 0; i < node.count; ++i) look_at(world, ray, world.still.triangles[node.first + i], hit);
        if (node.count > 0) continue;
        pending.push_back(node.first);
        pending.push_back(index + 1);
    }
    return hit;
}

}  // namespace hw
