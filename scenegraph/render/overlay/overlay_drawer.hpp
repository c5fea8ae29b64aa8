#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/gl/gpu_state.hpp"
#include "hatchway/gl/gpu_texture.hpp"
#include "hatchway/render/device/program_store.hpp"
#include "hatchway/render/view/overlay.hpp"

namespace hw {

/// What a target does with the colours that it is given.
enum class TargetColours : std::uint8_t {
    linear,     ///< Takes linear light and stores sRGB.
    as_stored,  ///< Stores them as they are: a window, whose bytes are sRGB.
};

/// Draws overlays into the bound target.
class OverlayDrawer {
 public:
    OverlayDrawer(ProgramStore& programs, GpuState& state);
    void draw(const Overlay& overlay, glm::ivec2 size_px, float px_scale, TargetColours colours);

 private:
    struct Vertex {
        glm::vec3 position;  ///< Pixels from the top left corner; z unused.
        glm::vec2 texel;     ///< Of the atlas.
        glm::vec4 colour;    ///< As the target takes it.
    };
    struct Rectangle {
        glm::vec2 min_px, max_px;
        glm::vec2 min_texel, max_texel;
    };

    glm::vec4 target_colour(const glm::vec4& srgb) const;
    void add_rectangle(const Rectangle& rectangle, const glm::vec4& colour);
    void add_filled(glm::vec2 min_px, glm::vec2 max_px, const glm::vec4& colour);
    void add_text(const OverlayText& text, glm::ivec2 size_px, float px_scale);
    void add_line(const OverlayLine& line, float px_scale);
    void add_cross_hair(glm::ivec2 size_px, float px_scale);

    ProgramStore& programs_;
    GpuState& state_;
    GpuTexture atlas_;
    GpuBuffer buffer_;
    GpuVertexArray array_;
    std::vector<Vertex> vertices_;
    TargetColours colours_ = TargetColours::linear;
};

}  // namespace hw
