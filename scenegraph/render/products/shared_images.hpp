#pragma once

#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>

#include "hatchway/render/device/gpu_scene.hpp"
#include "hatchway/render/device/surface_drawer.hpp"
#include "hatchway/render/device/target_pool.hpp"
#include "hatchway/render/view/scene_input.hpp"
#include "hatchway/render/view/visible_set.hpp"

namespace hw {

/// The engine's own images. Each covers all visible faces but blended ones, whatever their style, one sample a pixel.
inline constexpr const char* kNormalDepthImage =
    "normal_depth";                                           ///< rgba32f: unit normal (world), distance; 0 is empty.
inline constexpr const char* kObjectIdsImage = "object_ids";  ///< rgba8: object + 1 in rgb, low first; a style + 1.
inline constexpr const char* kTriangleIdsImage =
    "triangle_ids";  ///< rgba8: 32-bit number of the triangle + 1; 0 empty.

bool is_engine_image(const std::string& name);

/// What drawing an engine image takes.
struct EngineImageInput {
    const View* view = nullptr;
    const VisibleSet* visible = nullptr;
    const Scene* scene = nullptr;
    std::span<const StyledObject> looks;
    std::span<const std::uint32_t> first_triangle;  ///< Of each object, in the numbering of triangle ids.
};

/// Draws one of the engine's images into a target of the pool.
Image draw_engine_image(const std::string& name, const EngineImageInput& input, GpuScene& gpu_scene,
                        ProgramStore& programs, GpuState& state, TargetPool& pool);

/// The keys of an image pass and, before it, of all that it reads itself.
std::vector<ImageKey> in_order_of_need(const std::set<ImageKey>& wanted,
                                       const std::function<const Needs*(const ImageKey&)>& needs_of);

}  // namespace hw
