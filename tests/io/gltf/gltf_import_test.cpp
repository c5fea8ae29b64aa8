#include "hatchway/io/gltf/import.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <set>

#include "hatchway/io/images/images.hpp"
#include "hatchway/io/images/png.hpp"
#include "tests/io/expect_error.hpp"
#include "tests/io/gltf/model_builder.hpp"
#include "tests/shared_data.hpp"
#include "tests/temporary_folder.hpp"

namespace {

hw::Scene import_model(const ModelBuilder& builder)
{
    const TemporaryFolder folder;
    return hw::import_gltf(folder.write("model.glb", builder.glb()), folder.path());
}

std::string png_text(int red)
{
    const hw::Pixels pixels{.width = 1, .height = 1, .channels = 3, .bytes = {static_cast<std::uint8_t>(red), 0, 0}};
    const std::vector<std::byte> png = hw::encode_png(pixels);
    return {reinterpret_cast<const char*>(png.data()), png.size()};
}

/// A quad of two triangles with texture coordinates as exporters write them: v grows downwards.
ModelBuilder textured_quad()
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int uv = builder.add_accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, 5126, "VEC2", 2);
    const int indices = builder.add_indices({0, 1, 2, 0, 2, 3});
    auto& primitive = builder.add_object({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}});
    primitive["indices"] = indices;
    primitive["material"] = 0;
    const std::string png = png_text(255);
    const int view = builder.add_view(std::vector<char>(png.begin(), png.end()));
    builder.push("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    builder.push("textures", {{"source", 0}});
    builder.push("materials", {{"name", "Stone"}, {"normalTexture", {{"index", 0}}}});
    return builder;
}

/// A .glb with its tangents taken out and a normal map put in, so that the importer makes them anew.
std::string without_tangents(const std::string& glb)
{
    std::uint32_t json_size = 0;
    std::memcpy(&json_size, glb.data() + 12, 4);
    ModelBuilder builder;
    builder.json = nlohmann::json::parse(glb.substr(20, json_size));
    builder.binary = glb.substr(20 + json_size + 8);
    for (auto& primitive : builder.json["meshes"][0]["primitives"]) {
        primitive["attributes"].erase("TANGENT");
        primitive["material"] = 0;
    }
    const std::string png = png_text(128);
    builder.push("images", {{"bufferView", builder.add_view(std::vector<char>(png.begin(), png.end()))}});
    builder.json["textures"] = {{{"source", builder.json["images"].size() - 1}}};
    builder.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    return builder.glb();
}

}  // namespace

TEST(gltf_import, a_triangle_without_normals_gets_a_flat_one)
{
    const hw::Scene scene = import_model(triangle_model());
    ASSERT_EQ(scene.objects.size(), 1u);
    const hw::MeshData& mesh = scene.meshes[0];
    EXPECT_FALSE(mesh.has_own_normals);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.bounds_world.max, glm::dvec3(1, 1, 0));
    EXPECT_EQ(scene.materials[scene.objects[0].material].base_colour, glm::vec4(1));
}

TEST(gltf_import, flat_normals_take_vertices_of_their_own)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    builder.add_object({{"POSITION", positions}})["indices"] = builder.add_indices({0, 1, 2, 0, 2, 3});
    const hw::MeshData mesh = import_model(builder).meshes[0];
    EXPECT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[3], glm::vec3(1, 0, 0));
}

TEST(gltf_import, a_triangle_of_1e_20_metres_still_has_a_normal)
{
    ModelBuilder builder;
    builder.add_object({{"POSITION", builder.add_positions({0, 0, 0, 1e-20f, 0, 0, 0, 1e-20f, 0})}});
    EXPECT_EQ(import_model(builder).meshes[0].normals[0], glm::vec3(0, 0, 1));
}

TEST(gltf_import, nodes_are_reordered_so_that_parents_stand_first)
{
    ModelBuilder builder = triangle_model();
    builder.json["nodes"] = {{{"name", "leaf"}, {"mesh", 0}, {"translation", {1, 0, 0}}},
                             {{"name", "root"}, {"children", {2}}, {"translation", {10, 0, 0}}},
                             {{"children", {0}}, {"scale", {2, 2, 2}}},
                             {{"name", "stray"}, {"mesh", 0}}};
    builder.json["scenes"] = {{{"nodes", {1}}}};
    const hw::Scene scene = import_model(builder);
    ASSERT_EQ(scene.nodes.size(), 3u) << "nodes outside of the scene are dropped";
    EXPECT_EQ(scene.nodes[0].path, "root");
    EXPECT_EQ(scene.nodes[1].path, "root/#1") << "unnamed nodes are called by their index";
    EXPECT_EQ(scene.nodes[2].path, "root/#1/leaf");
    EXPECT_EQ(scene.nodes[2].parent, 1);
    EXPECT_EQ(glm::dvec3(scene.nodes[2].world_from_node[3]), glm::dvec3(12, 0, 0));
}

