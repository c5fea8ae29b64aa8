#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string_view>

#include "hatchway/core/pixels.hpp"
#include "hatchway/gl/gpu_texture.hpp"
#include "hatchway/style/target.hpp"

namespace hw {

/// Decodes an image file within the host's limits. Throws hw::Error for what is missing, damaged or too large.
using ImageReader = std::function<Pixels(const std::filesystem::path&)>;

/// Textures that styles bring along, each file once.
class TextureStore {
 public:
    /// Without a reader every texture is refused.
    explicit TextureStore(ImageReader read) : read_(std::move(read)) {}

    /// See ProgramCache::texture(). `folder` is the style's.
    Image texture(const std::filesystem::path& folder, std::string_view file);

 private:
    ImageReader read_;
    std::map<std::filesystem::path, GpuTexture> textures_;
};

}  // namespace hw
