#include "hatchway/drawing/line_extras.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "hatchway/geometry/surface/surface_faces.hpp"

namespace hw {
namespace {

constexpr float kNoCreases = 3.2f;

void find_object_seams(const Scene& scene, std::span<const EdgeDemand> demands, SceneSurfaces& surfaces,
                       std::vector<ObjectExtras>& objects)
{
    std::vector<SeamObject> together;
    std::vector<ObjectId> ids;
    float crease_rad = kNoCreases;
    for (ObjectId id = 0; id < demands.size(); ++id) {
        if (!demands[id].is_any()) continue;
        together.push_back({.surface = &surfaces.of(id),
                            .world_from_object = scene.world_from_object(id),
                            .style = demands[id].style_group,
                            .is_double_sided = !surfaces.is_culled(id)});
        ids.push_back(id);
        crease_rad = std::min(crease_rad, demands[id].crease_rad.front());
    }
    SeamOptions options{.crease_rad = crease_rad};
    // What is a tenth of a millimetre of a room is a letter's relief on a chip.
    options.tolerance_m =
        std::min(options.tolerance_m, static_cast<float>(kContactShare * glm::length(scene.bounds_world.size())));
    std::vector<Seams> seams = find_seams(together, options);
    for (std::size_t i = 0; i < ids.size(); ++i) objects[ids[i]].seams = std::move(seams[i]);
}

/// Objects that show intersections, and those that may go through one of them.
std::vector<ObjectId> objects_that_may_meet(const Scene& scene, std::span<const EdgeDemand> demands)
{
    std::vector<ObjectId> ids;
    for (ObjectId id = 0; id < demands.size(); ++id) {
        const Box& own = scene.objects[id].bounds_world;
        const auto meets = [&](ObjectId other) {
            return demands[other].has_intersections && own.overlaps(scene.objects[other].bounds_world);
        };
        bool may_meet = demands[id].has_intersections;
        for (ObjectId other = 0; other < demands.size() && !may_meet; ++other) may_meet = meets(other);
        if (may_meet) ids.push_back(id);
    }
    return ids;
}

/// Where a face of another object looks, in the owner's space: on its front a point gives a positive number there, too.
glm::vec3 front_normal(const LineObject& other, std::uint32_t face, const LineObject& owner)
{
    const std::uint32_t plane = plane_face(*other.surface, face);
    if (plane == kNoFace) return glm::vec3(0.0f);
    const auto& [a, b, c] = other.surface->faces[plane];
    const std::vector<glm::vec3>& places = other.surface->positions;
    const glm::dvec3 p(places[a]);
    const glm::dvec3 area = glm::cross(glm::dvec3(places[b]) - p, glm::dvec3(places[c]) - p);
    const glm::dvec3 normal =
        area * glm::dmat3(glm::inverse(other.world_from_object)) * glm::dmat3(owner.world_from_object);
    const double size = glm::length(normal);
    return size > 0.0 ? glm::vec3(normal / size) : glm::vec3(0.0f);
}

std::array<glm::vec3, 2> culled_normals(const IntersectionLine& line, std::span<const LineObject> objects)
{
    std::array<glm::vec3, 2> normals{};
    for (std::size_t side = 0; side < 2; ++side) {
        const LineObject& object = objects[line.objects[side]];
        if (object.is_culled && !object.surface->is_two_sided(line.faces[side]))
            normals[side] = front_normal(object, line.faces[side], objects[owner_of(line, objects)]);
    }
    return normals;
}

}  // namespace

LineExtras find_intersection_extras(const Scene& scene, std::span<const EdgeDemand> demands, SceneSurfaces& surfaces)
{
    LineExtras extras{.objects = std::vector<ObjectExtras>(demands.size()), .intersections = {}};
    const auto shows = [](const EdgeDemand& demand) { return demand.has_intersections; };
    if (std::none_of(demands.begin(), demands.end(), shows)) return extras;
    const std::vector<ObjectId> ids = objects_that_may_meet(scene, demands);
    std::vector<LineObject> objects;
    for (const ObjectId id : ids)
        objects.push_back({.surface = &surfaces.of(id),
                           .world_from_object = scene.world_from_object(id),
                           .is_drawn = demands[id].is_any(),
                           .with_intersections = demands[id].has_intersections,
                           .is_culled = surfaces.is_culled(id)});
    extras.intersections = find_intersections(objects);
    std::map<std::uint32_t, glm::vec3> places;  // one for each joint, so that pieces run on into each other
    for (std::uint32_t i = 0; i < extras.intersections.size(); ++i) {
        IntersectionLine& line = extras.intersections[i];
        const std::uint32_t owner = owner_of(line, objects);
        const glm::dmat4 object_from_world = glm::inverse(objects[owner].world_from_object);
        const auto place = [&](int end) {
            const glm::vec3 p(glm::dvec3(object_from_world * glm::dvec4(line.ends_world[end], 1.0)));
            return places.try_emplace(line.joints[end], p).first->second;
        };
        extras.objects[ids[owner]].intersections.push_back({{place(0), place(1)}, i, culled_normals(line, objects)});
        for (std::uint32_t& object : line.objects) object = ids[object];
    }
    return extras;
}

LineExtras find_line_extras(const Scene& scene, std::span<const EdgeDemand> demands, SceneSurfaces& surfaces)
{
    LineExtras extras = find_intersection_extras(scene, demands, surfaces);
    find_object_seams(scene, demands, surfaces, extras.objects);
    return extras;
}

}  // namespace hw