TEST(gltf_import, the_default_scene_is_shown)
{
    ModelBuilder builder = triangle_model();
    builder.json["nodes"] = {{{"name", "a"}, {"mesh", 0}}, {{"name", "b"}, {"mesh", 0}}};
    builder.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    builder.json["scene"] = 1;
    const hw::Scene scene = import_model(builder);
    ASSERT_EQ(scene.nodes.size(), 1u);
    EXPECT_EQ(scene.nodes[0].name, "b");
}

TEST(gltf_import, instances_share_their_mesh)
{
    ModelBuilder builder = triangle_model();
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}});
    builder.json["scenes"] = {{{"nodes", {0, 1}}}};
    const hw::Scene scene = import_model(builder);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(hw::drawn_triangle_count(scene), 2u);
}

TEST(gltf_import, strips_keep_their_winding_and_lose_their_seams)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    auto& primitive = builder.add_object({{"POSITION", positions}, {"NORMAL", normals}});
    primitive["mode"] = 5;
    primitive["indices"] = builder.add_indices({0, 1, 2, 3, 3, 4});
    const hw::MeshData mesh = import_model(builder).meshes[0];
    ASSERT_EQ(mesh.triangle_count(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::vec3 a = mesh.positions[mesh.indices[3 * i]];
        const glm::vec3 b = mesh.positions[mesh.indices[3 * i + 1]];
        const glm::vec3 c = mesh.positions[mesh.indices[3 * i + 2]];
        EXPECT_GT(glm::cross(b - a, c - a).z, 0.0f);
    }
}

TEST(gltf_import, a_fan_turns_around_its_first_vertex)
{
    ModelBuilder builder;
    builder.add_object({{"POSITION", builder.add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})}})["mode"] = 6;
    const hw::MeshData mesh = import_model(builder).meshes[0];
    ASSERT_EQ(mesh.triangle_count(), 2u);
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(gltf_import, lines_and_points_are_left_out)
{
    ModelBuilder builder = triangle_model();
    const int positions = builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    for (const int mode : {0, 1, 2, 3})
        builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
    EXPECT_EQ(import_model(builder).objects.size(), 1u);
}

TEST(gltf_import, vertices_that_no_triangle_uses_are_dropped)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({9, 9, 9, 0, 0, 0, 1, 0, 0, 9, 9, 9, 0, 1, 0});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    builder.add_object({{"POSITION", positions}, {"NORMAL", normals}})["indices"] = builder.add_indices({1, 2, 4});
    const hw::Scene scene = import_model(builder);
    EXPECT_EQ(scene.meshes[0].positions.size(), 3u);
    EXPECT_EQ(scene.bounds_world.max, glm::dvec3(1, 1, 0));
}

TEST(gltf_import, bad_normals_become_zero_and_long_ones_unit)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = builder.add_positions({0, 0, 0, std::nanf(""), 0, 1, 0, 0, 25});
    builder.add_object({{"POSITION", positions}, {"NORMAL", normals}});
    const hw::MeshData mesh = import_model(builder).meshes[0];
    EXPECT_TRUE(mesh.has_own_normals);
    EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}));
}

TEST(gltf_import, positions_that_are_not_finite_are_refused)
{
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY, 1e16f}) {
        ModelBuilder builder;
        builder.add_object({{"POSITION", builder.add_positions({0, 0, 0, 1, bad, 0, 0, 1, 0})}});
        const auto parts = error_of([&] { import_model(builder); });
        EXPECT_EQ(parts.pointer, "/meshes/0/primitives/0/attributes/POSITION");
    }
}

