#include "program/authoring/map_preview.hpp"

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/context.hpp"
#include "hatchway/gl/headless_context.hpp"
#include "hatchway/plugin_host/make_style.hpp"
#include "hatchway/render/renderer.hpp"
#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {
namespace {

constexpr int kWidth = 1024;
constexpr int kPlaneHeight = 576;
constexpr int kGap = 12;
constexpr int kHatchRows = 24;  // a hatch map is one texel high
constexpr double kFovDeg = 50.0;
constexpr std::uint8_t kMount = 214;

int shown_height(const MapLevels& map, const Pixels& level)
{
    return map.kind == MapKind::hatch ? kHatchRows : level.height;
}

/// Places the levels in rows and returns the height that they take; with `sheet`, draws them.
int lay_levels(const MapLevels& map, Pixels* sheet)
{
    int x = kGap;
    int y = kGap;
    int row_height = 0;
    for (const Pixels& level : map.levels) {
        const int width = std::min(level.width, kWidth - 2 * kGap);
        const int height = shown_height(map, level);
        if (x + width > kWidth - kGap) {
            x = kGap;
            y += row_height + kGap;
            row_height = 0;
        }
        for (int v = 0; sheet != nullptr && v < height; ++v)
            for (int u = 0; u < width; ++u)
                std::fill_n(sheet->at(x + u, y + v), 3, *level.at(u, map.kind == MapKind::hatch ? 0 : v));
        x += width + kGap;
        row_height = std::max(row_height, height);
    }
    return y + row_height + kGap;
}

/// Level ground whose texture coordinates are metres.
Scene ground(float side_m)
{
    Scene scene;
    const float h = 0.5f * side_m;
    MeshData mesh;
    mesh.positions = {{-h, 0, h}, {h, 0, h}, {h, 0, -h}, {-h, 0, -h}};
    mesh.normals.assign(4, glm::vec3(0, 1, 0));
    for (const glm::vec3& p : mesh.positions) mesh.uv0.emplace_back(p.x, p.z);
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(std::move(mesh));
    scene.materials.emplace_back();
    scene.nodes.push_back({.name = "ground"});
    scene.bounds_world.add(glm::dvec3(-h, 0, -h));
    scene.bounds_world.add(glm::dvec3(h, 0, h));
    scene.objects.push_back({.node = 0, .mesh = 0, .material = 0, .bounds_world = scene.bounds_world});
    return scene;
}

ParamSettings style_settings(const MapLevels& map)
{
    const Pixels& finest = map.levels.front();
    const char* shaded = finest.width == finest.height ? "halftone" : "shaded";
    const char* tone = map.kind == MapKind::hatch ? "plain" : map.kind == MapKind::tonal ? shaded : "none";
    ParamSettings settings;
    settings["tone"] = {std::string(tone), ""};
    settings["spacing_px"] = {std::max(map.spacing_texels, 2.0), ""};
    settings["hatch_deg"] = {90.0, ""};
    settings["line_width_px"] = {0.0, ""};
    for (const char* width : {"silhouette_width_px", "border_width_px", "valley_width_px", "intersection_width_px"})
        settings[width] = {0.0, ""};
    settings["ink_map_detail"] = {0.0, ""};
    settings["light_response"] = {0.0, ""};
    settings["material_tone"] = {0.0, ""};
    return settings;
}

/// The ground from where a texel of the finest level is about a pixel at the lower edge of the picture.
Pixels plane_picture(const MapLevels& map)
{
    const double texels = map.kind == MapKind::tonal ? map.levels.front().height : map.levels.front().width;
    const double near_m = map.size_m / texels * 0.5 * kPlaneHeight / std::tan(glm::radians(0.5 * kFovDeg));
    const Scene scene = ground(static_cast<float>(near_m * 800.0));
    const PluginRegistry plugins;
    const Plugin& plugin = require_plugin(plugins, "pen_and_ink", PluginKind::style, {});
    const std::unique_ptr<Style> style = make_style(plugin, style_settings(map), {});
    const auto context = make_headless_context();
    Renderer renderer(*context);
    style->prepare(renderer.program_cache(plugin.shader_folder));
    SceneInput input{.scene = &scene, .styles = {{"preview", style.get()}}};
    input.objects = {{.style = 0, .maps = {{map.kind, 0}}}};
    input.maps = {&map};
    input.lights = {{.type = LightType::sun, .intensity = 20000.0f, .direction_world = {0.0, -1.0, 0.0}}};
    input.exposure_ev = 14.0f;
    renderer.load(std::move(input));
    const double pitch = glm::radians(0.5 * kFovDeg - 1.0);
    const double height = near_m * std::sin(pitch + glm::radians(0.5 * kFovDeg));
    const CameraPlace camera{
        {0.013 * near_m, height, 0.0}, {0.013 * near_m, height - std::sin(pitch), -std::cos(pitch)}, kFovDeg};
    renderer.draw(camera_view(camera, {kWidth, kPlaneHeight}, scene.bounds_world), {});
    return renderer.read_picture();
}

}  // namespace

Pixels map_preview(const MapLevels& map)
{
    const int levels_height = lay_levels(map, nullptr);
    Pixels sheet{.width = kWidth, .height = levels_height, .channels = 3};
    sheet.bytes.assign(std::size_t(kWidth) * levels_height * 3, kMount);
    lay_levels(map, &sheet);
    const Pixels plane = plane_picture(map);
    HW_ASSERT(plane.channels == 3 && plane.width == kWidth);
    sheet.bytes.insert(sheet.bytes.end(), plane.bytes.begin(), plane.bytes.end());
    sheet.height += plane.height;
    return sheet;
}

}  // namespace hw
