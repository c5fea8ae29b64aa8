#include "hatchway/render/repeats.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

namespace hw {
namespace {

struct Copy {
    int mesh, material;
    std::array<unsigned char, sizeof(glm::dmat4)> transform;  // bits: a NaN would have no order
    auto operator<=>(const Copy&) const = default;
};

Copy copy_of(const Scene& scene, ObjectId id)
{
    Copy copy{scene.objects[id].mesh, scene.objects[id].material, {}};
    std::memcpy(copy.transform.data(), &scene.world_from_object(id), copy.transform.size());
    return copy;
}

}  // namespace

std::vector<std::uint8_t> find_repeats(const Scene& scene, std::span<const StyledObject> looks)
{
    std::vector<std::uint8_t> repeats(looks.size(), 0);
    std::map<Copy, std::vector<StyledObject>> later;
    for (ObjectId id = static_cast<ObjectId>(looks.size()); id-- > 0;) {
        if (scene.materials[scene.objects[id].material].alpha_mode == AlphaMode::blend) continue;
        std::vector<StyledObject>& others = later[copy_of(scene, id)];
        repeats[id] = std::find(others.begin(), others.end(), looks[id]) != others.end() ? 1 : 0;
        if (repeats[id] == 0) others.push_back(looks[id]);
    }
    return repeats;
}

}  // namespace hw
