#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace hw {

/// Proves that a glTF document keeps its promises, as far as the JSON alone tells: everything that gltf_rules() states;
/// buffer views inside of their buffers, accessors inside of their views; a node tree without loops, within limits;
/// attributes of the right types and of equal counts; counts of weights, matrices and animation keys. Whole numbers
/// written as 1.0 become whole. Throws hw::Error with the JSON pointer. Private to io.
void check_gltf(nlohmann::json& document, const std::string& file);

/// An element of a glTF type, as an accessor stores it: bytes in all, and components.
struct ElementSize {
    std::size_t bytes = 0;
    int components = 0;
    std::size_t component_bytes = 0;
};
ElementSize element_size(int component_type, const std::string& type);

// The parts of check_gltf().

/// A checked document and the words for what is wrong in it.
struct GltfChecked {
    const nlohmann::json& root;
    const std::string& file;

    [[noreturn]] void refuse(const std::string& pointer, std::string what, std::string expected = {}) const;
    /// The array of root[name]; empty when it is missing.
    const nlohmann::json& list(const char* name) const;
    /// The value of a whole number, or `fallback` when the object has none.
    static std::uint64_t whole(const nlohmann::json& object, const char* name, std::uint64_t fallback);
    static std::optional<std::size_t> index(const nlohmann::json& object, const char* name);
};
void check_buffers(const GltfChecked& gltf);
void check_meshes(const GltfChecked& gltf);
void check_nodes(const GltfChecked& gltf);
void check_motion(const GltfChecked& gltf);

}  // namespace hw
