#include "hatchway/drawing/line_extras.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>

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
                           .with_intersections = demands[id].has_intersections});
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
        extras.objects[ids[owner]].intersections.push_back({{place(0), place(1)}, i});
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
