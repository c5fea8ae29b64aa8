#include "hatchway/render/device/texture_store.hpp"

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

fs::path find_texture(const fs::path& folder, const fs::path& file)
{
    if (file.is_absolute()) return file;
    const fs::path maps = installation_prefix() / "share" / "hatchway" / "maps";
    for (const fs::path& place : {folder, maps})
        if (std::error_code ignored; fs::is_regular_file(place / file, ignored))
            return resolve_inside(place, place, file.string(), "", "");
    throw Error({.what = "no texture \"" + file.string() + "\"",
                 .expected = "a PNG or JPEG file in " + folder.string() + " or " + maps.string()});
}

/// Red alone, or red, green, blue and opacity: three channels are no format that every device draws from.
std::vector<std::uint8_t> texels_of(const Pixels& pixels)
{
    if (pixels.channels == 1) return pixels.bytes;
    std::vector<std::uint8_t> rgba;
    rgba.reserve(pixels.bytes.size() / pixels.channels * 4);
    for (std::size_t i = 0; i < pixels.bytes.size(); i += pixels.channels) {
        const std::uint8_t* at = &pixels.bytes[i];
        const bool is_gray = pixels.channels == 2;
        const bool has_alpha = pixels.channels % 2 == 0;
        rgba.insert(rgba.end(), {at[0], at[is_gray ? 0 : 1], at[is_gray ? 0 : 2]});
        rgba.push_back(has_alpha ? at[pixels.channels - 1] : 255);
    }
    return rgba;
}

}  // namespace

Image TextureStore::texture(const fs::path& folder, std::string_view file)
{
    if (!read_) throw Error({.what = "this host reads no textures of styles"});
    const fs::path path = find_texture(folder, fs::path(file)).lexically_normal();
    GpuTexture& texture = textures_[path];
    if (texture.id() == 0) {
        const Pixels pixels = read_(path);
        const bool is_gray = pixels.channels == 1;
        GpuTexture made({.format = is_gray ? TextureFormat::r8 : TextureFormat::srgb8_alpha8,
                         .size_px = {pixels.width, pixels.height},
                         .levels = 0,
                         .wrap_u = WrapMode::repeat,
                         .wrap_v = WrapMode::repeat,
                         .filter = FilterMode::trilinear});
        const std::vector<std::uint8_t> texels = texels_of(pixels);
        made.upload(0, std::as_bytes(std::span(texels)));
        made.make_levels();
        texture = std::move(made);
    }
    const bool is_gray = texture.desc().format == TextureFormat::r8;
    return {texture.id(), texture.desc().size_px, is_gray ? PixelFormat::r8 : PixelFormat::rgba8};
}

}  // namespace hw
