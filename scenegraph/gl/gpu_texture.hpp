#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

namespace hw {

enum class TextureFormat : std::uint8_t {
    r8,
    rg8,
    rgba8,
    srgb8_alpha8,
    rgba16f,
    r32f,
    rgba32f,
    r32ui,
    rg32ui,
    rgba32ui,
    depth24_stencil8,
    depth24,  ///< Sampled with comparison: a shadow map.
};

enum class WrapMode : std::uint8_t { repeat, mirrored_repeat, clamp };
enum class FilterMode : std::uint8_t {
    nearest,
    linear,
    linear_in_level,  ///< Of the nearest level: half the work of trilinear.
    trilinear,
};

struct TextureDesc {
    TextureFormat format = TextureFormat::rgba8;
    glm::ivec2 size_px{1};
    int levels = 1;  ///< 0: as many as there can be.
    WrapMode wrap_u = WrapMode::clamp;
    WrapMode wrap_v = WrapMode::clamp;
    FilterMode filter = FilterMode::linear;
    bool is_magnified_nearest = false;
};

/// Holds whole numbers, which are neither filtered nor blended.
bool is_whole_number(TextureFormat format);

/// How many levels a full chain has, down to 1 x 1.
int full_level_count(glm::ivec2 size_px);

/// A two-dimensional texture. Move-only.
class GpuTexture {
 public:
    GpuTexture() = default;
    /// Content undefined. Throws hw::Error when the size is over the device's limit.
    explicit GpuTexture(const TextureDesc& desc);
    ~GpuTexture();
    GpuTexture(GpuTexture&& other) noexcept;
    GpuTexture& operator=(GpuTexture&& other) noexcept;

    /// Fills one level: rows of the format's own layout without padding; the first row is at v = 0.
    void upload(int level, std::span<const std::byte> bytes);
    /// Fills the levels above 0 by averaging, in linear light for sRGB formats.
    void make_levels();

    std::uint32_t id() const { return id_; }
    const TextureDesc& desc() const { return desc_; }

 private:
    std::uint32_t id_ = 0;
    TextureDesc desc_;
};

}  // namespace hw
