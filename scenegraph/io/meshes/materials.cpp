#include "hatchway/io/meshes/materials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/srgb.hpp"
#include "hatchway/io/images/images.hpp"
#include "hatchway/io/meshes/text.hpp"

namespace hw {
namespace {

constexpr std::uint64_t kMaxMaterialBytes = 16ull << 20;
constexpr float kPlainGrey = 0.8f;  // sRGB
constexpr float kRoughness = 0.9f;

/// Three numbers, or one for all three; nothing for what is no colour.
std::optional<glm::vec3> colour_of(std::string_view line)
{
    glm::vec3 colour(0.0f);
    for (int i = 0; i < 3; ++i) {
        const std::string_view word = next_word(line);
        const std::optional<double> value = parse_number(word);
        if (i > 0 && word.empty()) return glm::vec3(colour.x);
        if (!value || !(*value >= 0.0)) return {};
        colour[i] = linear_from_srgb(static_cast<float>(std::min(*value, 1.0)));
    }
    return colour;
}

/// The file behind options such as "-s 1 1 1"; it may have blanks in its name.
std::string texture_of(std::string_view line)
{
    line = trimmed(line);
    while (line.starts_with('-')) {
        next_word(line);
        std::string_view rest = line;
        for (std::string_view word = next_word(rest); parse_number(word) || word == "on" || word == "off";
             word = next_word(rest))
            line = rest;
        line = trimmed(line);
    }
    std::string name(line);
    std::ranges::replace(name, '\\', '/');
    return name;
}

}  // namespace

Material plain_material(bool has_vertex_colours)
{
    Material material;
    if (!has_vertex_colours) material.base_colour = glm::vec4(glm::vec3(linear_from_srgb(kPlainGrey)), 1.0f);
    material.metallic = 0.0f;
    material.roughness = kRoughness;
    material.is_double_sided = true;
    return material;
}

ObjMaterials::ObjMaterials(const std::filesystem::path& file, const std::filesystem::path& project_root,
                           const std::vector<std::string>& material_files)
    : file_(file), project_root_(project_root)
{
    for (const std::string& named : material_files) try {
            read(named);
        } catch (const Error& error) {
            log_warning(fmt::format("{}; its materials are left out", error.what()));
        }
}

std::filesystem::path ObjMaterials::resolve(const std::string& named) const
{
    return resolve_inside(project_root_, file_.parent_path(), named, file_.string(), "");
}

void ObjMaterials::read(const std::string& file)
{
    std::string name = file;
    std::ranges::replace(name, '\\', '/');
    const std::string text = read_text_file(resolve(name), kMaxMaterialBytes);
    TextLines lines(text);
    Stated* current = nullptr;
    for (std::string_view line; lines.next(line);) read_line(line, current);
}

void ObjMaterials::read_line(std::string_view line, Stated*& current)
{
    const std::string_view word = next_word(line);
    if (word == "newmtl") {
        if (stated_.size() >= static_cast<std::size_t>(limits::kMaxNames)) {
            current = nullptr;
            return;
        }
        const std::string name(trimmed(line));
        current = &(stated_[name] = {.material = plain_material(false), .texture = {}});
        current->material.name = name;
    }
    if (!current) return;
    Material& material = current->material;
    if (word == "Kd") {
        if (const auto colour = colour_of(line)) material.base_colour = glm::vec4(*colour, material.base_colour.a);
    } else if (word == "d" || word == "Tr") {
        if (const auto value = parse_number(next_word(line)); value && *value >= 0.0 && *value <= 1.0)
            material.base_colour.a = static_cast<float>(word == "d" ? *value : 1.0 - *value);
        material.alpha_mode = material.base_colour.a < 1.0f ? AlphaMode::blend : AlphaMode::opaque;
    } else if (word == "map_Kd") {
        current->texture = texture_of(line);
    }
}

int ObjMaterials::import_material(const std::string& name, bool has_vertex_colours, Scene& scene)
{
    const auto stated = stated_.find(name);
    const bool is_plain = stated == stated_.end();
    const auto [entry, is_new] =
        imported_.try_emplace({name, is_plain && has_vertex_colours}, static_cast<int>(scene.materials.size()));
    if (!is_new) return entry->second;
    Material material = is_plain ? plain_material(has_vertex_colours) : stated->second.material;
    material.name = name;
    if (!is_plain && !stated->second.texture.empty())
        material.base_colour_texture.texture = import_texture(stated->second.texture, scene);
    scene.materials.push_back(std::move(material));
    return entry->second;
}

int ObjMaterials::import_texture(const std::string& texture, Scene& scene)
{
    const auto [entry, is_new] = textures_.try_emplace(texture, kNone);
    if (!is_new) return entry->second;
    try {
        const std::filesystem::path path = resolve(texture);
        const std::vector<std::byte> bytes =
            read_file(path, std::min(limits::kMaxFileBytes, limits::kMaxTotalBytes - bytes_));
        bytes_ += bytes.size();
        const std::uint64_t left = limits::kMaxTotalImagePixels - pixels_;
        Pixels pixels = decode_image(bytes, path.string(), std::min(left, limits::kMaxImagePixels));
        pixels_ += static_cast<std::uint64_t>(pixels.width) * pixels.height;
        scene.images.push_back(std::move(pixels));
        scene.textures.push_back({.image = static_cast<int>(scene.images.size()) - 1});
        entry->second = static_cast<int>(scene.textures.size()) - 1;
    } catch (const Error& error) {
        log_warning(fmt::format("{}; the texture is left out", error.what()));
    }
    return entry->second;
}

}  // namespace hw
