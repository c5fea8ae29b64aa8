#include "hatchway/world/scene.hpp"

namespace hw {

std::uint64_t drawn_triangle_count(const Scene& scene)
{
    std::uint64_t count = 0;
    for (const Object& object : scene.objects) count += scene.meshes[object.mesh].triangle_count();
    return count;
}

}  // namespace hw
