#include "hatchway/render/products/shared_images.hpp"

#include <algorithm>

#include "hatchway/render/lines/line_drawer.hpp"

namespace hw {
namespace {

constexpr int kMaxImageDepth = 16;

TextureFormat format_of(const std::string& name)
{
    return name == kNormalDepthImage ? TextureFormat::rgba32f : TextureFormat::rgba8;
}

const char* fragment_of(const std::string& name)
{
    if (name == kNormalDepthImage) return "images/image_normal_depth.frag";
    return name == kObjectIdsImage ? "images/image_object_ids.frag" : "images/image_triangle_ids.frag";
}

glm::vec4 object_id_bytes(ObjectId object, int style)
{
    const std::uint32_t id = object + 1;
    return glm::vec4(id & 255u, (id >> 8) & 255u, (id >> 16) & 255u, static_cast<std::uint32_t>(style + 1) & 255u) /
           255.0f;
}

SurfaceFeatures image_features(const GpuMesh& mesh, const GpuMaterial& material)
{
    return mask_features(mesh, material) | (material.features & surface_feature::kDoubleSided);
}

void draw_object(const std::string& name, const EngineImageInput& input, const VisibleObject& object,
                 GpuScene& gpu_scene, ProgramStore& programs, GpuState& state)
{
    const Object& facts = input.scene->objects[object.object];
    const Material& material = input.scene->materials[facts.material];
    const bool is_loose = name == kTriangleIdsImage;
    const GpuMesh& mesh = is_loose ? gpu_scene.loose_mesh(facts.mesh) : gpu_scene.mesh(facts.mesh);
    const GpuMaterial& gpu_material = gpu_scene.material(facts.material);
    const LinkedProgram& program =
        programs.engine(is_loose ? "images/image_triangle_ids.vert" : "surface.vert", fragment_of(name),
                        is_loose ? "" : feature_defines(image_features(mesh, gpu_material)));
    state.use(program.gpu);
    state.apply({.depth_test = DepthTest::less,
                 .culling = material.is_double_sided ? Culling::off : Culling::back,
                 .is_front_clockwise = object.facing < 0.0f});
    const SurfaceLocations& at = program.at;
    GpuProgram::set(at.clip_from_object, object.clip_from_object);
    GpuProgram::set(at.relative_from_object, object.relative_from_object);
    GpuProgram::set(at.normal_from_object, object.normal_from_object);
    GpuProgram::set(at.base_colour_factor, material.base_colour);
    GpuProgram::set(at.material_factors, glm::vec4(0.0f, 0.0f, material.alpha_cutoff, 0.0f));
    GpuProgram::set(at.base_colour_uv, material.base_colour_texture.uv_transform);
    state.bind_texture(at.unit_base_colour, gpu_material.base_colour);
    const int style = input.looks[object.object].style;
    GpuProgram::set(program.gpu.location("hw_object_id"), object_id_bytes(object.object, style));
    if (is_loose)
        GpuProgram::set(program.gpu.location("hw_first_triangle"),
                        static_cast<int>(input.first_triangle[object.object]));
    state.bind(is_loose ? mesh.loose_array : mesh.array);
    const std::span ranges(input.visible->ranges);
    for (const IndexRange& range : ranges.subspan(object.first_range, object.range_count)) {
        if (is_loose)
            state.draw(Primitive::triangles, range.first, range.count);
        else
            state.draw_indexed(Primitive::triangles, range.first, range.count);
    }
}

}  // namespace

bool is_engine_image(const std::string& name)
{
    return name == kNormalDepthImage || name == kObjectIdsImage || name == kTriangleIdsImage;
}

Image draw_engine_image(const std::string& name, const EngineImageInput& input, GpuScene& gpu_scene,
                        ProgramStore& programs, GpuState& state, TargetPool& pool)
{
    GpuTarget& target = pool.take({.size_px = input.view->size_px, .colours = {format_of(name)}});
    target.bind();
    state.apply({});
    target.clear(glm::vec4(0.0f));
    for (const VisibleObject& object : input.visible->objects) {
        const Object& facts = input.scene->objects[object.object];
        if (input.looks[object.object].style == kNone) continue;
        if (input.scene->materials[facts.material].alpha_mode == AlphaMode::blend) continue;
        draw_object(name, input, object, gpu_scene, programs, state);
    }
    return {target.colour().id(), input.view->size_px};
}

std::vector<ImageKey> in_order_of_need(const std::set<ImageKey>& wanted,
                                       const std::function<const Needs*(const ImageKey&)>& needs_of)
{
    std::vector<ImageKey> order;
    const std::function<void(const ImageKey&, int)> visit = [&](const ImageKey& key, int depth) {
        if (depth > kMaxImageDepth || std::find(order.begin(), order.end(), key) != order.end()) return;
        if (const Needs* needs = needs_of(key))
            for (const ImageKey& before : needs->images) visit(before, depth + 1);
        order.push_back(key);
    };
    for (const ImageKey& key : wanted) visit(key, 0);
    return order;
}

}  // namespace hw
