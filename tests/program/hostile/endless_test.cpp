// Small files that ask for endless work: each ends within 30 s of one processor and 2 GB, with a result or one message.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/vec3.hpp>
#include <random>

#include "hatchway/io/images/images.hpp"
#include "tests/io/gltf/model_builder.hpp"
#include "tests/program/run_program.hpp"

namespace {

using hw::test::ProgramResult;
using hw::test::run_program;
using nlohmann::json;
using testing::Test;

#ifdef __SANITIZE_ADDRESS__  // which takes memory itself, and time
constexpr double kLongest_s = 1800.0;
constexpr hw::test::ProgramLimits kLimits{.cpu_s = 300};
#else
constexpr double kLongest_s = 300.0;  // the machine may be busy with other tests
constexpr hw::test::ProgramLimits kLimits{.cpu_s = 30, .memory_bytes = 2ull << 30};
#endif
constexpr hw::test::ProgramLimits kQuickLimits{.cpu_s = kLimits.cpu_s / 3, .memory_bytes = kLimits.memory_bytes};

/// How many of what costs most: with HATCHWAY_WHOLE_CORPORA=1 so many as first took for ever, else as shows the growth.
int whole_or(int sample, int whole)
{
    return std::getenv("HATCHWAY_WHOLE_CORPORA") ? whole : sample;
}

using Triangles = std::vector<float>;

void add_triangle(Triangles& triangles, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    for (const glm::vec3& p : {a, b, c}) triangles.insert(triangles.end(), {p.x, p.y, p.z});
}

void add_box(Triangles& triangles, const glm::vec3& centre, float half)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 out(0.0f), u(0.0f), v(0.0f);
            out[axis] = side * half;
            u[(axis + 1) % 3] = side * half;
            v[(axis + 2) % 3] = half;
            const glm::vec3 middle = centre + out;
            add_triangle(triangles, middle - u - v, middle + u - v, middle + u + v);
            add_triangle(triangles, middle - u - v, middle + u + v, middle - u + v);
        }
}

Triangles box(float half)
{
    Triangles triangles;
    add_box(triangles, glm::vec3(0.0f), half);
    return triangles;
}

/// Numbers in [0, 1) that are the same with every standard library.
class Random {
 public:
    float next() { return static_cast<float>(engine_() / 4294967296.0); }
    glm::vec3 point()
    {
        const float x = next(), y = next();
        return {x, y, next()};
    }

 private:
    std::mt19937 engine_{7};
};

class endless : public Test {
 protected:
    /// A model whose first mesh is these triangles, with nodes that all are roots unless others name them as children.
    std::string model(const Triangles& triangles, const json& nodes = {{{"mesh", 0}}}, const json& material = {})
    {
        ModelBuilder builder;
        json primitive = {{"attributes", {{"POSITION", builder.add_positions(triangles)}}}};
        if (!material.is_null()) primitive["material"] = builder.push("materials", material);
        builder.push("meshes", {{"primitives", {primitive}}});
        builder.json["nodes"] = nodes;
        return folder_.write("model.glb", builder.glb());
    }
    ProgramResult run(std::vector<std::string> arguments, const hw::test::ProgramLimits& limits = kLimits)
    {
        return run_program(arguments, kLongest_s, {"XDG_CACHE_HOME=" + folder_.path().string()}, limits);
    }
    void expect_opens(const std::string& file)
    {
        const ProgramResult checked = run({"check", file});
        EXPECT_EQ(checked.exit_code, 0) << checked.err.substr(0, 2000);
        expect_compiles(file);
    }
    void expect_compiles(const std::string& file)
    {
        const ProgramResult compiled = run({"compile", file});
        EXPECT_EQ(compiled.exit_code, 0) << compiled.err.substr(0, 2000);
    }
    void expect_message(const ProgramResult& result, const std::string& words)
    {
        EXPECT_EQ(result.exit_code, 2) << result.err.substr(0, 2000);
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err.substr(0, 2000);
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err.substr(0, 2000);
    }
    /// A result, or one message that says how to raise the limit.
    void expect_ends(const ProgramResult& result)
    {
        if (result.exit_code == 0) return;
        EXPECT_EQ(result.exit_code, 2) << result.err.substr(0, 2000);
        EXPECT_NE(result.err.find("--budget-factor"), std::string::npos) << result.err.substr(0, 2000);
    }
    ProgramResult lines_of(const std::string& file)
    {
        return run({"lines", file, "--style", "*=pen_and_ink", "--out", folder_ / "lines.svg"});
    }
    ProgramResult picture_of(const std::string& file, const std::string& style)
    {
        return run({"render", file, "--style", "*=" + style, "--out", folder_ / "picture.png"});
    }
    ProgramResult map_of(const std::string& view_box, const std::string& body)
    {
        const std::string text = "<svg viewBox=\"" + view_box + "\">" + body + "</svg>";
        return run({"map", "ink", folder_.write("drawing.svg", text), "--out", folder_ / "map"});
    }

