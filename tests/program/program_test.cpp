#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "hatchway/io/images/images.hpp"
#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

const std::string kHall = (kContent / "levels" / "hall.level.json").string();
const std::string kPrismLevel = (kContent / "levels" / "prism.level.json").string();
const std::string kPrism = (kContent / "models" / "prism.glb").string();

json read_json(const fs::path& file)
{
    return json::parse(bytes_of(file));
}

}  // namespace

TEST(program, says_what_it_can_do)
{
    const ProgramResult help = run_program({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    for (const char* command : {"walk", "render", "bake", "check", "compile", "info", "silhouettes", "measure",
                                "report", "new-style", "schema"}) {
        EXPECT_NE(help.out.find(command), std::string::npos) << command;
        const ProgramResult result = run_program({command, "--help"});
        EXPECT_EQ(result.exit_code, 0) << command;
        EXPECT_NE(result.out.find("Usage"), std::string::npos) << command;
    }
    EXPECT_EQ(run_program({"--version"}).out.rfind("hatchway ", 0), 0u);
}

TEST(program, the_prism_has_the_numbers_of_the_paper)
{
    const TemporaryFolder folder;
    const ProgramResult result = run_program({"silhouettes", kPrism, "--eye", "3,1,7", "--crease-deg", "60", "--json",
                                              folder / "s.json", "--dump-mesh", folder / "m.json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json found = read_json(folder / "s.json");
    EXPECT_EQ(found["faces"], 28);
    EXPECT_EQ(found["edges"], 42);
    EXPECT_EQ(found["creases"], 16);
    EXPECT_EQ(found["candidates"], 8);
    EXPECT_EQ(found["silent"], 18);
    EXPECT_EQ(found["borders"], 0);
    EXPECT_EQ(found["drawn"].size(), 2u);  // a convex prism seen from its side has two upright contours
    for (const json& edge : found["silhouettes"]) EXPECT_EQ(edge.size(), 6u);

    const json mesh = read_json(folder / "m.json")["objects"][0];
    EXPECT_EQ(mesh["positions"].size(), 16u);
    EXPECT_EQ(mesh["faces"].size(), 28u);
    EXPECT_EQ(mesh["eye_object"].size(), 3u);
}

TEST(program, silhouettes_have_nine_digits_and_meshes_seventeen)
{
    const TemporaryFolder folder;
    ASSERT_EQ(run_program({"silhouettes", kPrism, "--eye", "0.1,1,7", "--json", folder / "s.json", "--dump-mesh",
                           folder / "m.json"})
                  .exit_code,
              0);
    EXPECT_NE(bytes_of(folder / "m.json").find("0.10000000000000001"), std::string::npos);
    const std::string text = bytes_of(folder / "s.json");
    EXPECT_EQ(text.find("000000000000"), std::string::npos);
}

TEST(program, info_counts_the_prism)
{
    const TemporaryFolder folder;
    const ProgramResult result = run_program({"info", kPrism, "--json", folder / "i.json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json info = read_json(folder / "i.json");
    EXPECT_EQ(info["triangles"], 28);
    EXPECT_EQ(info["components"], 1);
    EXPECT_EQ(info["closed_components"], 1);
    EXPECT_EQ(info["reflex_rule_components"], 1);
    EXPECT_EQ(info["borders"], 0);
    EXPECT_EQ(info["flips_repaired"], 0);
    EXPECT_GT(info["bytes_per_edge"].get<double>(), 0.0);
    EXPECT_GE(info["leaves"].get<int>(), 1);
}

TEST(program, check_accepts_the_levels_that_come_with_it)
{
    for (const std::string& level : {kHall, kPrismLevel}) {
        const ProgramResult result = run_program({"check", level});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.out, testing::HasSubstr("0 warnings"));
    }
}

TEST(program, check_doubts_a_rule_that_names_nothing)
{
    const TemporaryFolder folder;
    fs::copy_file(kPrism, folder.path() / "prism.glb");
    const std::string level = folder.write("a.level.json", R"({"format": "hatchway-level/1", "scene": "prism.glb",
        "assign": [{"nodes": "Colunm*", "style": "photoreal"}]})");
    const ProgramResult result = run_program({"check", level});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, testing::HasSubstr("/assign/0"));
}

TEST(program, the_schema_that_comes_with_it_is_the_one_that_it_writes)
{
    const ProgramResult result = run_program({"schema"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, bytes_of(kContent / "level.schema.json"))
        << "run: build/release/bin/hatchway schema --out content/level.schema.json";
}

TEST(program, the_manual_lists_every_key_and_parameter)
{
    const std::string manual = bytes_of(fs::path(HATCHWAY_SOURCE_DIR) / "docs" / "level_files.md");
    const json properties = json::parse(bytes_of(kContent / "level.schema.json"))["properties"];
    for (const auto& [key, value] : properties.items())
        EXPECT_TRUE(key == "$schema" || manual.find("| `" + key + "` |") != std::string::npos) << key;
    for (const json& style : properties["styles"]["additionalProperties"]["allOf"])
        for (const auto& [name, value] : style["then"]["properties"].items())
            EXPECT_TRUE(name == "plugin" || manual.find("| `" + name + "` | ") != std::string::npos)
                << name << ": run docs/style_tables.py";
}

TEST(program, renders_every_style_on_a_bare_model)
{
    const TemporaryFolder folder;
    for (const char* style : {"photoreal", "pen_and_ink", "hybrid", "technical", "id_outline", "cartoon", "halftone"}) {
        const std::string out = folder / (std::string(style) + ".png");
        const ProgramResult result = run_program({"render", kPrism, "--style", std::string("*=") + style, "--size",
                                                  "160x120", "--out", out, "--json", folder / "r.json", "--stats"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_GT(fs::file_size(out), 500u);
        EXPECT_EQ(read_json(folder / "r.json")["frames"][0]["objects_visible"], 1);
        EXPECT_THAT(result.out, testing::HasSubstr("triangles"));
    }
    EXPECT_NE(bytes_of(folder / "photoreal.png"), bytes_of(folder / "pen_and_ink.png"));
}

TEST(program, strokes_and_dots_of_a_halftone_have_the_same_tone)
{
    const TemporaryFolder folder;
    fs::copy_file(kPrism, folder.path() / "prism.glb");
    fs::copy(kContent / "maps", folder.path() / "maps", fs::copy_options::recursive);
    std::map<std::string, double> whites;
    for (const std::string screen : {"dots", "strokes"}) {
        folder.write("a.level.json",
                     R"({"format": "hatchway-level/1", "scene": "prism.glb", "styles": {"half": {
            "plugin": "halftone", "screen": ")" +
                         screen +
                         R"(", "lines_from": "none", "darkness": 1, "material_tone": 1, "ink_colour": "#000000"}},
            "assign": [{"nodes": "*", "style": "half"}], "exposure_ev": 14,
            "cameras": {"a": {"position": [0, 1, 3], "look_at": [0, 1, 0], "fov_deg": 20}}})");
        const ProgramResult result = run_program({"render", folder / "a.level.json", "--camera", "a", "--size",
                                                  "200x200", "--samples", "1", "--no-pvs", "--out", folder / "a.png"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const Pixels picture = read_image(folder / "a.png");
        int black = 0, white = 0;
        for (const std::uint8_t value : picture.bytes) {
            whites[screen] += value / (255.0 * static_cast<double>(picture.bytes.size()));
            black += value < 64 ? 1 : 0;
            white += value > 192 ? 1 : 0;
        }
        EXPECT_GT(black, 1000) << screen;
        EXPECT_GT(white, 1000) << screen;
    }
    EXPECT_NEAR(whites["dots"], whites["strokes"], 0.05);
}

TEST(program, a_photoreal_level_pays_nothing_for_ink)
{
    const TemporaryFolder folder;
    const ProgramResult result = run_program({"render", kHall, "--style", "*=photoreal", "--size", "160x90", "--out",
                                              folder / "a.png", "--json", folder / "r.json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json frame = read_json(folder / "r.json")["frames"][0];
    for (const char* product : {"edge_tables_built", "adjacencies_built", "hatch_streams_built",
                                "silhouette_extractions", "lines", "images_made", "transient_targets"})
        EXPECT_EQ(frame[product], 0) << product;
    EXPECT_GT(frame["triangles"], 1000);
    EXPECT_GT(frame["faces_drawn"], 500);
    EXPECT_LT(frame["faces_drawn"], frame["triangles"]) << "faces have a pass for depth, too";
}

TEST(program, the_tour_rendered_twice_has_the_same_bytes)
{
    const TemporaryFolder folder;
    for (const char* name : {"first", "second"}) {
        const ProgramResult result = run_program(
            {"render", kHall, "--path", "tour", "--frames", "6", "--size", "320x180", "--out", folder / name}, 200.0);
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    for (int frame = 0; frame < 6; ++frame) {
        const std::string name = "/frame_000" + std::to_string(frame) + ".png";
        EXPECT_EQ(bytes_of((folder / "first") + name), bytes_of((folder / "second") + name)) << frame;
        EXPECT_GT(fs::file_size((folder / "first") + name), 1000u);
    }
}

TEST(program, a_frame_does_not_depend_on_the_frames_before)
{
    const TemporaryFolder folder;
    const std::vector<std::string> common{"render", kPrismLevel, "--path", "turntable", "--size", "160x120"};
    auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), common.begin(), common.end());
        return run_program(more).exit_code;
    };
    ASSERT_EQ(with({"--frames", "5", "--out", folder / "five"}), 0);
    ASSERT_EQ(with({"--frames", "1", "--out", folder / "one"}), 0);
    // A turntable ends where it began, so the last of five frames shows what a single first frame shows, at another
    // time.
    EXPECT_EQ(bytes_of(folder / "five/frame_0004.png"), bytes_of(folder / "one/frame_0000.png"));
}

TEST(program, every_model_has_a_tour)
{
    const TemporaryFolder folder;
    ASSERT_EQ(
        run_program({"render", kPrism, "--path", "tour", "--frames", "3", "--size", "64x48", "--out", folder / "t"})
            .exit_code,
        0);
    EXPECT_TRUE(fs::exists(folder / "t/frame_0002.png"));
}

TEST(program, a_new_style_is_written_once)
{
    const TemporaryFolder folder;
    const std::vector<std::string> arguments{"new-style", "pencil", "--in", folder.path().string()};
    const ProgramResult first = run_program(arguments);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_TRUE(fs::exists(folder / "pencil/pencil.cpp"));
    EXPECT_EQ(run_program(arguments).exit_code, 2);
}

TEST(program, measures_frames_with_their_error)
{
    const TemporaryFolder folder;
    const ProgramResult result = run_program({"measure", "frame", kPrismLevel, "--path", "turntable", "--frames", "2",
                                              "--size", "64x48", "--json", folder / "m.json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json rows = read_json(folder / "m.json")["rows"];
    EXPECT_EQ(rows.size() % 8, 0u) << "1 and 4 samples, without the PVS and at three efforts";
    EXPECT_GE(rows.size(), 32u);
    std::vector<std::string> efforts;
    for (std::size_t i = 0; i < 4; ++i) efforts.push_back(rows[i]["pvs"]);
    EXPECT_EQ(efforts, (std::vector<std::string>{"none", "fast", "full", "exact"}));
    for (const json& row : rows) {
        EXPECT_GT(row["median_ms"]["total"], 0.0);
        EXPECT_GE(row["p95_ms"]["total"], row["median_ms"]["total"]);
        EXPECT_TRUE(row["pvs"] == "none" || row["pixels_unlike_without_pvs"] <= 0.0001) << row;
        EXPECT_LE(row["visible_share"], 1.0);
    }
}

TEST(program, render_shows_an_image_of_the_frame)
{
    const TemporaryFolder folder;
    const auto shown = [&](const std::string& key) {
        const ProgramResult result =
            run_program({"render", kPrism, "--size", "64x48", "--show-image", key, "--out", folder / "image.png"});
        return result.exit_code;
    };
    EXPECT_EQ(shown("object_ids"), 0);
    const std::string ids = bytes_of(folder / "image.png");
    EXPECT_EQ(shown("edge_map operator=c1 width_px=2"), 0);
    EXPECT_NE(bytes_of(folder / "image.png"), ids);
    fs::remove(folder / "image.png");
    for (const char* wrong : {"nobody_makes_this", "edge_map width_px", "edge_map width_px=wide", " "})
        EXPECT_EQ(shown(wrong), 2) << wrong;
    EXPECT_FALSE(fs::exists(folder / "image.png"));
}

}  // namespace hw::test
