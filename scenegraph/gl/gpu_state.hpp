#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "hatchway/gl/gpu_buffer.hpp"
#include "hatchway/gl/gpu_program.hpp"

namespace hw {

enum class DepthTest : std::uint8_t { off, less, less_equal, equal };
enum class Blending : std::uint8_t { off, over };  ///< over: source alpha, one minus source alpha.
enum class Culling : std::uint8_t { off, back };
enum class Primitive : std::uint8_t { triangles, lines, points };

/// All fixed-function state that the engine uses. The default is what a style may rely on.
struct PipelineState {
    DepthTest depth_test = DepthTest::less;
    bool writes_depth = true;
    bool writes_colour = true;
    Blending blending = Blending::off;
    Culling culling = Culling::back;
    bool is_front_clockwise = false;
    float offset_factor = 0.0f;  ///< Polygon offset of faces.
    float offset_units = 0.0f;
    float line_width_px = 1.0f;
    bool is_multisampled = true;
    bool takes_once = false;  ///< A sample is left to the first that gets there, by the stencil.

    bool operator==(const PipelineState&) const = default;
};

/// A part of a target, from its lower left corner.
struct PixelRect {
    glm::ivec2 min{0};
    glm::ivec2 size{0};
};

/// Counts of what reached the device.
struct GpuCounters {
    int state_changes = 0;
    int program_switches = 0;
    int texture_binds = 0;
    int draw_calls = 0;
    std::uint64_t triangles = 0;
    std::uint64_t lines = 0;
};

/// What the context is set to. Sends differences only; everything that draws goes through it.
class GpuState {
 public:
    /// Sets everything without looking: after foreign code used the context.
    void forget();
    /// Off for a window, which stores what it is given; on by default. ES knows no windows here.
    void set_srgb_targets(bool is_on);
    /// Nothing is drawn, cleared or resolved outside of it. None: the whole target.
    void set_scissor(const std::optional<PixelRect>& rect);
    void apply(const PipelineState& state);
    void use(const GpuProgram& program);
    void bind(const GpuVertexArray& array);
    /// `texture` is an id; the program's sampler tells the unit. Units below 0 are ignored.
    void bind_texture(int unit, std::uint32_t texture);

    void draw(Primitive primitive, std::uint32_t first, std::uint32_t count);
    /// Indices are 32-bit; the bound vertex array has them.
    void draw_indexed(Primitive primitive, std::uint32_t first, std::uint32_t count);

    const GpuCounters& counters() const { return counters_; }
    void reset_counters() { counters_ = {}; }

 private:
    void count(Primitive primitive, std::uint32_t vertices);

    PipelineState state_;
    bool is_known_ = false;
    std::uint32_t program_ = 0;
    std::uint32_t vertex_array_ = 0;
    std::array<std::uint32_t, 15> textures_{};
    GpuCounters counters_;
};

/// Waits until the device has done everything.
void finish_device();

}  // namespace hw
