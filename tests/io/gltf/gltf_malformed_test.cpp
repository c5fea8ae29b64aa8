#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <fstream>

#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/gltf/import.hpp"
#include "hatchway/io/images/images.hpp"
#include "tests/io/expect_error.hpp"
#include "tests/io/gltf/model_builder.hpp"
#include "tests/shared_data.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

hw::ErrorParts error_of_text(const std::string& text, const std::string& name = "model.gltf")
{
    const TemporaryFolder folder;
    const fs::path file = folder.write(name, text);
    return error_of([&] { hw::import_gltf(file, folder.path()); });
}

hw::ErrorParts error_of_model(const ModelBuilder& builder)
{
    return error_of_text(builder.glb(), "model.glb");
}

/// A triangle with one value of its document changed.
hw::ErrorParts error_of_change(const std::string& pointer, const json& value)
{
    ModelBuilder builder = triangle_model();
    builder.json[json::json_pointer(pointer)] = value;
    return error_of_model(builder);
}

hw::ErrorParts error_of_buffer_uri(const std::string& uri, const TemporaryFolder& folder)
{
    ModelBuilder builder = triangle_model();
    builder.json["buffers"] = {{{"uri", uri}, {"byteLength", builder.binary.size()}}};
    const fs::path file = folder.write("project/model.gltf", builder.json.dump());
    folder.write("outside.bin", builder.binary);
    return error_of([&] { hw::import_gltf(file, folder.path() / "project"); });
}

}  // namespace

TEST(gltf_malformed, a_reference_out_of_range_is_named_by_its_pointer)
{
    const char* references[] = {"/scene",
                                "/scenes/0/nodes/0",
                                "/nodes/0/mesh",
                                "/nodes/0/camera",
                                "/nodes/0/skin",
                                "/nodes/0/children/0",
                                "/nodes/0/extensions/KHR_lights_punctual/light",
                                "/meshes/0/primitives/0/indices",
                                "/meshes/0/primitives/0/material",
                                "/meshes/0/primitives/0/attributes/POSITION",
                                "/meshes/0/primitives/0/targets/0/POSITION",
                                "/accessors/0/bufferView",
                                "/bufferViews/0/buffer"};
    for (const char* pointer : references)
        for (const json& bad : {json(99), json(-1), json(0.5), json("0"), json(1e18)}) {
            SCOPED_TRACE(std::string(pointer) + " " + bad.dump());
            EXPECT_EQ(error_of_change(pointer, bad).pointer, pointer);
        }
}

