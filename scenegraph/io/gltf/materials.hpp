#pragma once

#include <map>

#include "hatchway/io/gltf/model.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Fills a scene's materials with those that are asked for, once each, and their textures and images. Private to io.
class MaterialImporter {
 public:
    MaterialImporter(GltfModel& model, Scene& scene) : model_(model), scene_(scene) {}

    /// Index into Scene::materials of a material of the model; kNone stands for glTF's default material.
    int import_material(int material);

 private:
    Material convert(std::size_t index);
    TextureUse texture_use(const nlohmann::json& owner, const char* name, const std::string& pointer);
    int import_texture(std::size_t index);
    int import_image(std::size_t index);
    std::span<const std::byte> encoded_image(std::size_t index, std::vector<std::byte>& storage);

    GltfModel& model_;
    Scene& scene_;
    std::map<int, int> materials_;
    std::map<std::size_t, int> textures_;
    std::map<std::size_t, int> images_;
    std::uint64_t encoded_bytes_ = 0;  ///< Of all images so far.
    std::uint64_t pixels_ = 0;
};

}  // namespace hw
