#include "hatchway/render/products/shadow_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/core/log.hpp"
#include "hatchway/render/device/surface_drawer.hpp"
#include "hatchway/render/view/covered_pixels.hpp"

namespace hw {
namespace {

// The map's own offset is small: receivers step off their surface along the normal (shaders/shadow.glsl).
constexpr PipelineState kCasterState{.depth_test = DepthTest::less,
                                     .writes_colour = false,
                                     .culling = Culling::off,
                                     .offset_factor = 1.0f,
                                     .offset_units = 1.0f};

/// Every opaque or masked object, whole, as the light sees it.
VisibleSet casters_of(const Scene& scene, std::span<const std::uint8_t> left_out, const GpuScene& gpu_scene,
                      const glm::dmat4& clip_from_world)
{
    VisibleSet casters;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        if (!left_out.empty() && left_out[id] != 0) continue;
        if (gpu_scene.material_of(id).facts->alpha_mode == AlphaMode::blend) continue;
        VisibleObject caster;
        caster.object = id;
        caster.clip_from_object = glm::mat4(clip_from_world * scene.world_from_object(id));
        caster.first_range = static_cast<std::uint32_t>(casters.ranges.size());
        caster.range_count = 1;
        casters.objects.push_back(caster);
        casters.ranges.push_back({0, gpu_scene.mesh_of(id).index_count});
    }
    return casters;
}

/// A side at which the casters cover no more texels than a software renderer draws in some seconds.
int drawable_side(const Scene& scene, const VisibleSet& casters, int side_px)
{
    constexpr double kMostTexels = 2e9;
    constexpr int kLeastSidePx = 16;
    double texels = 0.0;
    for (const VisibleObject& caster : casters.objects)
        texels += covered_pixels(scene.meshes[scene.objects[caster.object].mesh],
                                 std::span(casters.ranges).subspan(caster.first_range, caster.range_count),
                                 caster.clip_from_object, 0.0f, glm::ivec2(side_px));
    int side = side_px;
    for (; texels > kMostTexels && side > kLeastSidePx; side /= 2) texels /= 4.0;
    if (side < side_px)
        log_warning(
            fmt::format("faces lie over each other so often that shadows are drawn with {} x {} texels, not {} x "
                        "{}",
                        side, side, side_px, side_px));
    return side;
}

bool is_same(const Box& a, const Box& b)
{
    return a.min == b.min && a.max == b.max;
}

}  // namespace

glm::dmat4 sun_clip_from_world(const glm::dvec3& direction_world, const Box& bounds_world)
{
    const glm::dvec3 direction = glm::normalize(direction_world);
    const glm::dvec3 up = std::abs(direction.y) > 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 middle = bounds_world.centre();
    const glm::dmat4 light_from_world = glm::lookAt(middle, middle + direction, up);
    const Box in_light = transformed(bounds_world, light_from_world);
    const glm::dvec3 margin = glm::max(in_light.size() * 0.002, glm::dvec3(1e-9));
    const glm::dvec3 low = in_light.min - margin;
    const glm::dvec3 high = in_light.max + margin;
    return glm::ortho(low.x, high.x, low.y, high.y, -high.z, -low.z) * light_from_world;
}

void ShadowMap::prepare(const Scene& scene, const glm::dvec3& eye_world, std::span<const std::uint8_t> left_out,
                        GpuScene& gpu_scene, const SceneLight& light, ProgramStore& programs, GpuState& state,
                        int side_px)
{
    if (light.main_light == kNone || scene.bounds_world.is_empty()) return;
    if (!places_) places_ = find_places(scene);
    const Box place_world = place_around(*places_, eye_world);
    if (frame_.is_drawn && wanted_side_px_ == side_px && is_same(place_world_, place_world)) return;
    place_world_ = place_world;
    const glm::dmat4 clip_from_world = sun_clip_from_world(light.lights[light.main_light].direction_world, place_world);
    const VisibleSet casters = casters_of(scene, left_out, gpu_scene, clip_from_world);
    wanted_side_px_ = side_px;
    side_px = drawable_side(scene, casters, side_px);
    target_ = GpuTarget({.size_px = glm::ivec2(side_px), .colours = {}, .is_shadow_map = true});
    target_.bind();
    state.apply(kCasterState);
    target_.clear_depth();
    std::vector<SurfaceItem> items;
    for (const VisibleObject& caster : casters.objects) items.push_back({nullptr, &caster, {}});
    SurfaceDrawer(programs, state, gpu_scene).draw_depth(kCasterState, items, casters.ranges);
    const glm::dmat4 unit_from_clip =
        glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5));
    frame_.is_drawn = true;
    frame_.shadow_from_world = unit_from_clip * clip_from_world;
    frame_.size_px = side_px;
    const double widest =
        std::min(glm::length(glm::dvec3(clip_from_world[0][0], clip_from_world[1][0], clip_from_world[2][0])),
                 glm::length(glm::dvec3(clip_from_world[0][1], clip_from_world[1][1], clip_from_world[2][1])));
    frame_.texel_m = static_cast<float>(2.0 / (widest * side_px));
    ++drawn_count_;
}

}  // namespace hw
