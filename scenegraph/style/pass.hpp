#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "hatchway/style/draw_item.hpp"
#include "hatchway/style/line_look.hpp"
#include "hatchway/style/needs.hpp"
#include "hatchway/style/program_cache.hpp"
#include "hatchway/style/view.hpp"

namespace hw {

/// A texture of this frame, owned by the host. Invalid when the image was not in the style's needs.
struct Image {
    std::uint32_t id = 0;
    glm::ivec2 size_px{0};
    bool is_valid() const { return id != 0; }
};

/// What a program is given beside what the host sets by itself (view, lights, material, maps, presence).
class Uniforms {
 public:
    using Value = std::variant<float, int, glm::vec2, glm::vec3, glm::vec4, Image>;
    struct Entry {
        std::string name;
        Value value;
    };

    Uniforms& set(std::string name, Value value)
    {
        entries_.push_back({std::move(name), std::move(value)});
        return *this;
    }
    const std::vector<Entry>& entries() const { return entries_; }

 private:
    std::vector<Entry> entries_;
};

enum class PixelFormat : std::uint8_t { r8, rg8, rgba8, rgba16f, r32f, rgba32f };

/// A transient target. Its memory is reused between frames, its content never.
struct TargetDesc {
    PixelFormat format = PixelFormat::rgba8;
    float scale = 1.0f;  ///< Of the view's size.
    bool has_depth = true;
    glm::vec4 clear{0.0f};
};

/// The only way to draw. The host owns targets, depth, polygon offset, clipping, presence and blending. Nothing throws;
/// an invalid program or image draws nothing and is logged once.
class Pass {
 public:
    virtual ~Pass() = default;

    virtual const View& view() const = 0;
    /// Which faces are being drawn: surfaces() and lines() are called once for each layer that has some.
    virtual Layer layer() const = 0;
    /// An image that the style's needs name.
    virtual Image image(const ImageKey& key) const = 0;
    /// Draws items' faces into a transient target, cleared first.
    virtual Image render(const TargetDesc& target, Program program, const Uniforms& uniforms, Items items) = 0;
    /// A full-screen pass into a transient target.
    virtual Image filter(const TargetDesc& target, Program program, const Uniforms& uniforms) = 0;
    /// Draws items' faces into the picture.
    virtual void surfaces(Program program, const Uniforms& uniforms, Items items) = 0;
    /// Draws items' lines into the picture, hidden parts removed by depth. None, unless the style's needs name edges.
    virtual void lines(const LineLook& look, Items items) = 0;
};

}  // namespace hw
