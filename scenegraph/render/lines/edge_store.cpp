#include "hatchway/render/lines/edge_store.hpp"

#include <algorithm>
#include <utility>

#include "hatchway/core/progress.hpp"
#include "hatchway/geometry/lines/intersections.hpp"

namespace hw {

EdgeStore::EdgeStore(const Scene& scene, LineIndices& indices)
    : scene_(scene), indices_(indices), objects_(scene.objects.size())
{
}

EdgeStore::MeshKey EdgeStore::key_of(ObjectId object) const
{
    const Material& material = scene_.materials[scene_.objects[object].material];
    return {scene_.objects[object].mesh, material.alpha_mode == AlphaMode::opaque && !material.is_double_sided};
}

const Surface& EdgeStore::surface_of(const MeshKey& key)
{
    const auto found = surfaces_.find(key);
    if (found != surfaces_.end()) return found->second;
    ++surfaces_built_;
    return surfaces_[key] = build_surface(scene_.meshes[key.mesh], {.is_solid = key.is_solid});
}

void EdgeStore::prepare(std::span<const EdgeUse> uses)
{
    std::vector<ObjectEdges> before = std::exchange(objects_, std::vector<ObjectEdges>(scene_.objects.size()));
    try {
        find_edges(uses);
    } catch (...) {
        objects_ = std::move(before);
        throw;
    }
}

void EdgeStore::find_edges(std::span<const EdgeUse> uses)
{
    const auto used = static_cast<std::uint64_t>(
        std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.is_used; }));
    if (used == 0) return;
    Progress progress("Finding edges", used);
    for (ObjectId object = 0; object < uses.size(); ++object) {
        if (!uses[object].is_used) continue;
        objects_[object].surface = &surface_of(key_of(object));
        progress.advance();
    }
    find_lines(uses);
}

void EdgeStore::find_lines(std::span<const EdgeUse> uses)
{
    std::vector<SeamObject> together;
    std::vector<ObjectId> ids;
    float crease_rad = 3.2f;
    for (ObjectId object = 0; object < uses.size(); ++object) {
        if (!uses[object].is_used) continue;
        together.push_back({objects_[object].surface, scene_.world_from_object(object), uses[object].style});
        ids.push_back(object);
        crease_rad = std::min(crease_rad, uses[object].crease_rad);
    }
    const std::vector<Seams> seams = find_seams(together, {.crease_rad = crease_rad});
    const Intersections intersections = find_object_intersections(uses, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) assign_lines(ids[i], uses[ids[i]], {&seams[i], intersections[i]});
}

EdgeStore::Intersections EdgeStore::find_object_intersections(std::span<const EdgeUse> uses,
                                                              std::span<const ObjectId> ids) const
{
    Intersections found(ids.size());
    std::vector<LineObject> line_objects;
    for (const ObjectId id : ids)
        line_objects.push_back({.surface = objects_[id].surface,
                                .world_from_object = scene_.world_from_object(id),
                                .with_intersections = uses[id].with_intersections});
    if (std::none_of(line_objects.begin(), line_objects.end(), shows_intersections)) return found;
    std::map<std::uint32_t, glm::vec3> places;  // one for each joint, so that pieces run on into each other
    for (const IntersectionLine& line : find_intersections(line_objects)) {
        const std::uint32_t owner = line.objects[shows_intersections(line_objects[line.objects[0]]) ? 0 : 1];
        const glm::dmat4 object_from_world = glm::inverse(line_objects[owner].world_from_object);
        const auto place = [&](int end) {
            const glm::vec3 p(glm::dvec3(object_from_world * glm::dvec4(line.ends_world[end], 1.0)));
            return places.try_emplace(line.joints[end], p).first->second;
        };
        found[owner].push_back({place(0), place(1)});
    }
    return found;
}

void EdgeStore::assign_lines(ObjectId object, const EdgeUse& use, const LineExtras& extras)
{
    ObjectEdges& edges = objects_[object];
    if (!extras.is_empty()) {
        edges.own_lines = std::make_unique<LineMesh>(
            build_line_mesh(*edges.surface, use.crease_rad, extras, key_of(object).is_solid, indices_));
        edges.lines = edges.own_lines.get();
        ++line_meshes_built_;
        return;
    }
    const LineKey key{key_of(object), use.crease_rad};
    const auto found = shared_lines_.find(key);
    if (found != shared_lines_.end()) {
        edges.lines = &found->second;
        return;
    }
    ++line_meshes_built_;
    edges.lines =
        &(shared_lines_[key] = build_line_mesh(*edges.surface, use.crease_rad, {}, key_of(object).is_solid, indices_));
}

const Surface* EdgeStore::surface(ObjectId object) const
{
    return objects_[object].surface;
}

const LineMesh* EdgeStore::lines(ObjectId object) const
{
    return objects_[object].lines;
}

}  // namespace hw
