#include "hatchway/io/gltf/materials.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

TextureWrap wrap_of(int code)
{
    if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::clamp;
    return code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirrored_repeat : TextureWrap::repeat;
}

/// KHR_texture_transform: scaled, then rotated, then moved.
glm::mat3 uv_transform_of(const json& transform)
{
    const auto offset = transform.value("offset", std::vector<float>{0.0f, 0.0f});
    const auto scale = transform.value("scale", std::vector<float>{1.0f, 1.0f});
    const float angle = transform.value("rotation", 0.0f);
    const float s = std::sin(angle);
    const float c = std::cos(angle);
    return {glm::vec3(c * scale[0], -s * scale[0], 0.0f), glm::vec3(s * scale[1], c * scale[1], 0.0f),
            glm::vec3(offset[0], offset[1], 1.0f)};
}

AlphaMode alpha_mode_of(const std::string& name)
{
    return name == "BLEND" ? AlphaMode::blend : name == "MASK" ? AlphaMode::mask : AlphaMode::opaque;
}

}  // namespace

int MaterialImporter::import_material(int index)
{
    const auto [entry, is_new] = materials_.try_emplace(index, static_cast<int>(scene_.materials.size()));
    if (!is_new) return entry->second;
    scene_.materials.push_back(index == kNone ? Material{} : convert(static_cast<std::size_t>(index)));
    return entry->second;
}

Material MaterialImporter::convert(std::size_t index)
{
    static const json nothing = json::object();
    const tinygltf::Material& source = model_.data.materials[index];
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    const json& stated = model_.json.at("materials")[index];
    const json& stated_pbr = stated.contains("pbrMetallicRoughness") ? stated.at("pbrMetallicRoughness") : nothing;
    const std::string pointer = pointer_to("/materials", index);

    Material material;
    material.name = source.name;
    for (int i = 0; i < 4; ++i) material.base_colour[i] = static_cast<float>(pbr.baseColorFactor[i]);
    material.base_colour_texture = texture_use(stated_pbr, "baseColorTexture", pointer + "/pbrMetallicRoughness");
    material.metallic = static_cast<float>(pbr.metallicFactor);
    material.roughness = static_cast<float>(pbr.roughnessFactor);
    material.metallic_roughness_texture =
        texture_use(stated_pbr, "metallicRoughnessTexture", pointer + "/pbrMetallicRoughness");
    material.normal_texture = texture_use(stated, "normalTexture", pointer);
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.occlusion_texture = texture_use(stated, "occlusionTexture", pointer);
    material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
    material.emissive_texture = texture_use(stated, "emissiveTexture", pointer);
    const json* strength = GltfModel::extension(stated, "KHR_materials_emissive_strength");
    const float emission = strength ? strength->value("emissiveStrength", 1.0f) : 1.0f;
    for (int i = 0; i < 3; ++i) material.emissive[i] = static_cast<float>(source.emissiveFactor[i]) * emission;
    material.alpha_mode = alpha_mode_of(source.alphaMode);
    material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
    material.is_double_sided = source.doubleSided;
    material.is_unlit = GltfModel::extension(stated, "KHR_materials_unlit") != nullptr;
    return material;
}

TextureUse MaterialImporter::texture_use(const json& owner, const char* name, const std::string& pointer)
{
    TextureUse use;
    const auto info = owner.find(name);
    if (info == owner.end()) return use;
    use.uv_set = info->value("texCoord", 0);
    if (const json* transform = GltfModel::extension(*info, "KHR_texture_transform")) {
        use.uv_transform = uv_transform_of(*transform);
        use.uv_set = transform->value("texCoord", use.uv_set);
    }
    if (use.uv_set > 1) {
        log_warning(fmt::format("{}: {}/{}: texture coordinates {} are not read, only 0 and 1; the texture is left out",
                                model_.file, pointer, name, use.uv_set));
        return {};
    }
    use.texture = import_texture(info->at("index").get<std::size_t>());
    return use;
}

int MaterialImporter::import_texture(std::size_t index)
{
    if (const auto found = textures_.find(index); found != textures_.end()) return found->second;
    const tinygltf::Texture& source = model_.data.textures[index];
    int result = kNone;
    if (source.source >= 0) {
        Texture texture;
        texture.image = import_image(static_cast<std::size_t>(source.source));
        if (source.sampler >= 0) {
            const tinygltf::Sampler& sampler = model_.data.samplers[source.sampler];
            texture.wrap_u = wrap_of(sampler.wrapS);
            texture.wrap_v = wrap_of(sampler.wrapT);
            texture.is_nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
        }
        result = static_cast<int>(scene_.textures.size());
        scene_.textures.push_back(texture);
    } else {
        log_warning(
            fmt::format("{}: /textures/{}: the texture has no PNG or JPEG source; it is left out", model_.file, index));
    }
    textures_.emplace(index, result);
    return result;
}

std::span<const std::byte> MaterialImporter::encoded_image(std::size_t index, std::vector<std::byte>& storage)
{
    const json& image = model_.json.at("images")[index];
    if (image.contains("bufferView")) return model_.view(image.at("bufferView").get<int>());
    storage = model_.resources.read(image.at("uri").get<std::string>(), pointer_to("/images", index) + "/uri");
    return storage;
}

int MaterialImporter::import_image(std::size_t index)
{
    const auto [entry, is_new] = images_.try_emplace(index, static_cast<int>(scene_.images.size()));
    if (!is_new) return entry->second;
    std::vector<std::byte> storage;
    const std::span<const std::byte> encoded = encoded_image(index, storage);
    // A picture of one colour packs a thousand pixels into a byte: what a small file may unpack to is bounded, too.
    encoded_bytes_ += encoded.size();
    const std::uint64_t most =
        std::min(limits::kMaxTotalImagePixels, limits::kFreeImagePixels + limits::kMaxPixelsOfByte * encoded_bytes_);
    const std::uint64_t left = most - std::min(most, pixels_);
    const std::string name = model_.file + ": " + pointer_to("/images", index);
    scene_.images.push_back(decode_image(encoded, name, std::min(left, limits::kMaxImagePixels)));
    pixels_ += static_cast<std::uint64_t>(scene_.images.back().width) * scene_.images.back().height;
    return entry->second;
}

}  // namespace hw
