#include "hatchway/world/light/material.hpp"

#include <array>
#include <cmath>

namespace hw {
namespace {

const std::array<float, 256>& linear_of_srgb()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double c = static_cast<double>(i) / 255.0;
            values[i] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
        }
        return values;
    }();
    return table;
}

int wrapped(int at, int size, TextureWrap wrap)
{
    if (wrap == TextureWrap::clamp) return std::min(std::max(at, 0), size - 1);
    const int period = wrap == TextureWrap::repeat ? size : 2 * size;
    const int place = ((at % period) + period) % period;
    return place < size ? place : period - 1 - place;
}

glm::vec4 texel(const Pixels& image, int x, int y)
{
    const std::uint8_t* bytes = image.at(x, y);
    const auto& linear = linear_of_srgb();
    const bool is_gray = image.channels < 3;
    const float alpha = image.channels == 4 ? bytes[3] / 255.0f : image.channels == 2 ? bytes[1] / 255.0f : 1.0f;
    return {linear[bytes[0]], linear[bytes[is_gray ? 0 : 1]], linear[bytes[is_gray ? 0 : 2]], alpha};
}

const Pixels* image_of(const Scene& scene, const TextureUse& use)
{
    if (use.texture == kNone || scene.textures[use.texture].image == kNone) return nullptr;
    const Pixels& image = scene.images[scene.textures[use.texture].image];
    return image.is_empty() ? nullptr : &image;
}

glm::vec4 sampled(const MaterialPoint& point, const TextureUse& use)
{
    const Pixels* image = image_of(point.scene, use);
    const MeshData& mesh = point.scene.meshes[point.mesh];
    const std::vector<glm::vec2>& stream = use.uv_set == 1 ? mesh.uv1 : mesh.uv0;
    if (!image || stream.empty()) return glm::vec4(1.0f);
    glm::vec2 uv(0.0f);
    for (int corner = 0; corner < 3; ++corner)
        uv += point.barycentric[corner] * stream[mesh.indices[point.triangle * 3 + corner]];
    uv = glm::vec2(use.uv_transform * glm::vec3(uv, 1.0f));
    const Texture& texture = point.scene.textures[use.texture];
    const auto place = [](float share, int size) {
        return static_cast<int>(std::floor(std::fmod(static_cast<double>(share), 1024.0) * size));
    };
    return texel(*image, wrapped(place(uv.x, image->width), image->width, texture.wrap_u),
                 wrapped(place(uv.y, image->height), image->height, texture.wrap_v));
}

}  // namespace

glm::vec4 base_colour_at(const MaterialPoint& point)
{
    const Material& material = point.scene.materials[point.material];
    glm::vec4 colour = material.base_colour * sampled(point, material.base_colour_texture);
    const MeshData& mesh = point.scene.meshes[point.mesh];
    if (mesh.colours.empty()) return colour;
    glm::vec4 of_vertices(0.0f);
    for (int corner = 0; corner < 3; ++corner)
        of_vertices += point.barycentric[corner] * mesh.colours[mesh.indices[point.triangle * 3 + corner]];
    return colour * of_vertices;
}

glm::vec3 emission_at(const MaterialPoint& point)
{
    const Material& material = point.scene.materials[point.material];
    return material.emissive * glm::vec3(sampled(point, material.emissive_texture));
}

float mean_emission(const Scene& scene, const Material& material)
{
    if (luminance_of(material.emissive) <= 0.0f) return 0.0f;
    const Pixels* image = image_of(scene, material.emissive_texture);
    if (!image) return luminance_of(material.emissive);
    double sum = 0.0;
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x) sum += luminance_of(material.emissive * glm::vec3(texel(*image, x, y)));
    return static_cast<float>(sum / (static_cast<double>(image->width) * image->height));
}

}  // namespace hw
