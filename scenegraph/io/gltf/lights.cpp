#include "hatchway/io/gltf/lights.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>

#include "hatchway/core/log.hpp"
#include "hatchway/core/unique_names.hpp"
#include "hatchway/geometry/picture_up.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr double kWidestView_deg = 170.0;
constexpr double kLowestParallelView_m = 1e-6;
constexpr double kHighestParallelView_m = 1e9;
constexpr double kLeastRoll_deg = 1e-3;  // that moves a pixel of a large picture: less is rounding

/// The direction in which a node's light or camera looks, in the world.
glm::dvec3 forward_of(const Node& node)
{
    const glm::dvec3 forward(-node.world_from_node[2]);
    const double length = glm::length(forward);
    return std::isfinite(length) && length > 0.0 ? forward / length : glm::dvec3(0.0, 0.0, -1.0);
}

LightType type_of(const std::string& name)
{
    return name == "directional" ? LightType::sun : name == "spot" ? LightType::spot : LightType::point;
}

Light convert_light(const json& source, const Node& node)
{
    Light light;
    light.name = node.name.empty() ? source.value("name", "") : node.name;
    light.type = type_of(source.at("type").get<std::string>());
    const auto colour = source.value("color", std::vector<float>{1.0f, 1.0f, 1.0f});
    light.colour = {colour[0], colour[1], colour[2]};
    light.intensity = source.value("intensity", 1.0f);
    light.position_world = glm::dvec3(node.world_from_node[3]);
    light.direction_world = forward_of(node);
    light.range_m = source.value("range", 0.0f);
    if (source.contains("spot")) {
        light.inner_cone_rad = source.at("spot").value("innerConeAngle", light.inner_cone_rad);
        light.outer_cone_rad = source.at("spot").value("outerConeAngle", light.outer_cone_rad);
    }
    return light;
}

/// The roll of a camera whose top is the node's +y, degrees; 0 where nobody would see it.
double roll_deg(const Node& node)
{
    const glm::dvec3 forward = forward_of(node);
    const glm::dvec3 upright = picture_up(forward, 0.0);
    const glm::dvec3 stated(node.world_from_node[1]);
    const double leaning = glm::dot(stated, glm::cross(upright, forward));  // to its left
    const double angle = glm::degrees(std::atan2(leaning, glm::dot(stated, upright)));
    return std::abs(angle) > kLeastRoll_deg ? angle : 0.0;
}

/// As high as the file says; the picture's own shape decides how wide. False where it is no height.
bool read_projection(const tinygltf::Camera& source, Camera& camera)
{
    if (source.type == "perspective") {
        camera.fov_deg = std::clamp(glm::degrees(source.perspective.yfov), 1.0, kWidestView_deg);
        return true;
    }
    const double height = 2.0 * std::abs(source.orthographic.ymag);
    camera.orthographic_height_m = std::min(height, kHighestParallelView_m);
    return height >= kLowestParallelView_m;
}

}  // namespace

void add_lights(const GltfModel& model, const NodeOrder& order, Scene& scene)
{
    const json* list = GltfModel::extension(model.json, "KHR_lights_punctual");
    for (std::size_t i = 0; list && i < order.model_nodes.size(); ++i) {
        const json& stated = model.json.at("nodes")[static_cast<std::size_t>(order.model_nodes[i])];
        const json* use = GltfModel::extension(stated, "KHR_lights_punctual");
        if (!use) continue;
        const json& light = list->at("lights")[use->at("light").get<std::size_t>()];
        const std::string& type = light.at("type").get_ref<const std::string&>();
        if (type == "directional" || type == "point" || type == "spot")
            scene.lights.push_back(convert_light(light, scene.nodes[i]));
        else
            log_warning(fmt::format("{}: a light of the unknown type \"{}\" is left out", model.file, type));
    }
}

void add_cameras(const GltfModel& model, const NodeOrder& order, Scene& scene)
{
    UniqueNames names;  // cameras are asked for by name
    for (std::size_t i = 0; i < order.model_nodes.size(); ++i) {
        const int index = model.data.nodes[order.model_nodes[i]].camera;
        if (index < 0) continue;
        const tinygltf::Camera& source = model.data.cameras[index];
        const Node& node = scene.nodes[i];
        Camera camera;
        const std::string& wanted = node.name.empty() ? source.name : node.name;
        camera.name = names.take(wanted.empty() ? "camera" : wanted);
        camera.eye_world = glm::dvec3(node.world_from_node[3]);
        camera.target_world = camera.eye_world + forward_of(node);
        const auto doubt = [&](const std::string& what) {
            scene.doubts.push_back(
                fmt::format("{}: /cameras/{}: the camera \"{}\" {}", model.file, index, camera.name, what));
        };
        if (!read_projection(source, camera)) {
            doubt(fmt::format("is left out: its ymag is {:g}, so its picture has no height", source.orthographic.ymag));
            continue;
        }
        camera.roll_deg = roll_deg(node);
        scene.cameras.push_back(camera);
    }
}

}  // namespace hw
