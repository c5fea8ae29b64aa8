#include "hatchway/io/gltf/nodes.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "hatchway/core/limits.hpp"
#include "hatchway/io/gltf/accessor.hpp"
#include "hatchway/io/gltf/extras.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr double kMaxTransform = 1e30;

std::vector<int> roots_of(const GltfModel& model)
{
    const tinygltf::Model& data = model.data;
    if (!data.scenes.empty()) return data.scenes[std::max(data.defaultScene, 0)].nodes;
    std::vector<bool> is_child(data.nodes.size(), false);
    for (const tinygltf::Node& node : data.nodes)
        for (const int child : node.children) is_child[child] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < data.nodes.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

glm::dmat4 composed(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale)
{
    const double length = glm::length(rotation);
    const glm::dquat unit = length > 0.0 ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
    return glm::scale(glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(unit), scale);
}

glm::dmat4 local_transform(const tinygltf::Node& node)
{
    glm::dmat4 matrix(1.0);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[i];
        return matrix;
    }
    glm::dvec3 translation(0.0);
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    glm::dvec3 scale(1.0);
    if (const auto& t = node.translation; t.size() == 3) translation = {t[0], t[1], t[2]};
    if (const auto& r = node.rotation; r.size() == 4) rotation = glm::dquat(r[3], r[0], r[1], r[2]);
    if (const auto& s = node.scale; s.size() == 3) scale = {s[0], s[1], s[2]};
    return composed(translation, rotation, scale);
}

bool is_bounded(const glm::dmat4& matrix)
{
    for (int i = 0; i < 16; ++i)
        if (!(std::abs(matrix[i / 4][i % 4]) <= kMaxTransform)) return false;
    return true;
}

/// Which nodes of the model an animation moves.
std::vector<bool> moved_nodes(const GltfModel& model)
{
    std::vector<bool> is_moved(model.data.nodes.size(), false);
    if (!model.json.contains("animations")) return is_moved;
    for (const json& animation : model.json.at("animations"))
        for (const json& channel : animation.at("channels")) {
            const json& target = channel.at("target");
            if (target.contains("node")) is_moved[target.at("node").get<std::size_t>()] = true;
        }
    return is_moved;
}

/// The attributes of an instanced node.
struct InstanceAttributes {
    std::optional<AccessorReader> translation;
    std::optional<AccessorReader> rotation;
    std::optional<AccessorReader> scale;
    std::size_t count = 0;
};

InstanceAttributes read_instance_attributes(const GltfModel& model, const json& attributes, const std::string& pointer)
{
    InstanceAttributes result;
    const auto read = [&](const char* name, int components, std::optional<AccessorReader>& target) {
        const auto found = attributes.find(name);
        if (found == attributes.end()) return;
        target.emplace(model, found->get<int>());
        if (target->components() != components)
            model.refuse(pointer_to(pointer, name),
                         fmt::format("its elements have {} components", target->components()),
                         std::to_string(components));
        if (result.count != 0 && result.count != target->count())
            model.refuse(pointer_to(pointer, name), fmt::format("it has {} elements", target->count()),
                         fmt::format("{}, as the others have", result.count));
        result.count = target->count();
    };
    read("TRANSLATION", 3, result.translation);
    read("ROTATION", 4, result.rotation);
    read("SCALE", 3, result.scale);
    return result;
}

}  // namespace

NodeOrder order_nodes(const GltfModel& model)
{
    struct Entry {
        int model_node;
        int parent;
    };
    NodeOrder order;
    std::vector<Entry> waiting;
    const auto push_all = [&](const std::vector<int>& nodes, int parent) {
        for (std::size_t i = nodes.size(); i-- > 0;) waiting.push_back({nodes[i], parent});
    };
    push_all(roots_of(model), kNone);
    while (!waiting.empty()) {
        const Entry entry = waiting.back();
        waiting.pop_back();
        const int index = static_cast<int>(order.model_nodes.size());
        order.model_nodes.push_back(entry.model_node);
        order.parents.push_back(entry.parent);
        push_all(model.data.nodes[entry.model_node].children, index);
    }
    return order;
}

void add_nodes(const GltfModel& model, const NodeOrder& order, Budget& budget, Scene& scene)
{
    budget.spend(Cost::nodes, order.model_nodes.size(), model.file, "/nodes");
    const std::vector<bool> is_moved = moved_nodes(model);
    ExtrasReader extras(model.file);
    for (std::size_t i = 0; i < order.model_nodes.size(); ++i) {
        const auto source = static_cast<std::size_t>(order.model_nodes[i]);
        const Node* parent = order.parents[i] == kNone ? nullptr : &scene.nodes[order.parents[i]];
        Node node;
        node.name = model.data.nodes[source].name;
        node.path = (parent ? parent->path + '/' : "") + (node.name.empty() ? '#' + std::to_string(i) : node.name);
        budget.spend(Cost::path_bytes, node.path.size(), model.file, pointer_to("/nodes", source));
        node.parent = order.parents[i];
        node.local = local_transform(model.data.nodes[source]);
        node.world_from_node = parent ? parent->world_from_node * node.local : node.local;
        node.is_animated = is_moved[source] || (parent && parent->is_animated);
        extras.read(model.json.at("nodes")[source], pointer_to("/nodes", source), node);
        if (!is_bounded(node.world_from_node))
            model.refuse(pointer_to("/nodes", source), "the transform from the node to the world is too large",
                         fmt::format("elements up to {:g}", kMaxTransform));
        scene.nodes.push_back(std::move(node));
    }
    scene.doubts = extras.doubts();
}

std::vector<glm::dmat4> instance_transforms(const GltfModel& model, int model_node)
{
    const auto index = static_cast<std::size_t>(model_node);
    const json* instancing = GltfModel::extension(model.json.at("nodes")[index], "EXT_mesh_gpu_instancing");
    if (!instancing) return {};
    const std::string pointer = pointer_to("/nodes", index) + "/extensions/EXT_mesh_gpu_instancing/attributes";
    const InstanceAttributes attributes = read_instance_attributes(model, instancing->at("attributes"), pointer);
    if (attributes.count > limits::kMaxObjects)
        model.refuse(pointer, fmt::format("there are {} instances", attributes.count),
                     fmt::format("at most {}", limits::kMaxObjects));
    std::vector<glm::dmat4> transforms;
    transforms.reserve(attributes.count);
    for (std::size_t i = 0; i < attributes.count; ++i) {
        const glm::dvec3 t = attributes.translation ? glm::dvec3(attributes.translation->at(i)) : glm::dvec3(0.0);
        const glm::dvec4 r = attributes.rotation ? glm::dvec4(attributes.rotation->at(i)) : glm::dvec4(0, 0, 0, 1);
        const glm::dvec3 s = attributes.scale ? glm::dvec3(attributes.scale->at(i)) : glm::dvec3(1.0);
        transforms.push_back(composed(t, glm::dquat(r.w, r.x, r.y, r.z), s));
        if (!is_bounded(transforms.back()))
            model.refuse(pointer, fmt::format("the transform of instance {} is not finite", i));
    }
    return transforms;
}

}  // namespace hw