TEST(gltf_import, quantised_positions_are_scaled_by_their_node)
{
    ModelBuilder builder;
    const int view = builder.add_view(std::vector<std::int16_t>{0, 0, 0, 0, 32767, 0, 0, 0, 0, 32767, 0, 0});
    builder.json["bufferViews"][view]["byteStride"] = 8;
    const int positions = builder.add_accessor_of_view(view, 5122, "VEC3", 3);
    builder.json["accessors"][positions]["normalized"] = true;
    const int uv = builder.add_accessor<std::uint8_t>({0, 0, 255, 0, 0, 255}, 5121, "VEC2", 2);
    builder.json["accessors"][uv]["normalized"] = true;
    builder.add_object({{"POSITION", positions}, {"TEXCOORD_0", uv}});
    builder.json["nodes"][0]["scale"] = {4, 4, 4};
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const hw::Scene scene = import_model(builder);
    EXPECT_EQ(scene.bounds_world.max, glm::dvec3(4, 4, 0));
    EXPECT_EQ(scene.meshes[0].uv0[1], glm::vec2(1, 0));
}

TEST(gltf_import, quantised_whole_numbers_mean_themselves)
{
    ModelBuilder builder;
    const int view = builder.add_view(std::vector<std::uint8_t>{0, 0, 0, 0, 200, 0, 0, 0, 0, 200, 0, 0});
    builder.json["bufferViews"][view]["byteStride"] = 4;
    builder.add_object({{"POSITION", builder.add_accessor_of_view(view, 5121, "VEC3", 3)}});
    EXPECT_EQ(import_model(builder).bounds_world.max, glm::dvec3(200, 200, 0));
}

