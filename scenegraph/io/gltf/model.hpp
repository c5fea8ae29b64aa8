#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "hatchway/io/gltf/resources.hpp"
#include "hatchway/io/json/fwd.hpp"

namespace tinygltf {
class Model;
}

namespace hw {

/// A glTF document that check_gltf() has passed: as JSON, for extensions and extras, and as tinygltf sees it, with the
/// buffers loaded. Every index in it is in range. Private to io.
struct GltfModel {
    std::string file;
    const nlohmann::json& json;
    const tinygltf::Model& data;
    GltfResources resources;
    std::shared_ptr<const void> owner;  ///< Of `json` and `data`.

    /// The bytes of a buffer view.
    std::span<const std::byte> view(int index) const;
    /// An extension's object of a JSON object; null when it has none.
    static const nlohmann::json* extension(const nlohmann::json& object, const char* name);
    [[noreturn]] void refuse(const std::string& pointer, std::string what, std::string expected = {}) const;
};

/// Reads, checks and parses. tinygltf is given a copy of the checked document without what we do not use (extras,
/// images, skins, animations, unknown extensions), in which buffers are named by number: it opens no file and decodes
/// no image.
GltfModel load_gltf(const std::filesystem::path& file, const std::filesystem::path& project_root);

}  // namespace hw
