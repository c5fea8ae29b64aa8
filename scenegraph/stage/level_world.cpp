#include "hatchway/stage/level_world.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/compiled/key.hpp"
#include "hatchway/io/compiled/lightmap_file.hpp"
#include "hatchway/io/level/file.hpp"
#include "hatchway/io/model/import.hpp"
#include "hatchway/stage/level_light.hpp"
#include "hatchway/world/hidden_objects.hpp"
#include "hatchway/world/light/bake.hpp"
#include "hatchway/world/looks.hpp"
#include "hatchway/world/mirrors.hpp"
#include "hatchway/world/visibility/tree/structure.hpp"

namespace hw {
namespace {

constexpr float kSunLux = 50000.0f;
constexpr double kWhiteShare = 0.8;      // of white, that a white surface in typical light shows
constexpr double kLeastDistanceM = 0.5;  // a lamp's own holder must not decide the exposure

AssignRule override_rule(const std::string& text, std::size_t number, const std::filesystem::path& file)
{
    const std::string pointer = "--style " + std::to_string(number);
    const std::size_t sign = text.rfind('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
        throw Error({.what = "\"" + text + "\" says no style",
                     .file = file.string(),
                     .pointer = pointer,
                     .expected = "GLOB=STYLE, such as '*=pen_and_ink'"});
    AssignRule rule;
    rule.nodes = text.substr(0, sign);
    rule.style = text.substr(sign + 1);
    rule.pointer = pointer;
    return rule;
}

/// Lux that a surface at `place_world` facing the light receives.
double illuminance_at(const Light& light, const glm::dvec3& place_world)
{
    if (light.type == LightType::sun) return light.intensity;
    const double distance = std::max(glm::distance(place_world, light.position_world), kLeastDistanceM);
    if (light.range_m > 0.0f && distance > light.range_m) return 0.0;
    if (light.type == LightType::spot) {
        const double cosine = glm::dot(glm::normalize(place_world - light.position_world), light.direction_world);
        if (!(cosine > std::cos(light.outer_cone_rad))) return 0.0;
    }
    return light.intensity / (distance * distance);
}

double luminance_weight(const glm::vec3& colour)
{
    return 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
}

void add_baked_light(const Level& level, LevelWorld& world)
{
    world.lightmap = find_lightmap(level.file, world.scene);
    if (!world.lightmap) return;
    if (world.lightmap->key != lightmap_key(world.scene, light_sources_of(level, world.scene))) {
        log_warning(lightmap_path(level.file).string() +
                    " was baked for another state of the level: shown without; `hatchway bake` makes it anew");
        world.lightmap.reset();
        return;
    }
    for (std::size_t i = 0; i < world.scene.meshes.size(); ++i)
        add_lightmap_stream(world.scene.meshes[i], world.lightmap->layouts[i]);
}

/// Also where nobody compiles its visibility or draws it, a wrong name in a level is told.
Scene imported(const Level& level)
{
    Scene scene = import_model(level.scene_file, level.project_root);
    structure_nodes(scene, level);
    find_mirrors(level, scene);
    return scene;
}

void hide_by_rules(const Level& level, Scene& scene)
{
    const auto says_visible = [](const AssignRule& rule) { return rule.visible.has_value(); };
    if (std::ranges::any_of(level.assign, says_visible))
        hide_objects(scene, resolve_looks(level, scene, kFallbackStyle));
}

/// Where the scene lies; what lies far away is one of its doubts.
ScenePlaces doubted_places(Scene& scene)
{
    ScenePlaces places = find_places(scene);
    if (std::optional<std::string> doubt = stray_doubt(places, scene)) scene.doubts.push_back(std::move(*doubt));
    return places;
}

}  // namespace

Level read_level_with(const std::filesystem::path& file, const std::vector<std::string>& style_overrides)
{
    Level level = read_level(file);
    for (std::size_t i = 0; i < style_overrides.size(); ++i)
        level.assign.push_back(override_rule(style_overrides[i], i + 1, file));
    return level;
}

Scene open_scene(const Level& level)
{
    Scene scene = imported(level);
    hide_by_rules(level, scene);
    doubted_places(scene);
    return scene;
}

std::shared_ptr<LevelWorld> open_world(const Level& level, BakedLight baked_light)
{
    auto world = std::make_shared<LevelWorld>();
    world->scene = imported(level);
    world->chunks.reserve(world->scene.meshes.size());
    for (MeshData& mesh : world->scene.meshes) world->chunks.push_back(split_into_chunks(mesh));
    // A lightmap adds vertices to meshes, and must not change what a compiled level is known by.
    world->geometry_key = geometry_key(world->scene);
    hide_by_rules(level, world->scene);
    world->chunks.resize(world->scene.meshes.size());
    world->hidden = hidden_objects(world->scene);
    world->places = doubted_places(world->scene);
    if (baked_light == BakedLight::if_there) add_baked_light(level, *world);
    return world;
}

bool same_world(const Level& before, const Level& after)
{
    return before.scene_file == after.scene_file && before.structure == after.structure &&
           before.is_sealed == after.is_sealed;
}

std::vector<Light> lights_of(const Level& level, const Scene& scene)
{
    std::vector<Light> lights = scene.lights;
    lights.insert(lights.end(), level.lights.begin(), level.lights.end());
    if (lights.empty()) {
        Light sun;
        sun.name = "default sun";
        sun.type = LightType::sun;
        sun.intensity = kSunLux;
        sun.direction_world = glm::normalize(glm::dvec3(0.45, -0.8, -0.4));
        lights.push_back(sun);
    }
    return lights;
}

double exposure_ev_of(const Level& level, const Scene& scene, const std::vector<Light>& lights)
{
    if (level.exposure_ev) return *level.exposure_ev;
    std::vector<double> lux;
    for (const Object& object : scene.objects) {
        if (object.bounds_world.is_empty()) continue;
        double sum = 0.0;
        for (const Light& light : lights)
            sum += luminance_weight(light.colour) * illuminance_at(light, object.bounds_world.centre());
        if (sum > 0.0) lux.push_back(sum);
    }
    if (lux.empty()) return std::log2(kSunLux / (glm::pi<double>() * 1.2 * kWhiteShare));
    const auto middle = lux.begin() + static_cast<std::ptrdiff_t>(lux.size() / 2);
    std::nth_element(lux.begin(), middle, lux.end());
    return std::log2(*middle / (glm::pi<double>() * 1.2 * kWhiteShare));
}

}  // namespace hw