TEST(gltf_malformed, references_of_materials_textures_and_animations_are_checked)
{
    ModelBuilder builder = triangle_model();
    builder.push("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 3}}}}}});
    EXPECT_EQ(error_of_model(builder).pointer, "/materials/0/pbrMetallicRoughness/baseColorTexture/index");
    builder = triangle_model();
    builder.push("textures", {{"source", 1}});
    EXPECT_EQ(error_of_model(builder).pointer, "/textures/0/source");
    builder = triangle_model();
    builder.push("animations", {{"samplers", {{{"input", 0}, {"output", 7}}}}, {"channels", json::array()}});
    EXPECT_EQ(error_of_model(builder).pointer, "/animations/0/samplers/0/output");
}

TEST(gltf_malformed, views_and_accessors_stay_inside_of_their_bytes)
{
    EXPECT_EQ(error_of_change("/bufferViews/0/byteLength", 4096).pointer, "/bufferViews/0/byteLength");
    EXPECT_EQ(error_of_change("/bufferViews/0/byteOffset", 4096).pointer, "/bufferViews/0/byteLength");
    EXPECT_EQ(error_of_change("/bufferViews/0/byteOffset", 9000000000000000).pointer, "/bufferViews/0/byteLength");
    EXPECT_EQ(error_of_change("/bufferViews/0/byteStride", 252).pointer, "/accessors/0");
    EXPECT_EQ(error_of_change("/bufferViews/0/byteStride", 8).pointer, "/accessors/0") << "less than an element";
    EXPECT_EQ(error_of_change("/bufferViews/0/byteStride", 13).pointer, "/bufferViews/0/byteStride");
    EXPECT_EQ(error_of_change("/accessors/0/count", 4).pointer, "/accessors/0");
    EXPECT_EQ(error_of_change("/accessors/0/byteOffset", 4).pointer, "/accessors/0");
    EXPECT_EQ(error_of_change("/accessors/0/type", "VEC4").pointer, "/accessors/0");
    EXPECT_EQ(error_of_change("/bufferViews/0/byteLength", 35).pointer, "/accessors/0") << "one byte short";
    EXPECT_EQ(error_of_change("/bufferViews/1/byteLength", 5).pointer, "/accessors/1") << "one byte short";
    EXPECT_EQ(error_of_change("/bufferViews/1/byteLength", 7).pointer, "/bufferViews/1/byteLength")
        << "one byte more than there are";
}

TEST(gltf_malformed, huge_counts_are_refused_before_anything_is_allocated)
{
    EXPECT_EQ(error_of_change("/accessors/0/count", 1e18).pointer, "/accessors/0/count");
    EXPECT_EQ(error_of_change("/accessors/0/count", 100'000'000).pointer, "/accessors/0");
    ModelBuilder builder = triangle_model();
    builder.json["accessors"][0].erase("bufferView");
    builder.json["accessors"][0]["count"] = 50'000'000;
    EXPECT_EQ(error_of_model(builder).pointer, "/accessors/0/count") << "all zero: costs the file nothing";
    builder = triangle_model();
    builder.json["buffers"] = {{{"byteLength", 1ull << 40}}};
    EXPECT_EQ(error_of_text(builder.json.dump()).pointer, "/buffers/0/byteLength");
}

TEST(gltf_malformed, primitives_that_unpack_a_few_bytes_to_millions_of_vertices_are_refused)
{
    ModelBuilder builder;
    const int zeroes = builder.push("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 1'000'000}});
    for (int i = 0; i < 9; ++i) builder.add_object({{"POSITION", zeroes}});
    const hw::ErrorParts parts = error_of_model(builder);
    EXPECT_EQ(parts.pointer, "/meshes/8/primitives/0");
    EXPECT_THAT(parts.what, testing::HasSubstr("0 bytes unpack to"));
    EXPECT_THAT(parts.expected, testing::HasSubstr("--budget-factor"));
}

TEST(gltf_malformed, images_that_unpack_a_few_bytes_to_many_pixels_are_refused)
{
    const TemporaryFolder folder;
    constexpr int kSide = 4096;  // four of them are as many pixels as any scene may have
    hw::write_png(folder.path() / "white.png",
                  {.width = kSide, .height = kSide, .channels = 1, .bytes = std::vector<std::uint8_t>(kSide * kSide)});
    ModelBuilder builder = triangle_model();
    for (int i = 0; i < 6; ++i) {
        builder.push("images", {{"uri", "white.png"}});
        builder.push("textures", {{"source", i}});
    }
    json& primitives = builder.json["meshes"][0]["primitives"];
    for (int i = 0; i < 6; ++i) {
        builder.push("materials", {{"emissiveTexture", {{"index", i}}}});
        primitives.push_back(primitives[0]);
        primitives.back()["material"] = i;
    }
    const fs::path file = folder.write("model.glb", builder.glb());
    const hw::ErrorParts parts = error_of([&] { hw::import_gltf(file, folder.path()); });
    EXPECT_THAT(parts.file, testing::HasSubstr("/images/4"));
}

TEST(gltf_malformed, an_index_beyond_the_vertices_is_refused)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    builder.add_object({{"POSITION", positions}})["indices"] = builder.add_indices({0, 1, 3});
    const auto parts = error_of_model(builder);
    EXPECT_EQ(parts.pointer, "/meshes/0/primitives/0/indices");
    EXPECT_THAT(parts.what, testing::HasSubstr("element 2 is the index 3"));
}

TEST(gltf_malformed, a_mesh_that_no_node_shows_is_checked_too)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    builder.add_object({{"POSITION", positions}})["indices"] = builder.add_indices({0, 1, 3});
    builder.json.erase("nodes");
    builder.json.erase("scenes");
    EXPECT_EQ(error_of_model(builder).pointer, "/meshes/0/primitives/0/indices");
}

