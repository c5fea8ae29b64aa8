#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/light/lightmap.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/scene_places.hpp"

namespace hw {

/// The model of a level: what a level's looks do not change. No device is needed up to here.
struct LevelWorld {
    Scene scene;
    ScenePlaces places;                ///< Of the scene as it is.
    std::vector<MeshChunks> chunks;    ///< One for each mesh of the scene.
    std::uint64_t geometry_key = 0;    ///< What compiled visibility is known by, beside what is hidden.
    std::optional<Lightmap> lightmap;  ///< The level's baked light, its stream added to the meshes.
    std::vector<ObjectId> hidden;      ///< What the level hid when the world was opened: the lightmap is for that.
};

/// The style of an object for which nobody named one.
inline constexpr const char* kFallbackStyle = "photoreal";

/// Reads a level file or a bare model. `style_overrides` are "GLOB=STYLE", put after the level's own rules.
/// Throws hw::Error for an override that is not of that form, and whatever read_level() throws.
Level read_level_with(const std::filesystem::path& file, const std::vector<std::string>& style_overrides);

enum class BakedLight : unsigned char { unwanted, if_there };

/// The level's model without what the level's rules hide; its doubts tell of strays. Throws what import_model() and
/// resolve_looks() throw, and hw::Error where a name of Level::structure reaches no node.
Scene open_scene(const Level& level);

/// Takes open_scene(), cuts its meshes into chunks, and takes the lightmap beside the level when it is wanted.
/// One that was baked for another state of the level is left out, with a warning. The renderer points into the result,
/// so it never moves.
std::shared_ptr<LevelWorld> open_world(const Level& level, BakedLight baked_light = BakedLight::unwanted);

/// Whether the model and its visibility stay as they are when `before` becomes `after`.
bool same_world(const Level& before, const Level& after);

/// The lights of the model and of the level. A level without any gets a sun from above, behind the left shoulder of
/// somebody who looks along -z.
std::vector<Light> lights_of(const Level& level, const Scene& scene);

/// Level::exposure_ev, else the EV 100 that shows a white surface in the scene's typical light a little below white.
double exposure_ev_of(const Level& level, const Scene& scene, const std::vector<Light>& lights);

}  // namespace hw