TEST(gltf_import, sparse_accessors_override_their_base)
{
    ModelBuilder builder = triangle_model();
    const int indices = builder.add_view(std::vector<std::uint16_t>{1});
    const int values = builder.add_view(std::vector<float>{7, 0, 0});
    builder.json["accessors"][0]["sparse"] = {{"count", 1},
                                              {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                              {"values", {{"bufferView", values}}}};
    EXPECT_EQ(import_model(builder).bounds_world.max, glm::dvec3(7, 1, 0));
}

TEST(gltf_import, sparse_accessors_without_a_base_start_from_zero)
{
    ModelBuilder builder = triangle_model();
    const int indices = builder.add_view(std::vector<std::uint8_t>{1, 2});
    const int values = builder.add_view(std::vector<float>{1, 0, 0, 0, 3, 0});
    builder.json["accessors"][0].erase("bufferView");
    builder.json["accessors"][0]["sparse"] = {{"count", 2},
                                              {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                              {"values", {{"bufferView", values}}}};
    EXPECT_EQ(import_model(builder).bounds_world.max, glm::dvec3(1, 3, 0));
}

TEST(gltf_import, sparse_indices_out_of_range_or_order_are_refused)
{
    for (const auto& bad : {std::vector<std::uint16_t>{0, 3}, {1, 1}, {2, 1}}) {
        ModelBuilder builder = triangle_model();
        const int indices = builder.add_view(bad);
        const int values = builder.add_view(std::vector<float>(6, 0.0f));
        builder.json["accessors"][0]["sparse"] = {{"count", 2},
                                                  {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                                  {"values", {{"bufferView", values}}}};
        EXPECT_EQ(error_of([&] { import_model(builder); }).pointer, "/accessors/0/sparse/indices");
    }
}

TEST(gltf_import, interleaved_attributes_are_read_by_their_stride)
{
    ModelBuilder builder;
    const int view =
        builder.add_view(std::vector<float>{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1});  // position, normal
    builder.json["bufferViews"][view]["byteStride"] = 24;
    const int positions = builder.add_accessor_of_view(view, 5126, "VEC3", 3);
    const int normals = builder.add_accessor_of_view(view, 5126, "VEC3", 3);
    builder.json["accessors"][normals]["byteOffset"] = 12;
    builder.add_object({{"POSITION", positions}, {"NORMAL", normals}});
    const hw::MeshData mesh = import_model(builder).meshes[0];
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
}

TEST(gltf_import, a_texture_transform_scales_turns_and_moves)
{
    ModelBuilder builder = textured_quad();
    builder.json["materials"][0]["normalTexture"]["extensions"] = {
        {"KHR_texture_transform",
         {{"offset", {0.5, 0.25}}, {"rotation", 1.5707963267948966}, {"scale", {2, 4}}, {"texCoord", 1}}}};
    const hw::Scene scene = import_model(builder);
    const hw::TextureUse& use = scene.materials[0].normal_texture;
    EXPECT_EQ(use.uv_set, 1);
    // The extension's rotation is counter-clockwise for v downwards: (1, 0) goes to (0, -1).
    const glm::vec3 moved = use.uv_transform * glm::vec3(1, 0, 1);
    EXPECT_NEAR(moved.x, 0.5, 1e-6);
    EXPECT_NEAR(moved.y, 0.25 - 2.0, 1e-6);
    const glm::vec3 other = use.uv_transform * glm::vec3(0, 1, 1);
    EXPECT_NEAR(other.x, 0.5 + 4.0, 1e-6);
    EXPECT_NEAR(other.y, 0.25, 1e-6);
}

TEST(gltf_import, tangents_follow_u_and_bitangents_the_image_upwards)
{
    const hw::MeshData mesh = import_model(textured_quad()).meshes[0];
    ASSERT_EQ(mesh.tangents.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(mesh.tangents[i].x, 1.0f, 1e-6f);
        const glm::vec3 bitangent = mesh.tangents[i].w * glm::cross(mesh.normals[i], glm::vec3(mesh.tangents[i]));
        EXPECT_NEAR(bitangent.y, 1.0f, 1e-6f);
    }
}

TEST(gltf_import, the_seam_of_a_mirrored_texture_gets_two_vertices)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({-1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int uv = builder.add_accessor<float>({0, 1, 1, 1, 1, 0, 0, 1}, 5126, "VEC2", 2);
    const int indices = builder.add_indices({0, 1, 2, 1, 3, 2});
    ModelBuilder quad = textured_quad();
    auto& primitive = builder.add_object({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}});
    primitive["indices"] = indices;
    primitive["material"] = 0;
    const std::string png = png_text(9);
    builder.push("images", {{"bufferView", builder.add_view(std::vector<char>(png.begin(), png.end()))},
                            {"mimeType", "image/png"}});
    builder.json["textures"] = quad.json["textures"];
    builder.json["materials"] = quad.json["materials"];
    const hw::MeshData mesh = import_model(builder).meshes[0];
    ASSERT_EQ(mesh.positions.size(), 6u);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        EXPECT_EQ(mesh.tangents[mesh.indices[corner]], glm::vec4(1, 0, 0, 1));
        EXPECT_EQ(mesh.tangents[mesh.indices[3 + corner]], glm::vec4(-1, 0, 0, -1));
    }
}

TEST(gltf_import, made_tangents_agree_with_those_that_an_exporter_made)
{
    const std::filesystem::path file = hw::test::kSharedData / "scenes" / "japanese_temple.glb";
    HATCHWAY_NEEDS_DATA(std::filesystem::exists(file), file);
    const hw::MeshData stated = hw::import_gltf(file, file.parent_path()).meshes[0];
    ASSERT_FALSE(stated.tangents.empty());

    const TemporaryFolder folder;
    const auto copy = folder.write("temple.glb", without_tangents(hw::read_text_file(file, 1 << 30)));
    const hw::MeshData made = hw::import_gltf(copy, folder.path()).meshes[0];
    ASSERT_GE(made.tangents.size(), stated.tangents.size());
    std::size_t close = 0;
    for (std::size_t i = 0; i < stated.tangents.size(); ++i)
        close += glm::dot(glm::vec3(made.tangents[i]), glm::vec3(stated.tangents[i])) > 0.9f;
    // Directions only: that file's signs mean an image that is upside down. Rules for weighting a vertex's triangles
    // differ, so a few per cent may lie apart.
    EXPECT_GT(close, stated.tangents.size() * 95 / 100);
}

TEST(gltf_import, materials_keep_all_that_gltf_says)
{
    ModelBuilder builder = textured_quad();
    builder.push("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    builder.json["textures"][0]["sampler"] = 0;
    builder.json["materials"][0] = {{"name", "Glass"},
                                    {"pbrMetallicRoughness",
                                     {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                                      {"baseColorTexture", {{"index", 0}}},
                                      {"metallicFactor", 0.25},
                                      {"roughnessFactor", 0.75},
                                      {"metallicRoughnessTexture", {{"index", 0}}}}},
                                    {"occlusionTexture", {{"index", 0}, {"strength", 0.5}}},
                                    {"emissiveTexture", {{"index", 0}}},
                                    {"emissiveFactor", {1, 0.5, 0}},
                                    {"alphaMode", "MASK"},
                                    {"alphaCutoff", 0.3},
                                    {"doubleSided", true},
                                    {"extensions",
                                     {{"KHR_materials_unlit", nlohmann::json::object()},
                                      {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}};
    const hw::Scene scene = import_model(builder);
    const hw::Material& material = scene.materials[0];
    EXPECT_EQ(material.name, "Glass");
    EXPECT_EQ(material.base_colour, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallic, 0.25f);
    EXPECT_EQ(material.roughness, 0.75f);
    EXPECT_EQ(material.occlusion_strength, 0.5f);
    EXPECT_EQ(material.emissive, glm::vec3(4, 2, 0));
    EXPECT_EQ(material.alpha_mode, hw::AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.3f);
    EXPECT_TRUE(material.is_double_sided);
    EXPECT_TRUE(material.is_unlit);
    ASSERT_EQ(scene.textures.size(), 1u) << "a texture that is used four times is one texture";
    EXPECT_EQ(scene.textures[0].wrap_u, hw::TextureWrap::clamp);
    EXPECT_EQ(scene.textures[0].wrap_v, hw::TextureWrap::mirrored_repeat);
    EXPECT_TRUE(scene.textures[0].is_nearest);
    EXPECT_EQ(scene.images[scene.textures[0].image].bytes[0], 255);
}

TEST(gltf_import, lights_stand_in_the_world)
{
    ModelBuilder builder = triangle_model();
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 1000}},
        {{"type", "spot"},
         {"color", {1, 0, 0}},
         {"range", 9},
         {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}};
    // A quarter turn about x: -z becomes y.
    builder.json["nodes"][0]["rotation"] = {0.7071067811865476, 0, 0, 0.7071067811865476};
    builder.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    builder.json["nodes"].push_back(
        {{"translation", {1, 2, 3}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    builder.json["scenes"][0]["nodes"].push_back(1);
    const hw::Scene scene = import_model(builder);
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].type, hw::LightType::sun);
    EXPECT_EQ(scene.lights[0].intensity, 1000.0f);
    EXPECT_NEAR(scene.lights[0].direction_world.y, 1.0, 1e-12);
    EXPECT_EQ(scene.lights[1].type, hw::LightType::spot);
    EXPECT_EQ(scene.lights[1].position_world, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.lights[1].colour, glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.lights[1].range_m, 9.0f);
    EXPECT_EQ(scene.lights[1].outer_cone_rad, 0.2f);
}

TEST(gltf_import, cameras_have_names_of_their_own)
{
    ModelBuilder builder = triangle_model();
    builder.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
    for (int i = 1; i <= 2; ++i) {
        builder.json["nodes"].push_back({{"camera", 0}, {"name", "door"}, {"translation", {i, 0, 0}}});
        builder.json["scenes"][0]["nodes"].push_back(i);
    }
    const hw::Scene scene = import_model(builder);
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].name, "door");
    EXPECT_EQ(scene.cameras[1].name, "door_2");
    EXPECT_EQ(scene.cameras[1].eye_world, glm::dvec3(2, 0, 0));
    EXPECT_EQ(scene.cameras[1].target_world, glm::dvec3(2, 0, -1));
    EXPECT_NEAR(scene.cameras[0].fov_deg, 57.29578, 1e-4);
}

TEST(gltf_import, extras_name_a_style_and_a_certainty)
{
    ModelBuilder builder = triangle_model();
    builder.json["nodes"][0]["extras"] = {{"hatchway", {{"style", "assumed"}, {"certainty", 0.25}}}};
    EXPECT_EQ(import_model(builder).nodes[0].style, "assumed");
    EXPECT_EQ(import_model(builder).nodes[0].certainty, 0.25f);
    builder.json["nodes"][0]["extras"] = {{"hatchway.style", "found"}};
    EXPECT_EQ(import_model(builder).nodes[0].style, "found") << "a custom property of Blender is flat";
    EXPECT_TRUE(import_model(builder).doubts.empty());
}

TEST(gltf_import, a_plain_custom_property_certainty_is_read_as_a_number_or_a_text)
{
    ModelBuilder builder = triangle_model();
    const auto certainty_of = [&](const nlohmann::json& extras) {
        builder.json["nodes"][0]["extras"] = extras;
        const hw::Scene scene = import_model(builder);
        EXPECT_TRUE(scene.doubts.empty()) << extras;
        return scene.nodes[0].certainty;
    };
    EXPECT_EQ(certainty_of({{"certainty", 0.25}}), 0.25f);
    EXPECT_EQ(certainty_of({{"certainty", " 0.25 "}}), 0.25f);
    EXPECT_EQ(certainty_of({{"certainty", 0.25}, {"hatchway.certainty", 0.5}}), 0.5f);
    EXPECT_EQ(certainty_of({{"certainty", 0.25}, {"hatchway", {{"certainty", "0.75"}}}}), 0.75f);
    EXPECT_FALSE(certainty_of({{"Certainty", 0.25}, {"colour", "red"}}).has_value()) << "others' properties";
}

TEST(gltf_import, what_extras_say_in_vain_is_named_once_for_each_kind_and_refuses_nothing)
{
    const std::vector<std::pair<nlohmann::json, std::string>> cases{
        {{{"certainty", "high"}}, "/nodes/0/extras/certainty: the text \"high\""},
        {{{"certainty", "nan"}}, "/nodes/0/extras/certainty"},
        {{{"certainty", true}}, "/nodes/0/extras/certainty"},
        {{{"certainty", 80}}, "/nodes/0/extras/certainty: the number 80"},
        {{{"hatchway", {{"certainty", 2}}}}, "/nodes/0/extras/hatchway/certainty"},
        {{{"hatchway", {{"stlye", "ink"}}}}, "\"stlye\""},
        {{{"hatchway.stlye", "ink"}}, "\"stlye\""},
        {{{"hatchway", {{"style", 3}}}}, "/nodes/0/extras/hatchway/style"},
        {{{"hatchway", "ink"}}, "/nodes/0/extras/hatchway"}};
    for (const auto& [extras, told] : cases) {
        ModelBuilder builder = triangle_model();
        builder.json["nodes"][0]["extras"] = extras;
        builder.push("nodes", builder.json["nodes"][0]);
        builder.json["scenes"][0]["nodes"] = {0, 1};
        const hw::Scene scene = import_model(builder);
        ASSERT_EQ(scene.doubts.size(), 1u) << extras;
        EXPECT_NE(scene.doubts[0].find(told), std::string::npos) << scene.doubts[0];
        EXPECT_NE(scene.doubts[0].find("1 more"), std::string::npos) << scene.doubts[0];
        EXPECT_FALSE(scene.nodes[0].style.has_value());
    }
}

TEST(gltf_import, what_an_animation_moves_is_animated_with_its_children)
{
    ModelBuilder builder = triangle_model();
    builder.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}, {{"mesh", 0}}};
    builder.json["scenes"] = {{{"nodes", {0, 2}}}};
    const int times = builder.add_accessor<float>({0.0f}, 5126, "SCALAR", 1);
    const int places = builder.add_positions({0, 0, 0});
    builder.push("animations", {{"samplers", {{{"input", times}, {"output", places}}}},
                                {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
    const hw::Scene scene = import_model(builder);
    EXPECT_TRUE(scene.nodes[0].is_animated);
    EXPECT_TRUE(scene.nodes[1].is_animated);
    EXPECT_FALSE(scene.nodes[2].is_animated);
}

TEST(gltf_import, gpu_instances_become_nodes)
{
    ModelBuilder builder = triangle_model();
    const int places = builder.add_positions({0, 0, 0, 10, 0, 0, 20, 0, 0});
    builder.json["nodes"][0]["name"] = "tree";
    builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = places;
    builder.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const hw::Scene scene = import_model(builder);
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(scene.nodes[scene.objects[2].node].path, "tree/instance_2");
    EXPECT_EQ(scene.bounds_world.max, glm::dvec3(21, 1, 0));
}

TEST(gltf_import, edges_that_the_artist_marked_are_kept)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int indices = builder.add_indices({0, 1, 2, 0, 2, 3});
    // Edges 0-1, 1-2, 2-0 and 0-2, 2-3, 3-0: drawn, hidden, drawn; repeated, silhouette, hidden.
    const int visibility = builder.add_accessor<std::uint8_t>({0b11'10'00'10, 0b00'01}, 5121, "SCALAR", 1);
    auto& primitive = builder.add_object({{"POSITION", positions}, {"NORMAL", normals}});
    primitive["indices"] = indices;
    primitive["extensions"]["EXT_mesh_primitive_edge_visibility"]["visibility"] = visibility;
    EXPECT_EQ(import_model(builder).meshes[0].artist_edges, (std::vector<std::uint32_t>{0, 1, 2, 0}));
}

TEST(gltf_import, files_beside_the_model_are_read)
{
    const TemporaryFolder folder;
    ModelBuilder builder = textured_quad();
    builder.json["buffers"] = {{{"uri", "my%20data.bin"}, {"byteLength", builder.binary.size()}}};
    builder.json["images"] = {{{"uri", "textures/red.png"}}};
    folder.write("my data.bin", builder.binary);
    folder.write("textures/red.png", png_text(200));
    const auto file = folder.write("model.gltf", builder.json.dump());
    const hw::Scene scene = hw::import_gltf(file, folder.path());
    EXPECT_EQ(scene.images.at(0).bytes[0], 200);
}

TEST(gltf_import, data_uris_are_read)
{
    const TemporaryFolder folder;
    ModelBuilder builder;
    // 36 bytes: the triangle (0,0,0) (1,0,0) (0,1,0)
    builder.json["buffers"] = {
        {{"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"},
         {"byteLength", 36}}};
    builder.push("bufferViews", {{"buffer", 0}, {"byteLength", 36}});
    builder.add_object({{"POSITION", builder.add_accessor_of_view(0, 5126, "VEC3", 3)}});
    const auto file = folder.write("model.gltf", builder.json.dump());
    EXPECT_EQ(hw::import_gltf(file, folder.path()).bounds_world.max, glm::dvec3(1, 1, 0));
}

TEST(gltf_import, images_of_materials_that_nothing_uses_are_not_opened)
{
    ModelBuilder builder = triangle_model();
    builder.push("images", {{"uri", "missing.png"}});
    builder.push("textures", {{"source", 0}});
    builder.push("materials", {{"normalTexture", {{"index", 0}}}});
    EXPECT_EQ(import_model(builder).images.size(), 0u);
    builder.json["meshes"][0]["primitives"][0]["material"] = 0;
    EXPECT_EQ(error_of([&] { import_model(builder); }).pointer, "/images/0/uri");
}

TEST(gltf_import, every_model_of_the_shared_data_opens)
{
    const std::filesystem::path data = hw::test::kSharedData;
    HATCHWAY_NEEDS_DATA(std::filesystem::exists(data), data);
    for (const char* folder : {"scenes", "models", "hard"})
        for (const auto& entry : std::filesystem::directory_iterator(data / folder)) {
            if (entry.path().extension() != ".glb") continue;
            const hw::Scene scene = hw::import_gltf(entry.path(), entry.path().parent_path());
            EXPECT_GT(hw::drawn_triangle_count(scene), 0u) << entry.path();
            EXPECT_FALSE(scene.bounds_world.is_empty()) << entry.path();
        }
}

TEST(gltf_import, an_orthographic_camera_stays_one)
{
    ModelBuilder builder = triangle_model();
    builder.push("cameras", {{"type", "orthographic"},
                             {"orthographic", {{"xmag", 4}, {"ymag", 3}, {"znear", 0.1}, {"zfar", 1000}}}});
    builder.push("cameras", {{"type", "orthographic"},
                             {"orthographic", {{"xmag", 1}, {"ymag", -0.25}, {"znear", 0}, {"zfar", 10}}}});
    for (int i = 0; i < 2; ++i) {
        builder.json["nodes"].push_back({{"camera", i}, {"name", "plan"}, {"translation", {0, 5, 0}}});
        builder.json["scenes"][0]["nodes"].push_back(i + 1);
    }
    const hw::Scene scene = import_model(builder);
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].orthographic_height_m, 6.0);
    EXPECT_EQ(scene.cameras[1].orthographic_height_m, 0.5);
}