TEST(gltf_malformed, attributes_of_one_primitive_have_one_count)
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = builder.add_positions({0, 0, 1, 0, 0, 1});
    builder.add_object({{"POSITION", positions}, {"NORMAL", normals}});
    EXPECT_EQ(error_of_model(builder).pointer, "/meshes/0/primitives/0/attributes/POSITION");
}

TEST(gltf_malformed, node_loops_double_parents_and_deep_chains_are_refused)
{
    EXPECT_EQ(error_of_change("/nodes", {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}}).pointer,
              "/nodes/2/children/0")
        << "node 1 has two parents";
    EXPECT_EQ(error_of_change("/nodes", {{{"children", {1}}}, {{"children", {0}}}}).pointer, "/nodes/0");
    EXPECT_EQ(error_of_change("/nodes", {{{"mesh", 0}}, {{"children", {1}}}}).pointer, "/nodes/1");
    EXPECT_EQ(error_of_change("/nodes", {{{"children", {1}}}, {{"children", {0}}}, {{"mesh", 0}}}).pointer, "/nodes/0");
    json chain = json::array();
    for (int i = 1; i <= hw::limits::kMaxNodeDepth; ++i) chain.push_back({{"children", {i}}});
    chain.push_back({{"mesh", 0}});
    EXPECT_THAT(error_of_change("/nodes", chain).what, testing::HasSubstr("deep in the tree"));
}

TEST(gltf_malformed, a_scene_names_roots_once)
{
    ModelBuilder builder = triangle_model();
    builder.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
    builder.json["scenes"] = {{{"nodes", {0, 1}}}};
    EXPECT_EQ(error_of_model(builder).pointer, "/scenes/0/nodes/1");
    builder.json["scenes"] = {{{"nodes", {0, 0}}}};
    EXPECT_EQ(error_of_model(builder).pointer, "/scenes/0/nodes/1");
}

TEST(gltf_malformed, transforms_are_finite_affine_and_rotations_unit)
{
    const TemporaryFolder folder;
    EXPECT_EQ(error_of_text(R"({"asset":{"version":"2.0"},"nodes":[{"translation":[0,1e309,0]}]})").pointer,
              "/nodes/0/translation/1");
    EXPECT_EQ(error_of_change("/nodes/0/scale", {1e40, 1, 1}).pointer, "/nodes/0/scale/0");
    EXPECT_EQ(error_of_change("/nodes/0/rotation", {0, 0, 0, 0}).pointer, "/nodes/0/rotation");
    EXPECT_EQ(error_of_change("/nodes/0/matrix", json(16, 1)).pointer, "/nodes/0/matrix") << "no affine map";
    EXPECT_EQ(error_of_change("/nodes/0/matrix", json(15, 1)).pointer, "/nodes/0/matrix");
    json nodes = json::array();
    for (int i = 1; i <= 20; ++i) nodes.push_back({{"scale", {1e25, 1e25, 1e25}}, {"children", {i}}});
    nodes.push_back({{"mesh", 0}});
    EXPECT_THAT(error_of_change("/nodes", nodes).what, testing::HasSubstr("too large"));
    EXPECT_THAT(error_of_change("/nodes/0/translation", {1e20, 0, 0}).what, testing::HasSubstr("world coordinate"));
}

TEST(gltf_malformed, deep_json_is_refused_without_recursion)
{
    for (const std::size_t depth : {65u, 10'000u, 1'000'000u}) {
        const std::string text =
            R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') + std::string(depth, ']') + "}";
        EXPECT_THAT(error_of_text(text).what, testing::HasSubstr("nested over 64 deep"));
    }
}

TEST(gltf_malformed, a_document_of_over_256_megabytes_is_refused_unread)
{
    const TemporaryFolder folder;
    const fs::path file = folder.write("large.gltf", "{}");
    fs::resize_file(file, 257u << 20);  // a hole: takes no space
    EXPECT_THAT(error_of([&] { hw::import_gltf(file, folder.path()); }).what, testing::HasSubstr("269484032 bytes"));
}

