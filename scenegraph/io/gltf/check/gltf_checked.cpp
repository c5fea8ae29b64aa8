#include "hatchway/io/gltf/check/gltf_checked.hpp"

#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"

namespace hw {

using nlohmann::json;

void GltfChecked::refuse(const std::string& pointer, std::string what, std::string expected) const
{
    throw Error({.what = std::move(what), .file = file, .pointer = pointer, .expected = std::move(expected)});
}

const json& GltfChecked::list(const char* name) const
{
    static const json empty = json::array();
    const auto found = root.find(name);
    return found == root.end() ? empty : *found;
}

const json& GltfChecked::accessor(const json& index) const
{
    return list("accessors")[index.get<std::size_t>()];
}

std::uint64_t GltfChecked::whole(const json& object, const char* name, std::uint64_t fallback)
{
    const auto found = object.find(name);
    return found == object.end() ? fallback : found->get<std::uint64_t>();
}

std::optional<std::size_t> GltfChecked::index(const json& object, const char* name)
{
    const auto found = object.find(name);
    if (found == object.end()) return {};
    return found->get<std::size_t>();
}

}  // namespace hw
