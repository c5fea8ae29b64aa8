#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace hw {

/// Shaders sample whole numbers (r32ui, rg32ui, rgba32ui) by usampler2D and write them to an output of type uint, uvec2
/// or uvec4; all others by sampler2D. On OpenGL ES float formats need EXT_color_buffer_float: without it a pass into
/// them makes nothing, which is logged once.
enum class PixelFormat : std::uint8_t { r8, rg8, rgba8, rgba16f, r32f, rgba32f, r32ui, rg32ui, rgba32ui };

inline bool is_whole_number(PixelFormat format)
{
    return format >= PixelFormat::r32ui;
}

/// How texture() samples. r32f, rgba32f and whole numbers are always sampled nearest: devices need not filter them.
enum class PixelFilter : std::uint8_t { linear, nearest };
/// What is beyond an image's edge.
enum class PixelWrap : std::uint8_t { clamp, repeat, mirrored_repeat };

/// One image that a pass fills.
struct TargetOutput {
    PixelFormat format = PixelFormat::rgba8;
    PixelFilter filter = PixelFilter::linear;
    PixelWrap wrap = PixelWrap::clamp;
    glm::vec4 clear{0.0f};  ///< What is in it before the pass; of whole numbers those at and below.
};

/// What hides the items of Pass::render().
enum class TargetDepth : std::uint8_t {
    none,   ///< Nothing: items lie upon each other in their order.
    own,    ///< The items each other, by depth.
    scene,  ///< All opaque and masked objects that are visible, whatever their style, as in the picture.
};

/// Transient targets. Their memory is reused between frames, their content never: it lives as long as the frame. One
/// sample a pixel, nothing is blended.
struct TargetDesc {
    /// One to kMaxTargetOutputs: those at location 0, 1, ... of the fragment stage.
    std::vector<TargetOutput> outputs{TargetOutput{}};
    float scale = 1.0f;                    ///< Of the view's size, clamped to [0.01, 4]; the size is rounded up.
    TargetDepth depth = TargetDepth::own;  ///< Pass::filter() has no depth.
};

inline constexpr std::size_t kMaxTargetOutputs = 4;

/// A texture, owned by the host: of this frame, or one of the style's own (ProgramCache::texture). An invalid one is
/// sampled as (0, 0, 0, 1).
struct Image {
    std::uint32_t id = 0;
    glm::ivec2 size_px{0};
    PixelFormat format = PixelFormat::rgba8;
    bool is_valid() const { return id != 0; }
};

/// What a pass has filled, one image for each of TargetDesc::outputs. Beyond these, and where the pass drew nothing,
/// images are invalid.
class Images {
 public:
    void add(const Image& image)
    {
        if (count_ < kMaxTargetOutputs) images_[count_++] = image;
    }
    Image operator[](std::size_t output) const { return output < count_ ? images_[output] : Image(); }
    std::size_t size() const { return count_; }

 private:
    std::array<Image, kMaxTargetOutputs> images_{};
    std::size_t count_ = 0;
};

}  // namespace hw
