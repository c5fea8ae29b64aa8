#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hatchway/param/map_kind.hpp"
#include "hatchway/param/param_value.hpp"
#include "hatchway/world/presence.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// A named style of the level: a plugin and its stated parameters, not yet checked against the plugin.
struct StyleDesc {
    std::string plugin;
    ParamSettings params;
    std::string pointer;    ///< JSON pointer of the style, for messages.
    std::string like = {};  ///< The style of the level from which it has what it does not state itself; empty: none.
};

/// One entry of "assign". Later entries win, each for the keys that it states.
struct AssignRule {
    std::string nodes;      ///< Path glob, or "#12": a node by index; it reaches the node's children too. Empty: all.
    std::string materials;  ///< Glob over material names. Empty: all.
    std::optional<std::string> style;
    std::optional<std::string> over;        ///< A second style drawn over the first with `presence`.
    std::optional<PresenceField> presence;  ///< Of `over`; the first style keeps the rest.
    std::optional<double> certainty;
    std::map<MapKind, std::string> maps;  ///< Names of built-in maps, or paths relative to the level file.
    std::optional<bool> collides;
    std::optional<bool> visible;  ///< False: as if the objects were not in the model.
    std::string pointer;
};

/// Where a key of a rule stands, for messages: "/assign/0/style". A rule of the command line is named by its option.
inline std::string place_in(const AssignRule& rule, const std::string& key)
{
    return rule.pointer.starts_with('/') ? rule.pointer + '/' + key : rule.pointer;
}

/// "certainty_styles": the style of an object of at least this certainty; the largest that fits wins.
struct CertaintyStyle {
    double from = 0.0;
    std::string style;
};

/// One entry of "mirrors": flat objects in which the scene is seen.
struct MirrorRule {
    std::string nodes;            ///< Path glob, or "#12"; it reaches the node's children too.
    double reflectance = 0.9;     ///< How much of the objects' own look the reflection takes, [0, 1].
    glm::vec3 tint_linear{1.0f};  ///< What the reflection is multiplied by.
    std::string pointer;
};

struct PathKey {
    double t_s = 0.0;
    glm::dvec3 position{0.0};
    glm::dvec3 look_at{0.0};
};

/// A camera path. Catmull-Rom in position, slerp in direction.
struct CameraPath {
    std::string name;
    double fps = 25.0;
    double fov_deg = 60.0;
    std::vector<PathKey> keys;  ///< At least one, times strictly rising.
};

struct StartPlace {
    glm::dvec3 position{0.0, 1.7, 5.0};
    glm::dvec3 look_at{0.0, 1.5, 0.0};
};

/// A level file as read: everything but the model. A bare model gives one with defaults.
struct Level {
    std::filesystem::path file;          ///< The level file, or the bare model.
    std::filesystem::path project_root;  ///< No path of the level leaves this folder.
    std::filesystem::path scene_file;
    std::optional<StartPlace> start;
    std::optional<double> exposure_ev;                  ///< Absent: chosen from the lights.
    std::optional<glm::vec3> background;                ///< sRGB; absent: paper.
    std::optional<std::vector<std::string>> structure;  ///< Path globs; absent: chosen automatically.
    std::map<std::string, StyleDesc> styles;
    std::vector<AssignRule> assign;
    std::vector<CertaintyStyle> certainty_styles;
    std::vector<Camera> cameras;    ///< In the order of the file.
    std::vector<CameraPath> paths;  ///< In the order of the file.
    std::vector<Light> lights;      ///< Added to the model's.
    std::vector<MirrorRule> mirrors;
    int mirror_depth = 2;  ///< How many mirrors a line of sight is followed through, 1 to 4.
    bool is_sealed = false;
};

/// The camera or path of that name; null when there is none.
template <typename Named>
const Named* find_named(const std::vector<Named>& all, std::string_view name)
{
    for (const Named& one : all)
        if (one.name == name) return &one;
    return nullptr;
}

}  // namespace hw
