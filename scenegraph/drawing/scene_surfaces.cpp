#include "hatchway/drawing/scene_surfaces.hpp"

namespace hw {

std::vector<Surface> scene_surfaces(const Scene& scene, const SurfaceOptions& options)
{
    std::vector<SurfaceOptions> each(scene.meshes.size(), options);
    for (SurfaceOptions& mesh : each) mesh.is_solid = true;
    for (const Object& object : scene.objects) {
        const Material& material = scene.materials[object.material];
        if (material.alpha_mode != AlphaMode::opaque || material.is_double_sided) each[object.mesh].is_solid = false;
    }
    std::vector<Surface> surfaces;
    surfaces.reserve(scene.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) surfaces.push_back(build_surface(scene.meshes[i], each[i]));
    return surfaces;
}

}  // namespace hw