TEST(gltf_import, a_camera_without_height_is_left_out_and_told)
{
    for (const double ymag : {0.0, 1e-9}) {
        ModelBuilder builder = triangle_model();
        builder.push("cameras", {{"type", "orthographic"},
                                 {"orthographic", {{"xmag", 4}, {"ymag", ymag}, {"znear", 0.1}, {"zfar", 1000}}}});
        builder.json["nodes"].push_back({{"camera", 0}, {"name", "plan"}});
        builder.json["scenes"][0]["nodes"].push_back(1);
        const hw::Scene scene = import_model(builder);
        EXPECT_TRUE(scene.cameras.empty()) << ymag;
        ASSERT_EQ(scene.doubts.size(), 1u);
        EXPECT_THAT(scene.doubts[0], testing::HasSubstr("/cameras/0: the camera \"plan\" is left out"));
    }
}

TEST(gltf_import, a_camera_is_turned_about_its_line_of_sight_as_its_node_is)
{
    struct Case {
        std::vector<double> rotation;
        double roll_deg;
    };
    const double half = std::sqrt(0.5);
    const double s = std::sin(0.2617993878), c = std::cos(0.2617993878);
    const Case cases[] = {
        {{0, 0, 0, 1}, 0.0},          {{0, half, 0, half}, 0.0},  // to the left
        {{-half, 0, 0, half}, 0.0},                               // straight down, -z up
        {{half, 0, 0, half}, 0.0},                                // straight up
        {{0, 0, s, c}, 30.0},                                     // its top leans to its left, which is -x
        {{0, 0, -half, half}, -90.0},                             // a portrait
        {{0, 0, 1, 0}, 180.0},        {{-half * c, half * s, half * s, half * c}, 30.0}};  // straight down
    for (const Case& each : cases) {
        ModelBuilder builder = triangle_model();
        builder.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}});
        builder.json["nodes"].push_back({{"camera", 0}, {"name", "plan"}, {"rotation", each.rotation}});
        builder.json["scenes"][0]["nodes"].push_back(1);
        const hw::Scene scene = import_model(builder);
        ASSERT_EQ(scene.cameras.size(), 1u);
        EXPECT_NEAR(scene.cameras[0].roll_deg, each.roll_deg, 1e-4);
        EXPECT_TRUE(scene.doubts.empty());
    }
}