TEST(gltf_malformed, an_unknown_required_extension_is_refused_by_name)
{
    const auto parts = error_of_change("/extensionsRequired", {"KHR_texture_transform", "KHR_draco_mesh_compression"});
    EXPECT_EQ(parts.pointer, "/extensionsRequired/1");
    EXPECT_THAT(parts.what, testing::HasSubstr("KHR_draco_mesh_compression"));
    EXPECT_THAT(parts.expected, testing::HasSubstr("KHR_materials_unlit"));
}

TEST(gltf_malformed, wrong_types_and_missing_properties_are_refused)
{
    EXPECT_EQ(error_of_text("[]").what, "stands an array of 0");
    EXPECT_EQ(error_of_text("{}").what, "\"asset\" is missing");
    EXPECT_THAT(error_of_text("").what, testing::HasSubstr("is no JSON"));
    EXPECT_THAT(error_of_text("{]").what, testing::HasSubstr("line 1, column 2"));
    EXPECT_EQ(error_of_change("/asset/version", "1.0").pointer, "/asset/version");
    EXPECT_EQ(error_of_change("/nodes", json::object()).pointer, "/nodes");
    EXPECT_EQ(error_of_change("/nodes/0", 7).pointer, "/nodes/0");
    EXPECT_EQ(error_of_change("/meshes/0/primitives/0/mode", 9).pointer, "/meshes/0/primitives/0/mode");
    EXPECT_EQ(error_of_change("/accessors/0/componentType", 5124).pointer, "/accessors/0/componentType");
    EXPECT_EQ(error_of_text(R"({"asset":{"version":"2.0"},"asset":{"version":"2.0"}})").pointer, "/asset");
}

TEST(gltf_malformed, paths_that_leave_the_project_are_refused)
{
    const TemporaryFolder folder;
    for (const char* uri : {"../outside.bin", "%2e%2e/outside.bin", "%2E%2E%2Foutside.bin", "a/../../outside.bin"}) {
        const auto parts = error_of_buffer_uri(uri, folder);
        EXPECT_EQ(parts.pointer, "/buffers/0/uri") << uri;
        EXPECT_THAT(parts.what, testing::HasSubstr("leaves the project")) << uri;
    }
    EXPECT_THAT(error_of_buffer_uri((folder.path() / "outside.bin").string(), folder).what,
                testing::HasSubstr("is absolute"));
    EXPECT_THAT(error_of_buffer_uri("x%00.bin", folder).what, testing::HasSubstr("no file name"));
}

TEST(gltf_malformed, a_link_is_refused_wherever_it_leads)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "project");
    fs::create_symlink(folder.path() / "outside.bin", folder.path() / "project/link.bin");
    EXPECT_THAT(error_of_buffer_uri("link.bin", folder).what, testing::HasSubstr("goes through the link"));
}

TEST(gltf_malformed, folders_pipes_other_schemes_and_bad_base64_are_refused_at_once)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "project/folder");
    ASSERT_EQ(::mkfifo((folder.path() / "project/pipe").c_str(), 0600), 0);
    for (const char* uri : {"folder", "pipe", "missing.bin", "http://example.com/a.bin", "file:///etc/passwd", "%zz",
                            "data:text/plain,abc", "data:application/octet-stream;base64,@@@@", "data:"})
        EXPECT_EQ(error_of_buffer_uri(uri, folder).pointer, "/buffers/0/uri") << uri;
}

TEST(gltf_malformed, a_buffer_shorter_than_it_says_is_refused)
{
    const TemporaryFolder folder;
    const auto parts = error_of_buffer_uri("data:application/octet-stream;base64,AAAA", folder);
    EXPECT_EQ(parts.pointer, "/buffers/0/byteLength");
}

TEST(gltf_malformed, a_glb_cut_at_any_byte_is_refused_with_its_byte)
{
    const std::string glb = triangle_model().glb();
    const TemporaryFolder folder;
    for (std::size_t size = 0; size < glb.size(); ++size) {
        const fs::path file = folder.write("cut.glb", glb.substr(0, size));
        EXPECT_THAT(error_of([&] { hw::import_gltf(file, folder.path()); }).pointer, testing::StartsWith("byte "))
            << size;
    }
}

