#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "hatchway/core/pixels.hpp"
#include "hatchway/gl/gpu_texture.hpp"

namespace hw {

/// One colour attachment. Filter and wrap are those of its texture.
struct TargetColour {
    TextureFormat format = TextureFormat::rgba8;
    FilterMode filter = FilterMode::nearest;
    WrapMode wrap = WrapMode::clamp;
    bool operator==(const TargetColour&) const = default;
};

struct GpuTargetDesc {
    glm::ivec2 size_px{1};
    std::vector<TargetColour> colours;  ///< Empty: depth alone.
    bool has_depth = true;              ///< With stencil.
    bool is_shadow_map = false;         ///< Depth is a texture with comparison, no stencil, no colours.
    int samples = 1;                    ///< Over 1: colours cannot be sampled, only resolved.
    bool has_depth_texture = false;     ///< Of one sample: shaders read depth by a sampler2D.
};

/// A framebuffer with its own attachments. Move-only.
class GpuTarget {
 public:
    GpuTarget() = default;
    /// Throws hw::Error, Fault::device, when the device cannot draw into these formats.
    explicit GpuTarget(const GpuTargetDesc& desc);
    ~GpuTarget();
    GpuTarget(GpuTarget&& other) noexcept;
    GpuTarget& operator=(GpuTarget&& other) noexcept;

    /// Draws go here from now on, over the whole target.
    void bind() const;
    /// Needs bind(). Colour and depth masks must be open.
    void clear(const glm::vec4& colour) const;
    /// Whole numbers are cleared to those at and below `colour`.
    void clear_colour(int attachment, const glm::vec4& colour) const;
    void clear_depth() const;
    /// Averages the samples of the first colour into `to`, which has the same size and format.
    void resolve_into(const GpuTarget& to) const;
    /// Copies the first colour to the window's framebuffer, scaled to `size_px`.
    void show_in_window(glm::ivec2 size_px) const;
    /// The first colour as stored, RGB, top row first. Not for multisampled targets.
    Pixels read_rgb() const;
    /// One pixel of the first colour, which does not hold whole numbers, as floats; `from_top` counts rows from the
    /// top.
    glm::vec4 read_pixel(int x, int from_top) const;

    const GpuTexture& colour(int attachment = 0) const { return colours_[attachment]; }
    const GpuTexture& depth() const { return depth_; }
    const GpuTargetDesc& desc() const { return desc_; }
    bool is_empty() const { return id_ == 0; }

 private:
    void attach_textures();
    void attach_multisampled();

    GpuTargetDesc desc_;
    std::uint32_t id_ = 0;
    std::vector<GpuTexture> colours_;
    GpuTexture depth_;
    std::vector<std::uint32_t> renderbuffers_;
};

/// The bits of a texture of floats, or of whole numbers, four a pixel; the first row is at v = 0.
std::vector<glm::uvec4> read_texture(std::uint32_t texture, glm::ivec2 size_px, bool is_whole_number);

/// Draws go to the window's own framebuffer from now on.
void bind_window(glm::ivec2 size_px);

}  // namespace hw
