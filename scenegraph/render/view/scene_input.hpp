#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hatchway/drawing/styled_object.hpp"
#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/maps/map_levels.hpp"
#include "hatchway/world/mirrors.hpp"

namespace hw {

struct Lightmap;    // world/light/lightmap.hpp
struct Visibility;  // world/visibility/visibility.hpp

/// Makes, sets and prepares the image pass that a key names; null when there is none of that name.
using ImagePassSource = std::function<std::unique_ptr<ImagePass>(const ImageKey&)>;

/// Maps by kind and name: indices into SceneInput::maps.
using NamedMaps = std::map<std::pair<MapKind, std::string>, int>;

/// Everything a level shows. Pointers stay the caller's and must live until the next load().
struct SceneInput {
    const Scene* scene = nullptr;
    std::vector<NamedStyle> styles;
    std::vector<StyledObject> objects;       ///< One for each of scene->objects.
    const Visibility* visibility = nullptr;  ///< Null: everything is visible.
    std::span<const MeshChunks> chunks;      ///< One for each mesh; empty: meshes are drawn whole.
    const Lightmap* lightmap = nullptr;      ///< Baked light; its stream has been added to the scene's meshes.
    std::vector<const MapLevels*> maps;      ///< What StyledObject::maps points at.
    NamedMaps named_maps;                    ///< What Needs::maps name.
    std::vector<Light> lights;
    float exposure_ev = 0.0f;  ///< EV 100; the picture is scaled by 1 / (1.2 * 2^EV).
    glm::vec3 background_srgb{1.0f};
    ImagePassSource image_passes;
    std::vector<Mirror> mirrors;
    int mirror_depth = 2;  ///< How many mirrors a line of sight is followed through.
};

}  // namespace hw
