#include "hatchway/drawing/scene_surfaces.hpp"

#include <tbb/parallel_for.h>

#include <map>
#include <vector>

#include "hatchway/core/progress.hpp"

namespace hw {

bool SceneSurfaces::is_culled(ObjectId object) const
{
    return !material(object).is_double_sided;
}

SceneSurfaces::Key SceneSurfaces::key_of(ObjectId object) const
{
    return {scene_.objects[object].mesh, material(object).alpha_mode == AlphaMode::opaque && is_culled(object),
            angle_change(glm::dmat3(scene_.world_from_object(object)))};
}

Surface SceneSurfaces::made(const Key& key, ObjectId object) const
{
    SurfaceOptions options = options_;
    options.is_solid = key.is_solid;
    options.world_from_object = glm::dmat3(scene_.world_from_object(object));
    return build_surface(scene_.meshes[key.mesh], options);
}

const Surface& SceneSurfaces::of(ObjectId object)
{
    const Key key = key_of(object);
    const auto found = surfaces_.find(key);
    return found != surfaces_.end() ? found->second : surfaces_[key] = made(key, object);
}

void SceneSurfaces::build(std::span<const ObjectId> objects)
{
    std::map<Key, ObjectId> missing;
    for (const ObjectId object : objects)
        if (find(object) == nullptr) missing.try_emplace(key_of(object), object);
    if (missing.empty()) return;
    const std::vector<std::pair<Key, ObjectId>> keys(missing.begin(), missing.end());
    std::vector<Surface> made_for(keys.size());
    Progress progress("Finding edges", keys.size());
    tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
        made_for[i] = made(keys[i].first, keys[i].second);
        progress.advance();
    });
    for (std::size_t i = 0; i < keys.size(); ++i) surfaces_[keys[i].first] = std::move(made_for[i]);
}

const Surface* SceneSurfaces::find(ObjectId object) const
{
    const auto found = surfaces_.find(key_of(object));
    return found != surfaces_.end() ? &found->second : nullptr;
}

}  // namespace hw
