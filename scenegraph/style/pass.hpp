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
#include "hatchway/style/target.hpp"
#include "hatchway/style/view.hpp"

namespace hw {

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

/// Depths along the view, metres.
struct DepthRange {
    float near_m = 0.0f;
    float far_m = 1.0f;
};

/// The only way to draw. The host owns targets, depth, polygon offset, clipping, presence and blending. Nothing throws.
/// A pass with an invalid program, or with one that was made for something else, draws nothing and gives invalid
/// images. An invalid image is sampled as (0, 0, 0, 1). Uniforms that a program does not have are ignored.
class Pass {
 public:
    virtual ~Pass() = default;

    virtual const View& view() const = 0;
    /// Which faces are being drawn: surfaces() and lines() are called once for each layer that has some.
    virtual Layer layer() const = 0;
    /// All visible opaque and masked objects of the view, whatever their style, near before far: for images in which
    /// what hides an item appears, too.
    virtual Items opaque_scene() const = 0;
    /// An image that the needs name, and which of its outputs; invalid when they do not name it, or nobody made it.
    virtual Image image(const ImageKey& key, std::size_t output = 0) const = 0;
    /// Where along the view all objects lie whose style needs that image, itself or by another image: before the eye,
    /// as tight as their bounds. Depends on the level and the view, never on what is visible.
    virtual DepthRange depth_range(const ImageKey& key) const = 0;
    /// Draws items' faces into transient targets, cleared first; depth first, so that every pixel is shaded once.
    virtual Images render(const TargetDesc& target, Program program, const Uniforms& uniforms, Items items) = 0;
    /// A full-screen pass into transient targets. TargetDesc::depth is ignored.
    virtual Images filter(const TargetDesc& target, Program program, const Uniforms& uniforms) = 0;
    /// Draws items' faces into the picture.
    virtual void surfaces(Program program, const Uniforms& uniforms, Items items) = 0;
    /// Draws items' lines into the picture with the engine's pen, hidden parts removed by depth. None, unless the
    /// style's needs name edges.
    virtual void lines(const LineLook& look, Items items) = 0;
    /// The same with a pen of the style's own (ProgramCache::line): it gives each fragment of the lines its colour and
    /// coverage. Widths, stray and thinning are the look's.
    virtual void lines(Program pen, const Uniforms& uniforms, const LineLook& look, Items items) = 0;
    /// A full-screen pass laid over the picture by its alpha, where lines are drawn: in Style::lines() alone.
    virtual void cover(Program program, const Uniforms& uniforms) = 0;
};

}  // namespace hw