    hw::test::TemporaryFolder folder_;
};

}  // namespace

TEST_F(endless, a_number_after_the_end_of_a_path)
{
    expect_message(map_of("0 0 9 9", R"(<path d="M0 0Z1"/>)"), "follows the Z");
}

TEST_F(endless, a_drawing_without_a_size_to_speak_of)
{
    expect_message(map_of("0 0 1e-300 1e-300", R"(<path d="M1e9 1e9"/>)"), "too far");
    expect_message(map_of("0 0 1 1e9", R"(<path d="M0 0L1 1"/>)"), "times as high as wide");
}

TEST_F(endless, a_stroke_that_crosses_the_drawing_two_thousand_times)
{
    EXPECT_EQ(map_of("0 0 1 1", R"(<path d="M-900 -800L600 1000"/>)").exit_code, 0);
}

TEST_F(endless, ninety_thousand_strokes)
{
    std::string path;
    for (int i = 0; i < 90'000; ++i) path += "M" + std::to_string(i % 100) + " " + std::to_string(i / 100 % 100) + "h1";
    EXPECT_EQ(map_of("0 0 100 100", "<path d=\"" + path + "\"/>").exit_code, 0);
}

TEST_F(endless, a_bitmap_of_noise_and_one_of_ink_alone)
{
    hw::Pixels noise{.width = 3000, .height = 3000, .channels = 1, .bytes = std::vector<std::uint8_t>(3000 * 3000, 0)};
    const auto map = [&] {
        hw::write_png(folder_ / "drawing.png", noise);
        return run({"map", "ink", folder_ / "drawing.png", "--out", folder_ / "map"});
    };
    expect_ends(map());
    Random random;
    for (std::uint8_t& value : noise.bytes) value = random.next() < 0.5f ? 0 : 255;
    expect_message(map(), "strokes");
}

TEST_F(endless, boxes_that_lie_into_each_other)
{
    Random random;
    Triangles triangles;
    for (int i = 0; i < 60; ++i) add_box(triangles, 2.0f * random.point(), 0.5f + random.next());
    expect_opens(model(triangles));
}

/// Sheets with random directions through the middle of one place.
Triangles crossing_sheets(int count)
{
    Random random;
    Triangles triangles;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 u = random.point() - 0.5f, v = random.point() - 0.5f;
        add_triangle(triangles, -u - v, u - v, u + v);
        add_triangle(triangles, -u - v, u + v, v - u);
    }
    return triangles;
}

/// Openings between the cells of many have many corners: what a step of the portal flow costs is not the same
/// everywhere.
TEST_F(endless, sheets_that_all_cross)
{
    for (int count = 60; count <= whole_or(60, 300); count += 240)
        expect_opens(model(crossing_sheets(count), {{{"mesh", 0}}}, {{"doubleSided", true}}));
}

TEST_F(endless, sheets_that_lie_on_each_other_in_one_plane)
{
    Random random;
    Triangles triangles;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 p(3.0f * random.next(), 0.0f, 3.0f * random.next());
        const glm::vec3 u(0.3f + random.next(), 0.0f, 0.0f), v(0.0f, 0.0f, 0.3f + random.next());
        add_triangle(triangles, p, p + v, p + u);
        add_triangle(triangles, p + u, p + v, p + u + v);
    }
    expect_opens(model(triangles));
}

TEST_F(endless, scenes_of_any_size)
{
    for (const float half : {1e-38f, 1e-30f, 1e-20f, 1e-12f, 1e-6f, 5e-5f, 1e-3f, 1e6f, 1e9f, 1e14f}) {
        SCOPED_TRACE(half);
        expect_opens(model(box(half)));
    }
    Triangles triangle;
    add_triangle(triangle, glm::vec3(0.0f), glm::vec3(1e-38f, 0.0f, 0.0f), glm::vec3(0.0f, 1e-38f, 0.0f));
    expect_opens(model(triangle));
}