namespace {

/// A model of one triangle whose data lies in a file of its own; the triangle's data.
std::string model_with_buffer(const std::string& uri)
{
    const ModelBuilder builder = triangle_model();
    nlohmann::json json = builder.json;
    json["buffers"] = {{{"byteLength", builder.binary.size()}, {"uri", uri}}};
    return json.dump();
}

}  // namespace

TEST(gltf_import, a_percent_sign_that_no_two_digits_follow_stands_for_itself)
{
    struct Case {
        const char* uri;
        const char* file;
    };
    const Case cases[] = {{"example 10%.bin", "example 10%.bin"},
                          {"a%zz.bin", "a%zz.bin"},
                          {"a%2", "a%2"},
                          {"%", "%"},
                          {"%%41", "%A"},
                          {"a%20b.bin", "a b.bin"},
                          {"100%25.bin", "100%.bin"},
                          {"sub%2Fx.bin", "sub/x.bin"},
                          {"%e4.bin", "\xe4.bin"},
                          {"x%2.bin", "x%2.bin"},
                          {"50%g0", "50%g0"}};
    for (const Case& c : cases) {
        const TemporaryFolder folder;
        std::filesystem::create_directory(folder.path() / "sub");
        folder.write(c.file, triangle_model().binary);
        const auto file = folder.write("model.gltf", model_with_buffer(c.uri));
        EXPECT_EQ(hw::import_gltf(file, folder.path()).objects.size(), 1u) << c.uri;
    }
}

TEST(gltf_import, a_file_that_is_missing_is_called_missing)
{
    for (const char* uri : {"gone.bin", "./gone.bin", "sub dir/gone%20x.bin", "gone%", "a/../gone.bin"}) {
        const TemporaryFolder folder;
        const auto file = folder.write("model.gltf", model_with_buffer(uri));
        const hw::ErrorParts parts = error_of([&] { hw::import_gltf(file, folder.path()); });
        EXPECT_NE(parts.what.find("there is no file"), std::string::npos) << parts.what;
        EXPECT_EQ(parts.pointer, "/buffers/0/uri");
    }
    ModelBuilder builder = textured_quad();
    builder.json["images"] = {{{"uri", "gone.png"}}};
    const hw::ErrorParts parts = error_of([&] { import_model(builder); });
    EXPECT_NE(parts.what.find("there is no file \"gone.png\""), std::string::npos) << parts.what;
    const TemporaryFolder folder;
    const auto outside = folder.write("model.gltf", model_with_buffer("%2e%2e/%2e%2e/gone.bin"));
    EXPECT_NE(error_of([&] { hw::import_gltf(outside, folder.path()); }).what.find("leaves the project"),
              std::string::npos);
}
