#include "hatchway/world/mirrors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/world/named_nodes.hpp"

namespace hw {
namespace {

constexpr double kFlatShare = 1e-4;     // of its extent, that a mirror may reach out of its plane
constexpr double kRoundedShare = 1e-6;  // of its distance from the origin: positions are floats

/// Three for each triangle that has an area, wound as it is drawn.
std::vector<glm::dvec3> corners_of(const Scene& scene, ObjectId id)
{
    const MeshData& mesh = scene.meshes[scene.objects[id].mesh];
    const glm::dmat4& matrix = scene.world_from_object(id);
    const bool is_mirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        glm::dvec3 at[3];
        for (int k = 0; k < 3; ++k)
            at[k] = glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
        if (glm::cross(at[1] - at[0], at[2] - at[0]) == glm::dvec3(0.0)) continue;
        if (is_mirrored) std::swap(at[1], at[2]);
        corners.insert(corners.end(), at, at + 3);
    }
    return corners;
}

glm::dvec3 area_vector(const std::vector<glm::dvec3>& corners, std::size_t triangle)
{
    const glm::dvec3* at = &corners[3 * triangle];
    return glm::cross(at[1] - at[0], at[2] - at[0]);
}

/// The plane of the largest triangle's normal, turned to where most of the area looks. `is_mixed`: some looks back.
MirrorPlane plane_of(const std::vector<glm::dvec3>& corners, bool& is_mixed)
{
    glm::dvec3 largest(0.0);
    for (std::size_t i = 0; i < corners.size() / 3; ++i) {
        const glm::dvec3 area = area_vector(corners, i);
        if (glm::dot(area, area) > glm::dot(largest, largest)) largest = area;
    }
    glm::dvec3 sum(0.0), facing(0.0);
    is_mixed = false;
    for (std::size_t i = 0; i < corners.size() / 3; ++i) {
        const glm::dvec3 area = area_vector(corners, i);
        const bool looks_back = glm::dot(area, largest) < 0.0;
        is_mixed |= looks_back;
        sum += looks_back ? -area : area;
        facing += area;
    }
    const glm::dvec3 normal = glm::normalize(glm::dot(facing, sum) < 0.0 ? -sum : sum);
    double low = INFINITY, high = -INFINITY;
    for (const glm::dvec3& corner : corners) {
        low = std::min(low, glm::dot(normal, corner));
        high = std::max(high, glm::dot(normal, corner));
    }
    return {normal, 0.5 * (low + high)};
}

/// The corners of the convex hull of places in a plane, counter-clockwise as the normal looks (Andrew 1979).
std::vector<glm::dvec3> hull_of(std::vector<glm::dvec3> places, const glm::dvec3& normal)
{
    const glm::dvec3 aside = std::abs(normal.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(aside, normal)), v = glm::cross(normal, u);
    const auto flat = [&](const glm::dvec3& place) { return glm::dvec2(glm::dot(u, place), glm::dot(v, place)); };
    std::ranges::sort(places, [&](const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec2 fa = flat(a), fb = flat(b);
        return fa.x != fb.x ? fa.x < fb.x : fa.y < fb.y;
    });
    const auto turns_left = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const glm::dvec2 ab = flat(b) - flat(a), ac = flat(c) - flat(a);
        return ab.x * ac.y - ab.y * ac.x > 0.0;
    };
    std::vector<glm::dvec3> hull;
    const auto add_side = [&](auto begin, auto end) {
        const std::size_t first = hull.size();
        for (auto place = begin; place != end; ++place) {
            while (hull.size() >= first + 2 && !turns_left(hull[hull.size() - 2], hull.back(), *place)) hull.pop_back();
            hull.push_back(*place);
        }
        hull.pop_back();  // the other side begins with it
    };
    add_side(places.begin(), places.end());
    add_side(places.rbegin(), places.rend());
    return hull;
}

/// None where the object has no faces.
std::optional<Mirror> mirror_of(const Scene& scene, ObjectId id, const MirrorRule& rule, const std::string& file)
{
    const std::vector<glm::dvec3> corners = corners_of(scene, id);
    if (corners.empty()) return {};
    bool is_mixed = false;
    Mirror mirror{.object = id,
                  .plane = plane_of(corners, is_mixed),
                  .reflectance = static_cast<float>(rule.reflectance),
                  .tint_linear = rule.tint_linear};
    Box bounds;
    double out_m = 0.0;
    for (const glm::dvec3& corner : corners) {
        bounds.add(corner);
        out_m = std::max(out_m, std::abs(mirror.plane.height(corner)));
    }
    const double allowed_m = kFlatShare * glm::length(bounds.size()) + kRoundedShare * glm::length(bounds.centre());
    if (!(out_m <= allowed_m))
        throw Error({.what = fmt::format("\"{}\" is not flat: it reaches {:.3g} m out of its plane",
                                         scene.nodes[scene.objects[id].node].path, out_m),
                     .file = file,
                     .pointer = rule.pointer + "/nodes",
                     .expected = "nodes that are flat, such as a pane"});
    mirror.is_two_sided = is_mixed || scene.materials[scene.objects[id].material].is_double_sided;
    mirror.outline_world = hull_of(corners, mirror.plane.normal_world);
    if (mirror.outline_world.size() < 3) return {};
    return mirror;
}

}  // namespace

double MirrorPlane::height(const glm::dvec3& place_world) const
{
    return glm::dot(normal_world, place_world) - offset_m;
}

glm::dvec3 MirrorPlane::reflected(const glm::dvec3& place_world) const
{
    return place_world - 2.0 * height(place_world) * normal_world;
}

std::vector<Mirror> find_mirrors(const Level& level, const Scene& scene)
{
    std::vector<const MirrorRule*> rule_of(scene.objects.size(), nullptr);
    Budget budget;
    for (const MirrorRule& rule : level.mirrors) {
        std::vector<char> marks(scene.nodes.size(), 0);
        mark_named_nodes(scene, {rule.nodes, level.file.string(), rule.pointer + "/nodes"}, budget, marks);
        for (ObjectId id = 0; id < scene.objects.size(); ++id)
            if (marks[scene.objects[id].node]) rule_of[id] = &rule;
    }
    std::vector<Mirror> mirrors;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        if (rule_of[id] == nullptr) continue;
        std::optional<Mirror> mirror = mirror_of(scene, id, *rule_of[id], level.file.string());
        if (mirror) mirrors.push_back(std::move(*mirror));
    }
    return mirrors;
}

}  // namespace hw
