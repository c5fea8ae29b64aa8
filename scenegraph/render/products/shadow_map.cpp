#include "hatchway/render/products/shadow_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "hatchway/render/device/surface_drawer.hpp"

namespace hw {
namespace {

constexpr int kShadowMapSide = 4096;

// The map's own offset is small: receivers step off their surface along the normal (shaders/shadow.glsl).
constexpr PipelineState kCasterState{.depth_test = DepthTest::less,
                                     .writes_colour = false,
                                     .culling = Culling::off,
                                     .offset_factor = 1.0f,
                                     .offset_units = 1.0f};

void draw_caster(const Scene& scene, GpuScene& gpu_scene, ObjectId id, const glm::dmat4& clip_from_world,
                 const LinkedProgram& program, GpuState& state)
{
    const Object& object = scene.objects[id];
    const Material& material = scene.materials[object.material];
    const GpuMesh& mesh = gpu_scene.mesh(object.mesh);
    state.use(program.gpu);
    state.bind(mesh.array);
    GpuProgram::set(program.at.clip_from_object, glm::mat4(clip_from_world * scene.world_from_object(id)));
    GpuProgram::set(program.at.base_colour_factor, material.base_colour);
    GpuProgram::set(program.at.material_factors, glm::vec4(0.0f, 0.0f, material.alpha_cutoff, 0.0f));
    GpuProgram::set(program.at.base_colour_uv, material.base_colour_texture.uv_transform);
    state.bind_texture(program.at.unit_base_colour, gpu_scene.material(object.material).base_colour);
    state.draw_indexed(Primitive::triangles, 0, mesh.index_count);
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

void ShadowMap::prepare(const Scene& scene, GpuScene& gpu_scene, const SceneLight& light, ProgramStore& programs,
                        GpuState& state)
{
    if (frame_.is_drawn || light.main_light == kNone || scene.bounds_world.is_empty()) return;
    const glm::dmat4 clip_from_world =
        sun_clip_from_world(light.lights[light.main_light].direction_world, scene.bounds_world);
    target_ = GpuTarget({.size_px = glm::ivec2(kShadowMapSide), .colours = {}, .is_shadow_map = true});
    target_.bind();
    state.apply(kCasterState);
    target_.clear_depth();
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        if (scene.materials[object.material].alpha_mode == AlphaMode::blend) continue;
        const SurfaceFeatures features =
            mask_features(gpu_scene.mesh(object.mesh), gpu_scene.material(object.material));
        const LinkedProgram& program = programs.engine("surface.vert", "depth.frag", feature_defines(features));
        draw_caster(scene, gpu_scene, id, clip_from_world, program, state);
    }
    const glm::dmat4 unit_from_clip =
        glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.5));
    frame_.is_drawn = true;
    frame_.shadow_from_world = glm::mat4(unit_from_clip * clip_from_world);
    frame_.size_px = kShadowMapSide;
    const double widest =
        std::min(glm::length(glm::dvec3(clip_from_world[0][0], clip_from_world[1][0], clip_from_world[2][0])),
                 glm::length(glm::dvec3(clip_from_world[0][1], clip_from_world[1][1], clip_from_world[2][1])));
    frame_.texel_m = static_cast<float>(2.0 / (widest * kShadowMapSide));
    ++drawn_count_;
}

}  // namespace hw
