#include "hatchway/world/open_backs.hpp"

#include <optional>

#include "hatchway/geometry/topology/shell.hpp"

namespace hw {

std::vector<bool> find_open_backs(const Scene& scene)
{
    std::vector<std::optional<bool>> is_shell_of_mesh(scene.meshes.size());
    std::vector<bool> open;
    for (const Object& object : scene.objects) {
        std::optional<bool>& known = is_shell_of_mesh[object.mesh];
        const bool is_double_sided = scene.materials[object.material].is_double_sided;
        if (is_double_sided && !known) known = is_shell(scene.meshes[object.mesh]);
        open.push_back(is_double_sided && !*known);
    }
    return open;
}

}  // namespace hw
