#include "hatchway/io/gltf/check/meshes.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;

/// What KHR_mesh_quantization widened attributes to is accepted without asking whether the model declares it.
struct AttributeRule {
    std::string_view name;
    std::initializer_list<std::string_view> types;
    bool may_be_unnormalised = false;  ///< Whole numbers may also mean themselves.
};
const AttributeRule kAttributes[] = {
    {"POSITION", {"VEC3"}, true},   {"NORMAL", {"VEC3"}},           {"TANGENT", {"VEC4"}},
    {"TEXCOORD_0", {"VEC2"}, true}, {"TEXCOORD_1", {"VEC2"}, true}, {"COLOR_0", {"VEC3", "VEC4"}},
};

void check_attribute(const GltfChecked& gltf, const AttributeRule& rule, const json& accessor,
                     const std::string& pointer)
{
    const std::string& type = accessor.at("type").get_ref<const std::string&>();
    if (std::ranges::find(rule.types, type) == rule.types.end())
        gltf.refuse(pointer, fmt::format("{} holds elements of type {}", rule.name, type),
                    fmt::format("{}", fmt::join(rule.types, " or ")));
    const int component = accessor.at("componentType").get<int>();
    const bool is_normalised = accessor.value("normalized", false);
    const bool is_read =
        component == kFloat || (component < kUnsignedInt && (is_normalised || rule.may_be_unnormalised));
    if (!is_read)
        gltf.refuse(pointer, fmt::format("{} holds components of type {}", rule.name, component),
                    "float, or normalised bytes or shorts");
}

void check_attributes(const GltfChecked& gltf, const json& attributes, const std::string& pointer)
{
    std::uint64_t count = 0;
    for (const auto& [name, index] : attributes.items()) {
        const json& accessor = gltf.accessor(index);
        const std::uint64_t own_count = gltf.whole(accessor, "count", 0);
        if (count != 0 && own_count != count)
            gltf.refuse(pointer_to(pointer, name), fmt::format("the attribute has {} elements", own_count),
                        fmt::format("{}, as the others have", count));
        count = own_count;
        for (const AttributeRule& rule : kAttributes)
            if (rule.name == name) check_attribute(gltf, rule, accessor, pointer_to(pointer, name));
    }
}

void check_indices(const GltfChecked& gltf, const json& accessor, const std::string& pointer)
{
    const int component = accessor.at("componentType").get<int>();
    const bool is_unsigned = component == 5121 || component == 5123 || component == kUnsignedInt;
    if (!is_unsigned || accessor.at("type") != "SCALAR")
        gltf.refuse(pointer,
                    fmt::format("indices are {} of component type {}", described(accessor.at("type")), component),
                    "SCALAR of unsigned bytes, shorts or ints");
    if (!accessor.contains("bufferView")) gltf.refuse(pointer, "the indices' accessor has no bufferView");
}

void check_targets(const GltfChecked& gltf, const json& primitive, const std::string& pointer)
{
    const json& targets = primitive.at("targets");
    const json& attributes = primitive.at("attributes");
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const std::string place = pointer_to(pointer, i);
        for (const auto& [name, index] : targets[i].items()) {
            if (!attributes.contains(name)) continue;
            const std::uint64_t count = gltf.whole(gltf.accessor(index), "count", 0);
            const std::uint64_t base_count = gltf.whole(gltf.accessor(attributes.at(name)), "count", 0);
            if (count != base_count)
                gltf.refuse(pointer_to(place, name), fmt::format("the target has {} elements", count),
                            fmt::format("{}, as the attribute has", base_count));
        }
    }
}

void check_primitive(const GltfChecked& gltf, const json& primitive, const std::string& pointer)
{
    check_attributes(gltf, primitive.at("attributes"), pointer + "/attributes");
    if (primitive.contains("indices"))
        check_indices(gltf, gltf.accessor(primitive.at("indices")), pointer + "/indices");
    if (primitive.contains("targets")) check_targets(gltf, primitive, pointer + "/targets");
}

void check_weights(const GltfChecked& gltf, const json& owner, const json& mesh, const std::string& pointer)
{
    if (!owner.contains("weights") || owner.at("weights").size() == target_count(mesh)) return;
    gltf.refuse(pointer + "/weights", fmt::format("there are {} weights", owner.at("weights").size()),
                fmt::format("{}, one for each morph target", target_count(mesh)));
}

}  // namespace

std::size_t target_count(const json& mesh)
{
    const json& primitives = mesh.at("primitives");
    return primitives.empty() || !primitives[0].contains("targets") ? 0 : primitives[0].at("targets").size();
}

void check_meshes(const GltfChecked& gltf)
{
    const json& meshes = gltf.list("meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const std::string pointer = pointer_to("/meshes", i);
        const json& primitives = meshes[i].at("primitives");
        for (std::size_t k = 0; k < primitives.size(); ++k)
            check_primitive(gltf, primitives[k], pointer_to(pointer + "/primitives", k));
        check_weights(gltf, meshes[i], meshes[i], pointer);
    }
    const json& nodes = gltf.list("nodes");
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (const auto mesh = gltf.index(nodes[i], "mesh"))
            check_weights(gltf, nodes[i], meshes[*mesh], pointer_to("/nodes", i));
}

}  // namespace hw
