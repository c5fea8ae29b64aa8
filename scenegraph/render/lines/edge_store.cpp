#include "hatchway/render/lines/edge_store.hpp"

#include <algorithm>

#include "hatchway/core/progress.hpp"

namespace hw {

EdgeStore::EdgeStore(const Scene& scene, LineIndices& indices)
    : scene_(scene), indices_(indices), surfaces_(scene), objects_(scene.objects.size())
{
}

void EdgeStore::prepare(std::span<const EdgeDemand> demands)
{
    std::vector<ObjectMeshes> objects(scene_.objects.size());
    const auto wanted = static_cast<std::uint64_t>(
        std::count_if(demands.begin(), demands.end(), [](const EdgeDemand& demand) { return demand.is_any(); }));
    if (wanted > 0) {
        Progress progress("Finding edges", wanted);
        for (ObjectId object = 0; object < demands.size(); ++object) {
            if (!demands[object].is_any()) continue;
            surfaces_.of(object);
            progress.advance();
        }
        const LineExtras extras = find_line_extras(scene_, demands, surfaces_);
        for (ObjectId object = 0; object < demands.size(); ++object)
            if (demands[object].is_any()) objects[object] = meshes_of(object, demands[object], extras.objects[object]);
    }
    objects_ = std::move(objects);
}

EdgeStore::ObjectMeshes EdgeStore::meshes_of(ObjectId object, const EdgeDemand& demand, const ObjectExtras& extras)
{
    ObjectMeshes meshes{.surface = &surfaces_.of(object), .lines = {}, .own = {}};
    for (const float crease_rad : demand.crease_rad) {
        const ObjectEdges edges{*meshes.surface, crease_rad, extras, surfaces_.is_culled(object)};
        if (extras.is_empty()) {
            meshes.lines.emplace_back(crease_rad, shared_mesh(object, edges));
            continue;
        }
        meshes.own.push_back(std::make_unique<LineMesh>(build_line_mesh(edges, indices_)));
        meshes.lines.emplace_back(crease_rad, meshes.own.back().get());
        ++line_meshes_built_;
    }
    return meshes;
}

const LineMesh* EdgeStore::shared_mesh(ObjectId object, const ObjectEdges& edges)
{
    const Key key{surfaces_.key_of(object), edges.is_culled, edges.crease_rad};
    const auto found = shared_lines_.find(key);
    if (found != shared_lines_.end()) return &found->second;
    ++line_meshes_built_;
    return &(shared_lines_[key] = build_line_mesh(edges, indices_));
}

const LineMesh* EdgeStore::lines(ObjectId object, float crease_rad) const
{
    for (const auto& [own_rad, lines] : objects_[object].lines)
        if (own_rad == crease_rad) return lines;
    return nullptr;
}

}  // namespace hw