TEST_F(endless, node_paths_that_multiply)
{
    json nodes = json::array();
    for (int i = 0; i < 200; ++i) nodes.push_back({{"name", std::string(1000, 'n')}, {"children", {i + 1}}});
    json leaves = json::array();
    for (int i = 0; i < 10'000; ++i) leaves.push_back(201 + i);
    nodes.push_back({{"children", leaves}});
    for (int i = 0; i < 10'000; ++i) nodes.push_back({{"mesh", 0}});
    expect_message(run({"check", model(box(0.5f), nodes)}), "bytes of node paths");
}

TEST_F(endless, a_mesh_that_nodes_repeat)
{
    Triangles triangles;
    for (int i = 0; i < 500; ++i) add_box(triangles, glm::vec3(static_cast<float>(i)), 0.4f);
    json nodes = json::array();
    for (int i = 0; i < 20'000; ++i) nodes.push_back({{"mesh", 0}});
    const std::string file = model(triangles, nodes);
    expect_message(run({"check", file}), "too many drawn triangles");
    EXPECT_NE(run({"check", file}).err.find("--budget-factor"), std::string::npos) << "how to raise it is said";
}

TEST_F(endless, cameras_of_one_name)
{
    json nodes(20'000, {{"camera", 0}});
    nodes.push_back({{"mesh", 0}});
    ModelBuilder builder;
    builder.push("meshes", {{"primitives", {{{"attributes", {{"POSITION", builder.add_positions(box(0.5f))}}}}}}});
    builder.push("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}});
    builder.json["nodes"] = nodes;
    EXPECT_EQ(run({"check", folder_.write("model.glb", builder.glb())}).exit_code, 0);
}

TEST_F(endless, light_of_five_thousand_lamps)
{
    model(box(4.0f), {{{"mesh", 0}}}, {{"doubleSided", true}});
    json level = {{"format", "hatchway-level/1"}, {"scene", "model.glb"}, {"lights", json::array()}};
    Random random;
    for (int i = 0; i < 5000; ++i)
        level["lights"].push_back({{"type", "point"},
                                   {"position", {random.next() - 0.5f, random.next() - 0.5f, random.next() - 0.5f}},
                                   {"intensity_cd", 10}});
    const ProgramResult baked = run({"bake", folder_.write("lamps.level.json", level.dump()), "--quality", "draft"});
    EXPECT_EQ(baked.exit_code, 0) << baked.err.substr(0, 2000);
}

TEST_F(endless, light_of_seven_thousand_spots)
{
    ModelBuilder builder;
    Triangles floor, boxes;
    for (int i = 0; i < 64 * 64; ++i) {
        const glm::vec3 x(1.5f, 0, 0), z(0, 0, 1.5f), corner = (i % 64 - 32.0f) * x + (i / 64 - 32.0f) * z;
        add_triangle(floor, corner, corner + z, corner + x);
        add_triangle(floor, corner + x, corner + z, corner + x + z);
    }
    Random random;
    const auto place = [&](float height) {
        return glm::vec3(96, 0, 96) * (random.point() - 0.5f) + glm::vec3(0, height, 0);
    };
    for (int i = 0; i < 12; ++i) add_box(boxes, place(0.5f), 0.5f);
    for (const Triangles& triangles : {floor, boxes})
        builder.push("meshes", {{"primitives", {{{"attributes", {{"POSITION", builder.add_positions(triangles)}}}}}}});
    json nodes = {{{"mesh", 0}}, {{"mesh", 1}}};
    for (int i = 0; i < 7000; ++i) {
        const glm::vec3 at = place(3.0f);
        nodes.push_back({{"translation", {at.x, at.y, at.z}},
                         {"rotation", {-0.70710678, 0, 0, 0.70710678}},
                         {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    }
    builder.json["nodes"] = nodes;
    builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"}, {"intensity", 20}, {"spot", {{"innerConeAngle", 0.3}, {"outerConeAngle", 0.7}}}}};
    const ProgramResult baked = run({"bake", folder_.write("spots.glb", builder.glb()), "--quality", "draft"});
    EXPECT_EQ(baked.exit_code, 0) << baked.err.substr(0, 2000);
}

TEST_F(endless, light_of_a_closed_white_room_of_a_kilometre)
{
    model(box(500.0f), {{{"mesh", 0}}}, {{"doubleSided", true}});
    json level = {{"format", "hatchway-level/1"}, {"scene", "model.glb"}, {"lights", json::array()}};
    for (int i = 0; i < 16; ++i)
        level["lights"].push_back({{"type", "point"}, {"position", {8 * i, 0, 0}}, {"intensity_cd", 1000}});
    const ProgramResult baked = run({"bake", folder_.write("room.level.json", level.dump()), "--quality", "draft"});
    EXPECT_EQ(baked.exit_code, 0) << baked.err.substr(0, 2000);
    EXPECT_NE(baked.err.find("samples of each luxel instead of 32"), std::string::npos) << baked.err.substr(0, 2000);
}

TEST_F(endless, polygons_that_go_to_and_fro)
{
    constexpr int kCorners = 4096;
    std::string zigzag, face = "f";
    for (int i = 0; i < kCorners; ++i) {
        const int step = std::min(i, kCorners - 1 - i);
        zigzag += "v " + std::to_string(step) + ' ' + std::to_string(step % 2 * 100 + (i > step ? 1 : 0)) + " 0\n";
        face += ' ' + std::to_string(i + 1);
    }
    for (int i = 0; i < whole_or(12, 45); ++i) zigzag += face + '\n';
    EXPECT_EQ(run({"check", folder_.write("model.obj", zigzag)}).exit_code, 0);
}

TEST_F(endless, lines_of_objects_at_one_place)
{
    expect_ends(lines_of(model(box(0.5f), json(static_cast<std::size_t>(whole_or(700, 2000)), {{"mesh", 0}}))));
}

TEST_F(endless, lines_of_a_fine_mesh_that_nodes_repeat)
{
    Triangles triangles;
    for (int i = 0; i < 1500; ++i) add_box(triangles, glm::vec3(static_cast<float>(i)), 0.4f);
    expect_message(lines_of(model(triangles, json(2000, {{"mesh", 0}}))), "--budget-factor");
}

TEST_F(endless, a_rehearsal_of_boxes_at_one_place)
{
    const ProgramResult checked = run({"check", model(box(0.5f), json(5000, {{"mesh", 0}}))}, kQuickLimits);
    EXPECT_EQ(checked.exit_code, 0) << checked.err.substr(0, 2000);
}

TEST_F(endless, pictures_of_boxes_at_one_place)
{
    const std::string file = model(box(0.5f), json(5000, {{"mesh", 0}}));
    for (const char* style : {"pen_and_ink", "photoreal"}) {
        const ProgramResult drawn = picture_of(file, style);
        EXPECT_EQ(drawn.exit_code, 0) << style << ": " << drawn.err.substr(0, 2000);
    }
}

TEST_F(endless, pictures_of_a_mesh_of_boxes_at_one_place)
{
    Triangles pile;
    for (int i = 0; i < whole_or(1000, 5000); ++i) add_box(pile, glm::vec3(0.0f), 0.5f);
    const std::string file = model(pile);
    for (const char* style : {"pen_and_ink", "photoreal"}) expect_ends(picture_of(file, style));
}

TEST_F(endless, pictures_of_faces_that_lie_over_each_other_by_the_thousand)
{
    json nodes = json::array();
    for (int i = 0; i < 20'000; ++i) nodes.push_back({{"mesh", 0}, {"translation", {0, 0, i * 1e-6}}});
    expect_message(picture_of(model(box(0.5f), nodes), "photoreal"), "too many layers");
    const json glass = {{"alphaMode", "BLEND"}};
    expect_message(picture_of(model(box(0.5f), json(5000, {{"mesh", 0}}), glass), "photoreal"), "too many layers");
}

TEST_F(endless, faces_around_one_edge)
{
    const int faces = whole_or(1000, 20'000);
    Triangles triangles;
    for (int i = 0; i < faces; ++i) {
        const float angle = static_cast<float>(i) * 6.2831853f / static_cast<float>(faces);
        add_triangle(triangles, {0, 0, 0}, {0, 1, 0}, {std::cos(angle), 0.5f, std::sin(angle)});
    }
    const std::string file = model(triangles);
    expect_opens(file);
    expect_ends(lines_of(file));
}

/// A place within `reach` of another.
glm::vec3 near(const glm::vec3& place, float reach, Random& random)
{
    return place + reach * (2.0f * random.point() - 1.0f);
}

TEST_F(endless, twelve_thousand_faces_smaller_than_what_is_stitched)
{
    Random random;
    Triangles triangles;
    const auto speck = [&] { return near(glm::vec3(0.0f), 1e-5f, random); };
    for (int i = 0; i < 12'000; ++i) add_triangle(triangles, speck(), speck(), speck());
    add_triangle(triangles, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const std::string file = model(triangles);
    EXPECT_EQ(run({"silhouettes", file, "--eye", "3,2,4"}, kQuickLimits).exit_code, 0);
    EXPECT_EQ(run({"info", file}).exit_code, 0) << "also in memory";
}

TEST_F(endless, twelve_thousand_borders_that_nearly_lie_on_each_other)
{
    const glm::vec3 from(0.0f), to(1.0f, 0.0f, 0.0f);
    const float reach = 2e-6f;
    for (const float apart : {0.0f, 0.5f}) {
        Random random;
        Triangles triangles;
        for (int i = 0; i < 12'000; ++i)
            add_triangle(triangles, near(i % 2 ? from : to, reach, random), near(i % 2 ? to : from, reach, random),
                         near({0.5f, 0.6f, 0.0f}, reach + apart, random));
        EXPECT_EQ(run({"silhouettes", model(triangles), "--eye", "3,2,4"}, kQuickLimits).exit_code, 0) << apart;
    }
}

TEST_F(endless, one_face_fifty_thousand_times)
{
    Triangles triangles;
    for (int i = 0; i < 50'000; ++i) add_triangle(triangles, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    expect_ends(lines_of(model(triangles)));
}

TEST_F(endless, objects_of_which_every_face_crosses_all_places)
{
    const int count = whole_or(24, 500);
    Random random;
    Triangles triangles;
    for (int i = 0; i < count; ++i) add_triangle(triangles, random.point(), random.point(), random.point());
    json nodes = json::array();
    for (int i = 0; i < count; ++i)
        nodes.push_back({{"mesh", 0}, {"translation", {2 * random.next(), 2 * random.next(), 2 * random.next()}}});
    expect_compiles(model(triangles, nodes));
}

TEST_F(endless, a_sealed_level_that_is_too_fine_for_the_search_is_not_told_to_be_sealed)
{
    Random random;
    Triangles triangles;
    for (int i = 0; i < whole_or(1000, 3000); ++i)
        add_triangle(triangles, 2.0f * random.point() - 1.0f, 2.0f * random.point() - 1.0f,
                     2.0f * random.point() - 1.0f);
    model(triangles, {{{"mesh", 0}}}, {{"doubleSided", true}});
    const json level = {{"format", "hatchway-level/1"},
                        {"scene", "model.glb"},
                        {"sealed", true},
                        {"start", {{"position", {0, 0, 0}}, {"look_at", {1, 0, 0}}}}};
    const ProgramResult result = run({"check", folder_.write("sealed.level.json", level.dump())});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("too fine for the search for leaks"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("is sealed"), std::string::npos) << result.err;
}

TEST_F(endless, a_thousand_rules_over_five_thousand_nodes)
{
    json nodes = json::array();
    for (int i = 0; i < 5000; ++i)
        nodes.push_back({{"mesh", 0},
                         {"name", "Hall_" + std::to_string(i) + "_column"},
                         {"translation", {2 * (i % 70), 0, 2 * (i / 70)}}});
    model(box(0.5f), nodes);
    json level = {{"format", "hatchway-level/1"}, {"scene", "model.glb"}, {"assign", json::array()}};
    for (int i = 0; i < 1000; ++i)
        level["assign"].push_back({{"nodes", "*a*" + std::to_string(i) + "*l*"}, {"style", "photoreal"}});
    expect_opens(folder_.write("rules.level.json", level.dump()));
}

TEST_F(endless, a_rule_of_four_hundred_thousand_characters)
{
    model(box(0.5f), {{{"mesh", 0}, {"name", std::string(400'000, 'a')}}});
    std::string glob;
    while (glob.size() < 400'000) glob += "*a";
    for (const char* end : {"", "b"}) {
        const json level = {{"format", "hatchway-level/1"},
                            {"scene", "model.glb"},
                            {"assign", {{{"nodes", glob + end}, {"style", "photoreal"}}}}};
        expect_opens(folder_.write("rules.level.json", level.dump()));
    }
}

TEST_F(endless, rules_over_paths_that_multiply)
{
    json nodes = json::array();
    for (int i = 0; i < 100; ++i) nodes.push_back({{"name", std::string(1000, 'n')}, {"children", {i + 1}}});
    nodes.push_back({{"children", json::array()}});
    for (int i = 0; i < 1000; ++i) {
        nodes[100]["children"].push_back(101 + i);
        nodes.push_back({{"mesh", 0}});
    }
    model(box(0.5f), nodes);
    json level = {{"format", "hatchway-level/1"}, {"scene", "model.glb"}, {"assign", json::array()}};
    for (int i = 0; i < 2000; ++i)
        level["assign"].push_back({{"nodes", "**n**" + std::to_string(i) + "*"}, {"style", "photoreal"}});
    expect_message(run({"check", folder_.write("rules.level.json", level.dump())}), "steps of rules");
}