TEST(gltf_malformed, no_changed_byte_of_a_glb_crashes)
{
    const std::string glb = triangle_model().glb();
    const TemporaryFolder folder;
    std::size_t read = 0;
    std::size_t refused = 0;
    for (std::size_t place = 0; place < glb.size(); ++place)
        for (const char change : {'\x80', '"', '9'}) {
            std::string changed = glb;
            changed[place] = changed[place] == change ? '\0' : change;
            const fs::path file = folder.write("changed.glb", changed);
            try {
                hw::import_gltf(file, folder.path());
                ++read;
            } catch (const hw::Error&) {
                ++refused;
            }
        }
    // A byte of a position may be any; a byte of the JSON's syntax may not.
    EXPECT_GT(read, glb.size() / 4);
    EXPECT_GT(refused, glb.size());
}

TEST(gltf_malformed, broken_containers_are_refused_with_their_byte)
{
    const auto glb = [](const std::string& rest) {
        return "glTF" + ModelBuilder::word(2) + ModelBuilder::word(12 + rest.size()) + rest;
    };
    EXPECT_EQ(error_of_text("notaglTFfile", "a.glb").pointer, "byte 0");
    EXPECT_EQ(error_of_text(glb(ModelBuilder::word(4) + "BIN\0    "), "a.glb").pointer, "byte 12");
    EXPECT_EQ(error_of_text(glb(ModelBuilder::word(400) + "JSON    "), "a.glb").pointer, "byte 12");
    EXPECT_EQ(error_of_text(glb(ModelBuilder::word(8) + "JSON    "), "a.glb").pointer, "byte 12");
    EXPECT_EQ(error_of_text(glb(ModelBuilder::word(3) + "JSON   "), "a.glb").pointer, "byte 12");
    const std::string chunk = ModelBuilder::word(4) + "JSON{}  ";
    EXPECT_EQ(error_of_text(glb(chunk + chunk), "a.glb").pointer, "byte 24");
}

namespace {

bool must_be_refused(const json& message)
{
    const std::string code = message.at("code");
    const auto has = [&](const char* part) { return code.find(part) != std::string::npos; };
    const bool is_not_finite =
        code == "VALUE_NOT_IN_RANGE" && message.at("message").get<std::string>().find("Infinity") != std::string::npos;
    return message.at("severity") == 0 && (has("UNRESOLVED_REFERENCE") || has("_TOO_LONG") || has("INDEX_OOB") ||
                                           has("COUNT") || has("NODE_LOOP") || is_not_finite);
}

std::vector<json> reasons_to_refuse(const fs::path& report)
{
    const json document = json::parse(std::ifstream(report));
    std::vector<json> reasons;
    for (const json& message : document.at("issues").value("messages", json::array()))
        if (must_be_refused(message)) reasons.push_back(message);
    return reasons;
}

bool names_place(const hw::ErrorParts& parts, const std::vector<json>& reasons)
{
    // Where the file refers to data that the corpus does not hold, that comes first.
    if (parts.what.find("there is no file") != std::string::npos) return true;
    for (const json& reason : reasons)
        if (reason.value("pointer", "") == parts.pointer) return true;
    return false;
}

}  // namespace

TEST(gltf_malformed, the_validators_corpus_ends_in_two_seconds_a_file_and_errors_name_their_place)
{
    const fs::path corpus = hw::test::kSharedData / "malformed" / "gltf_validator";
    HATCHWAY_NEEDS_DATA(fs::exists(corpus), corpus);
    int read = 0;
    int refused = 0;
    for (const auto& entry : fs::directory_iterator(corpus)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".glb" && file.extension() != ".gltf") continue;
        const std::vector<json> reasons = reasons_to_refuse(file.string() + ".report.json");
        const auto start = std::chrono::steady_clock::now();
        try {
            hw::import_gltf(file, corpus);
            ++read;
            EXPECT_TRUE(reasons.empty()) << file << " " << (reasons.empty() ? json() : reasons[0]);
        } catch (const hw::Error& error) {
            EXPECT_TRUE(reasons.empty() || names_place(error.parts(), reasons)) << error.what();
            ++refused;
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << file;
    }
    // Wrong in what we do not need is not wrong for us.
    EXPECT_GT(read, 20);
    EXPECT_GT(refused, 20);
}
