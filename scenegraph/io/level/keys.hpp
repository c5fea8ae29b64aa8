#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "hatchway/world/level.hpp"

namespace hw {

/// A key of an object in a level file. Private to io.
struct LevelKey {
    std::string_view name;
    std::string_view help;  ///< One sentence, for the schema.
    bool is_required = false;
};

struct LevelRange {
    double min = 0.0;
    double max = 0.0;
};

inline constexpr std::string_view kLevelFormat = "hatchway-level/1";
inline constexpr std::array<std::string_view, 3> kLightTypes{"sun", "point", "spot"};  // as enum LightType
inline constexpr LevelRange kMetres{-1e9, 1e9};
inline constexpr LevelRange kSeconds{0.0, 1e6};
inline constexpr LevelRange kFraction{0.0, 1.0};
inline constexpr LevelRange kFieldOfView{1.0, 170.0};
inline constexpr LevelRange kRoll{-360.0, 360.0};
inline constexpr LevelRange kMirrorDepth{1.0, 4.0};
inline constexpr LevelRange kParallelHeight{1e-6, 1e9};

/// "maps" of an assign entry: paths by kind.
struct MapPaths {
    std::map<MapKind, std::string>& paths;
};

struct OrthographicKeys {
    double height_m = 1.0;
};

struct HeightKeys {
    Ramp ramp;
};
struct TimeKeys {
    Ramp ramp;
};

// visit_keys(visitor, object) lists the keys of an object once: the reader fills them from a file, the schema writer
// describes them. A visitor has a function for each type of value.

template <typename Visitor>
void visit_keys(Visitor& v, StartPlace& place)
{
    v.point({"position", "The eye, metres, y up.", true}, place.position);
    v.point({"look_at", "A point that the eye looks at.", true}, place.look_at);
}

template <typename Visitor>
void visit_keys(Visitor& v, OrthographicKeys& view)
{
    v.real({"height_m", "What the picture shows from bottom to top, metres.", true}, kParallelHeight, view.height_m);
}

template <typename Visitor>
void visit_keys(Visitor& v, Camera& camera)
{
    OrthographicKeys parallel;
    v.point({"position", "The eye, metres, y up.", true}, camera.eye_world);
    v.point({"look_at", "A point that the eye looks at.", true}, camera.target_world);
    v.real({"fov_deg", "Vertical field of view."}, kFieldOfView, camera.fov_deg);
    if (v.object({"orthographic", "A parallel projection, such as a plan or an elevation, in place of fov_deg."},
                 parallel))
        camera.orthographic_height_m = parallel.height_m;
    v.not_both("fov_deg", "orthographic");
    v.real(
        {"roll_deg", "Turns the camera about its line of sight, counter-clockwise as it looks; a whole turn at most."},
        kRoll, camera.roll_deg);
}

template <typename Visitor>
void visit_keys(Visitor& v, PathKey& key)
{
    v.real({"t_s", "Time from the start of the path.", true}, kSeconds, key.t_s);
    v.point({"position", "The eye, metres, y up.", true}, key.position);
    v.point({"look_at", "A point that the eye looks at.", true}, key.look_at);
}

template <typename Visitor>
void visit_keys(Visitor& v, CameraPath& path)
{
    v.real({"fps", "Frames a second of the rendered path."}, {1.0, 1000.0}, path.fps);
    v.real({"fov_deg", "Vertical field of view."}, kFieldOfView, path.fov_deg);
    v.objects({"keys", "Places on the path, in the order of time.", true}, path.keys);
}

template <typename Visitor>
void visit_keys(Visitor& v, HeightKeys& ramp)
{
    v.real({"from_m", "World height where the field is 0.", true}, kMetres, ramp.ramp.from);
    v.real({"to_m", "World height where it has risen; may be the lower one.", true}, kMetres, ramp.ramp.to);
}

template <typename Visitor>
void visit_keys(Visitor& v, TimeKeys& ramp)
{
    v.real({"from_s", "Time where the field starts to rise.", true}, kSeconds, ramp.ramp.from);
    v.real({"to_s", "Time where it has risen.", true}, kSeconds, ramp.ramp.to);
}

template <typename Visitor>
void visit_keys(Visitor& v, PresenceField& field)
{
    HeightKeys height;
    TimeKeys time;
    v.real({"constant", "How much of the style shows, everywhere."}, kFraction, field.constant);
    if (v.object({"height", "A ramp over world height."}, height)) field.height = height.ramp;
    if (v.object({"time", "A ramp over time."}, time)) field.time = time.ramp;
}

template <typename Visitor>
void visit_keys(Visitor& v, MapPaths& maps)
{
    for (std::size_t kind = 0; kind < kMapKindCount; ++kind) {
        std::string path;
        if (v.text({kMapKinds[kind].name, kMapKinds[kind].help}, path))
            maps.paths.emplace(static_cast<MapKind>(kind), path);
    }
}

template <typename Visitor>
void visit_keys(Visitor& v, AssignRule& rule)
{
    MapPaths maps{rule.maps};
    v.text({"nodes", "Nodes by path, such as Hall/Column_*, or #12; their children too. Absent: all."}, rule.nodes);
    v.text({"materials", "Materials by name, with * and ?. Absent: all."}, rule.materials);
    v.text({"style", "A style of this level, or a plugin with its defaults."}, rule.style);
    v.text({"over", "A second style, drawn over the first as far as presence says."}, rule.over);
    v.object({"presence", "How much of \"over\" shows, by height and time."}, rule.presence);
    v.real({"certainty", "How certain the objects are, from conjecture to find."}, kFraction, rule.certainty);
    v.object({"maps", "Maps of these objects, instead of the style's."}, maps);
    v.flag({"collides", "Whether a walker bumps into these objects."}, rule.collides);
    v.flag({"visible", "False: as if these objects were not in the model."}, rule.visible);
}

template <typename Visitor>
void visit_keys(Visitor& v, CertaintyStyle& entry)
{
    v.real({"from", "The least certainty of the objects.", true}, kFraction, entry.from);
    v.text({"style", "Their style.", true}, entry.style);
}

template <typename Visitor>
void visit_keys(Visitor& v, StyleDesc& style)
{
    v.text({"plugin", "The plugin that draws the style."}, style.plugin);
    v.text({"like", "A style of this level, in place of a plugin: its plugin and all parameters not stated here."},
           style.like);
    v.one_of("plugin", "like");
    v.params(style.params);
}

template <typename Visitor>
void visit_keys(Visitor& v, Light& light)
{
    v.choice({"type", "The kind of light.", true}, kLightTypes, light.type);
    v.text({"name", "For lists."}, light.name);
    v.point({"direction", "From the light to what it lights; of sun and spot."}, light.direction_world);
    v.point({"position", "Of point and spot, metres."}, light.position_world);
    v.real({"illuminance_lux", "Of a sun, on a surface that faces it."}, {0.0, 1e9}, light.intensity);
    v.real({"intensity_cd", "Of point and spot."}, {0.0, 1e9}, light.intensity);
    v.linear_colour({"colour", "#rrggbb, sRGB."}, light.colour);
    v.real({"range_m", "Where the light ends; 0: nowhere."}, {0.0, 1e9}, light.range_m);
    v.angle({"inner_cone_deg", "Of a spot: full light within."}, {0.0, 89.9}, light.inner_cone_rad);
    v.angle({"outer_cone_deg", "Of a spot: no light outside."}, {0.1, 90.0}, light.outer_cone_rad);
}

template <typename Visitor>
void visit_keys(Visitor& v, MirrorRule& mirror)
{
    v.text({"nodes", "Flat nodes by path, such as Hall/Mirror_*, or #12; their children too.", true}, mirror.nodes);
    v.real({"reflectance", "How much of its own look the reflection takes; default 0.9."}, kFraction,
           mirror.reflectance);
    v.linear_colour({"tint", "#rrggbb, sRGB, that the reflection is multiplied by; default white."},
                    mirror.tint_linear);
}

template <typename Visitor>
void visit_keys(Visitor& v, Level& level)
{
    v.ignored({"$schema", "The schema that editors check this file with."});
    v.constant({"format", "The version of this format.", true}, kLevelFormat);
    v.file({"scene", "The model (.glb, .gltf, .obj, .ply, .stl, .off), relative to this file.", true},
           level.scene_file);
    v.object({"start", "Where a walk starts."}, level.start);
    v.real({"exposure_ev", "Exposure value; absent: chosen from the lights."}, {-20.0, 40.0}, level.exposure_ev);
    v.colour({"background", "#rrggbb of the sky; absent: paper."}, level.background);
    v.flag({"sealed", "The level is closed: report a leak when it is compiled."}, level.is_sealed);
    v.texts({"structure", "Nodes that partition space; absent: chosen automatically."}, level.structure);
    v.named({"styles", "Styles by name: a plugin, or another style, and parameters."}, level.styles);
    v.objects({"assign", "Which objects have which style, maps and certainty; later entries win."}, level.assign);
    v.objects({"certainty_styles", "The style of objects without one, by certainty."}, level.certainty_styles);
    v.named({"cameras", "Viewpoints by name."}, level.cameras);
    v.named({"paths", "Camera paths by name."}, level.paths);
    v.objects({"lights", "Lights beside the model's."}, level.lights);
    v.objects({"mirrors", "Flat objects that mirror what is before them; later entries win."}, level.mirrors);
    v.whole({"mirror_depth", "How many mirrors a line of sight is followed through; default 2."}, kMirrorDepth,
            level.mirror_depth);
}

}  // namespace hw
