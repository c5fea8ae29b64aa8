#include "hatchway/scene_surfaces.hpp"

namespace hw {

std::vector<Surface> scene_surfaces(const Scene& scene)
{
    std::vector<SurfaceOptions> options(scene.meshes.size());
    for (const Object& object : scene.objects) {
        const Material& material = scene.materials[object.material];
        if (material.alpha_mode != AlphaMode::opaque || material.is_double_sided) options[object.mesh].is_solid = false;
    }
    std::vector<Surface> surfaces;
    surfaces.reserve(scene.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
        surfaces.push_back(build_surface(scene.meshes[i], options[i]));
    return surfaces;
}

}  // namespace hw
