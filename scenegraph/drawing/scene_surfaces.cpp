#include "hatchway/drawing/scene_surfaces.hpp"

namespace hw {

bool SceneSurfaces::is_culled(ObjectId object) const
{
    return !material(object).is_double_sided;
}

SceneSurfaces::Key SceneSurfaces::key_of(ObjectId object) const
{
    return {scene_.objects[object].mesh, material(object).alpha_mode == AlphaMode::opaque && is_culled(object)};
}

const Surface& SceneSurfaces::of(ObjectId object)
{
    const Key key = key_of(object);
    const auto found = surfaces_.find(key);
    if (found != surfaces_.end()) return found->second;
    SurfaceOptions options = options_;
    options.is_solid = key.is_solid;
    return surfaces_[key] = build_surface(scene_.meshes[key.mesh], options);
}

}  // namespace hw
