// What docs/write_a_style.md promises of the fields that shaders read. Each is a condition in GLSL that holds at the
// middle of a picture.
#include <gmock/gmock.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/style/scripted_style.hpp"

namespace hw::test {
namespace {

/// A square of 2 units in its xy plane, which looks along z.
MeshData square()
{
    MeshData mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// One with every stream: uv0 is (0.25, 0.75) in its middle, uv1 (2, 3).
MeshData full_square()
{
    MeshData mesh = square();
    mesh.uv0 = {{0, 1}, {0.5, 1}, {0.5, 0.5}, {0, 0.5}};
    mesh.uv1.assign(4, glm::vec2(2, 3));
    mesh.colours.assign(4, glm::vec4(0.5f, 1.0f, 0.5f, 1.0f));
    return mesh;
}

struct Condition {
    const char* name;
    const char* glsl;
};

class fields : public RendererTest {
 protected:
    /// Whether the condition holds for `HwSurface s`, `HwMaterial m` and its direct light in the middle of the picture.
    bool holds(const Condition& condition, const View& view)
    {
        const Program program = shaders_.surface(
            std::string("#include \"surface.glsl\"\n#include \"shadow.glsl\"\n#include \"lighting.glsl\"\n"
                        "void main() { HwSurface s = hw_surface(); HwMaterial m = hw_material(s);\n"
                        "vec3 to_light; vec3 direct = hw_direct(s, s.normal_world, to_light);\n"
                        "hw_output(") +
            condition.glsl + " ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), 1.0); }\n");
        style_.draws_surfaces = [&](Pass& pass, Items items) { pass.surfaces(program, {}, items); };
        load({{"only", &style_}}, std::vector<StyledObject>(scene_.objects.size(), look_));
        const Pixels pixels = draw(view, {.samples = 1});
        return pixels.at(view.size_px.x / 2, view.size_px.y / 2)[1] == 255;
    }
    void expect_all(std::span<const Condition> conditions, const View& view)
    {
        for (const Condition& condition : conditions) EXPECT_TRUE(holds(condition, view)) << condition.name;
    }

    ShaderFolder shaders_{*renderer_};
    ScriptedStyle style_;
    StyledObject look_{.style = 0, .certainty = 0.25f};
};

TEST_F(fields, of_a_surface_tell_where_it_is)
{
    const glm::dmat4 world = glm::scale(glm::translate(glm::dmat4(1.0), {1, 2, 3}), glm::dvec3(2.0));
    add_object(scene_, full_square(), world, painted(glm::vec3(1.0f)));
    View view = camera_view({{1, 2, 9}, {1, 2, 3}, 60.0}, {320, 240}, scene_.bounds_world, 2.0f);
    view.time_s = 1.5;
    style_.needed.clock = true;
    constexpr Condition kConditions[]{
        {"position_world", "distance(s.position_world, vec3(1.0, 2.0, 3.0)) < 0.03"},
        {"position_object", "length(s.position_object) < 0.015"},
        {"normal_world", "distance(s.normal_world, vec3(0.0, 0.0, 1.0)) < 1e-3"},
        {"normal_object", "distance(s.normal_object, vec3(0.0, 0.0, 1.0)) < 1e-3"},
        {"face_normal_world", "distance(s.face_normal_world, vec3(0.0, 0.0, 1.0)) < 1e-3"},
        {"uv0", "distance(s.uv0, vec2(0.25, 0.75)) < 0.01"},
        {"uv1", "distance(s.uv1, vec2(2.0, 3.0)) < 1e-4"},
        {"hatch_uv_dx", "distance(s.hatch_uv_dx, dFdx(s.hatch_uv)) < 1e-6 && s.hatch_uv_dx.x > 0.0"},
        {"map_uv in metres", "abs(s.map_uv_dx.x - dFdx(s.position_world.x)) < 1e-3 * s.map_uv_dx.x"},
        {"map_uv_dy", "distance(s.map_uv_dy, dFdy(s.map_uv)) < 1e-6 && s.map_uv_dy.y < 0.0"},
        {"direction_world that nobody asked for", "s.direction_world == vec3(0.0)"},
        {"colour", "distance(s.colour, vec4(0.5, 1.0, 0.5, 1.0)) < 1e-3"},
        {"to_eye_world", "distance(s.to_eye_world, vec3(0.0, 0.0, 1.0)) < 0.01"},
        {"distance_m", "abs(s.distance_m - 6.0) < 0.01"},
        {"object_id", "s.object_id == 1u"},
        {"triangle_id that nobody asked for", "s.triangle_id == 0u"},
        {"hw_presence", "hw_presence(s) == 1.0"},
        {"hw_certainty", "hw_certainty == 0.25"},
        {"hw_px_scale", "hw_px_scale == 2.0"},
        {"hw_size_px", "hw_size_px == vec2(320.0, 240.0)"},
        {"hw_time_s", "hw_time_s == 1.5"},
        {"hw_eye_world", "distance(hw_eye_world, vec3(1.0, 2.0, 9.0)) < 1e-4"},
        {"hw_share_at", "hw_share_at(vec4(0.5, 0.0, 2.0, 1.0), 1.0) == 0.25"},
        {"hw_shadow that nobody asked for", "hw_shadow(s) == 1.0"},
        {"hw_ramp of no ramp", "hw_ramp(0.25) == vec3(0.25)"},
        {"hw_image of no image", "hw_image(s) == vec3(1.0)"}};
    expect_all(kConditions, view);
    EXPECT_FALSE(holds({"the test can fail", "s.distance_m < 5.0"}, view));
    EXPECT_EQ(stats_.shadow_maps_drawn, 0);
}

TEST_F(fields, of_a_mesh_without_streams_are_0_and_its_colour_is_1)
{
    add_object(scene_, square(), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    constexpr Condition kConditions[]{{"uv0", "s.uv0 == vec2(0.0) && s.uv1 == vec2(0.0)"},
                                      {"colour", "s.colour == vec4(1.0)"}};
    expect_all(kConditions, view_from({0, 0, 4}, {0, 0, 0}));
}

TEST_F(fields, of_streams_come_with_the_need)
{
    add_object(scene_, square(), glm::dmat4(1.0), painted(glm::vec3(1.0f)));
    add_object(scene_, square(), glm::translate(glm::dmat4(1.0), {0, 0, -1}), painted(glm::vec3(1.0f)));
    style_.needed.streams = {
        .hatch_uv = true, .direction = true, .hatch_source = HatchSource::box, .triangle_id = true};
    constexpr Condition kConditions[]{
        {"triangle_id", "s.triangle_id == 1u || s.triangle_id == 2u"},
        {"direction_world", "abs(length(s.direction_world) - 1.0) < 1e-3 && abs(s.direction_world.z) < 1e-3"},
        {"hatch_uv in metres", "abs(length(s.hatch_uv_dx) - length(dFdx(s.position_world))) < 1e-5"},
        {"direction along u",
         "dot(s.direction_world, dFdx(s.position_world)) * s.hatch_uv_dx.x > 0.0 || "
         "s.hatch_uv_dx.x == 0.0"}};
    expect_all(kConditions, view_from({0, 0, 4}, {0, 0, 0}));
}

TEST_F(fields, of_a_double_sided_surface_look_at_the_eye)
{
    Material sheet = painted(glm::vec3(1.0f));
    sheet.is_double_sided = true;
    add_object(scene_, square(), glm::dmat4(1.0), sheet);
    constexpr Condition kBehind[]{{"normal_world", "s.normal_world.z < -0.99"},
                                  {"face_normal_world", "s.face_normal_world.z < -0.99"},
                                  {"material", "m.normal_world.z < -0.99"}};
    expect_all(kBehind, view_from({0, 0, -4}, {0, 0, 0}));
}

TEST_F(fields, of_a_material_are_those_of_the_model)
{
    Material material;
    material.base_colour = {0.5f, 0.25f, 1.0f, 0.125f};
    material.metallic = 0.25f;
    material.roughness = 0.75f;
    material.emissive = {1.0f, 2.0f, 3.0f};
    add_object(scene_, full_square(), glm::dmat4(1.0), material);
    const View view = view_from({0, 0, 4}, {0, 0, 0});
    constexpr Condition kConditions[]{
        {"base_colour times the vertex's", "distance(m.base_colour, vec3(0.25, 0.25, 0.5)) < 1e-3"},
        {"alpha of what is opaque", "m.alpha == 1.0"},
        {"metallic, roughness", "m.metallic == 0.25 && m.roughness == 0.75"},
        {"emissive", "distance(m.emissive, vec3(1.0, 2.0, 3.0)) < 1e-4"},
        {"occlusion", "m.occlusion == 1.0"},
        {"normal_world", "distance(m.normal_world, vec3(0.0, 0.0, 1.0)) < 1e-3"}};
    expect_all(kConditions, view);
    scene_.materials[0].alpha_mode = AlphaMode::blend;
    EXPECT_TRUE(holds({"alpha of what is blended", "m.alpha == 0.125"}, view));
}

TEST_F(fields, of_a_textured_material_have_its_textures)
{
    scene_.images = {Pixels{.width = 1, .height = 1, .channels = 4, .bytes = {188, 255, 0, 255}},
                     Pixels{.width = 1, .height = 1, .channels = 4, .bytes = {51, 128, 204, 255}},
                     Pixels{.width = 1, .height = 1, .channels = 4, .bytes = {255, 128, 128, 255}}};
    scene_.textures = {{.image = 0}, {.image = 1}, {.image = 2}};
    Material material;
    material.base_colour_texture.texture = material.emissive_texture.texture = 0;
    material.metallic_roughness_texture.texture = material.occlusion_texture.texture = 1;
    material.normal_texture.texture = 2;
    material.emissive = {2.0f, 2.0f, 2.0f};
    MeshData mesh = full_square();
    mesh.colours.clear();
    add_object(scene_, mesh, glm::dmat4(1.0), material);
    constexpr Condition kConditions[]{
        {"base_colour is sRGB", "distance(m.base_colour, vec3(0.503, 1.0, 0.0)) < 0.01"},
        {"emissive is sRGB", "distance(m.emissive, vec3(1.006, 2.0, 0.0)) < 0.02"},
        {"metallic is blue, roughness green", "abs(m.metallic - 0.8) < 0.01 && abs(m.roughness - 0.502) < 0.01"},
        {"occlusion is red", "abs(m.occlusion - 0.2) < 0.01"},
        {"normal_world leans where the map says", "m.normal_world.x > 0.98"}};
    expect_all(kConditions, view_from({0, 0, 4}, {0, 0, 0}));
}

TEST_F(fields, of_light_are_lux_and_a_tone)
{
    Light sun;
    sun.type = LightType::sun;
    sun.intensity = 1000.0f;
    sun.direction_world = glm::normalize(glm::dvec3(0, -1, -1));
    input_.lights = {sun};
    add_object(scene_, square(), glm::dmat4(1.0), painted(glm::vec3(0.5f)));
    constexpr Condition kConditions[]{
        {"hw_direct in lux", "abs(direct.g - 707.1) < 1.0"},
        {"to_light", "distance(to_light, vec3(0.0, 0.7071, 0.7071)) < 1e-3"},
        {"hw_light_tone", "hw_light_tone(s, s.normal_world) > 0.0 && hw_light_tone(s, s.normal_world) <= 1.0"},
        {"hw_light_tone of what turns away",
         "hw_light_tone(s, vec3(0.0, -1.0, 0.0)) < 0.5 * hw_light_tone(s, s.normal_world)"},
        {"hw_lit", "hw_lit(s, m).r > 0.0"},
        {"hw_ambient", "hw_ambient(vec3(0.0, 1.0, 0.0)).g > hw_ambient(vec3(0.0, -1.0, 0.0)).g"},
        {"hw_surroundings", "hw_surroundings(vec3(0.0, 1.0, 0.0), 0.1).b > 0.0"},
        {"hw_display", "hw_display(vec3(1e9)).r <= 1.0 && hw_display(vec3(0.0)) == vec3(0.0)"}};
    expect_all(kConditions, view_from({0, 0, 4}, {0, 0, 0}));
}

}  // namespace
}  // namespace hw::test
