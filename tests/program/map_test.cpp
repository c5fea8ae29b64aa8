// `hatchway map` and what `info` says of hatching, from outside.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hatchway/io/images/images.hpp"
#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {

using nlohmann::json;

const std::string kPrism = (kContent / "models" / "prism.glb").string();

/// Dark level lines on white.
void write_drawing(const std::string& file, int lines)
{
    Pixels drawing{.width = 128, .height = 128, .channels = 1, .bytes = std::vector<std::uint8_t>(128 * 128, 255)};
    for (int line = 0; line < lines; ++line)
        for (int x = 8; x < 120; ++x)
            for (int y = 0; y < 2; ++y) *drawing.at(x, 8 + line * 12 + y) = 0;
    write_png(file, drawing);
}

}  // namespace

TEST(map_program, inks_a_bitmap_anew_with_ever_fewer_of_its_strokes)
{
    const TemporaryFolder folder;
    write_drawing(folder / "lines.png", 10);
    const ProgramResult result =
        run_program({"map", "ink", folder / "lines.png", "--width", "128", "--out", folder / "map"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, testing::HasSubstr("level 0: 10 of 10 strokes"));
    EXPECT_THAT(result.out, testing::HasSubstr("level 1: 5 of 10 strokes"));
    EXPECT_EQ(json::parse(bytes_of(folder / "map/map.json"))["kind"], "ink");
}

TEST(map_program, filters_only_when_asked_and_refuses_drawings_without_ink)
{
    const TemporaryFolder folder;
    write_drawing(folder / "lines.png", 10);
    write_drawing(folder / "empty.png", 0);
    const auto level_1 = [&](const std::string& filter) {
        const std::string out = folder / filter;
        EXPECT_EQ(run_program({"map", "ink", folder / "lines.png", "--width", "128", "--filter", filter, "--out", out})
                      .exit_code,
                  0);
        return bytes_of(out + "/level_1.png");
    };
    EXPECT_NE(level_1("minimum"), level_1("box"));
    EXPECT_NE(level_1("minimum"), level_1("none"));
    const ProgramResult refused = run_program({"map", "ink", folder / "empty.png", "--out", folder / "map"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.err, testing::HasSubstr("no ink"));
    EXPECT_THAT(folder.names(), testing::Not(testing::Contains("map")));
}

TEST(map_program, refuses_a_preview_in_place_of_the_map_and_writes_nothing)
{
    const TemporaryFolder folder;
    const ProgramResult result = run_program({"map", "hatch", "--out", folder / "map", "--preview", folder / "map"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, testing::HasSubstr("--preview"));
    EXPECT_FALSE(std::filesystem::exists(folder / "map"));
}

TEST(map_program, names_what_it_passes_over_in_a_drawing)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "wall.svg") << "<svg viewBox='0 0 9 9'><rect width='9'/><g transform='scale(2)'>"
                                          "<line x1='1' y1='1' x2='8' y2='8'/></g></svg>";
    const ProgramResult result =
        run_program({"map", "ink", folder / "wall.svg", "--width", "128", "--out", folder / "map"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr("<rect>, transform passed over"));
}

TEST(map_program, replaces_a_map_whole_and_no_other_folder)
{
    const TemporaryFolder folder;
    const auto map = [&](const std::string& out, const std::string& width, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"map", "hatch", "--width", width, "--out", out});
        return run_program(more);
    };
    const std::string place = folder / "map";
    ASSERT_EQ(map(place, "256", {"--preview", place + "/preview.png"}).exit_code, 0);
    ASSERT_TRUE(std::filesystem::exists(place + "/level_8.png"));
    ASSERT_EQ(map(place, "64", {"--preview", place + "/preview.png"}).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(place + "/level_8.png")) << "a level of the map before";
    folder.write("map/notes.txt", "mine");
    for (const std::string& out : {place, folder.path().string(), std::string(".")}) {
        const ProgramResult refused = map(out, "64");
        EXPECT_EQ(refused.exit_code, 2) << out;
        EXPECT_THAT(refused.err, testing::HasSubstr("--out"));
    }
    EXPECT_EQ(bytes_of(folder / "map/notes.txt"), "mine");
    EXPECT_THAT(folder.names(), testing::ElementsAre("map"));
}

TEST(map_program, keeps_pictures_that_are_no_map_s)
{
    const TemporaryFolder folder;
    for (const char* description : {"", "{\"format\": \"another/1\"}"}) {
        std::filesystem::create_directory(folder.path() / "mine");
        folder.write("mine/level_0.png", "my picture");
        if (*description != '\0') folder.write("mine/map.json", description);
        const ProgramResult refused = run_program({"map", "hatch", "--width", "64", "--out", folder / "mine"});
        EXPECT_EQ(refused.exit_code, 2) << description;
        EXPECT_THAT(refused.err, testing::HasSubstr("--out: holds "));
        EXPECT_EQ(bytes_of(folder / "mine/level_0.png"), "my picture");
    }
}

TEST(map_program, a_priority_map_is_square)
{
    const TemporaryFolder folder;
    ASSERT_EQ(
        run_program({"map", "tonal", "--priority", "--tones", "4", "--width", "64", "--out", folder / "map"}).exit_code,
        0);
    const Pixels finest = read_image(folder / "map/level_0.png");
    EXPECT_EQ(finest.width, 64);
    EXPECT_EQ(finest.height, 64);
}

TEST(map_program, info_counts_where_hatching_breaks)
{
    const TemporaryFolder folder;
    ASSERT_EQ(run_program({"info", kPrism, "--hatch", "box", "--json", folder / "i.json"}).exit_code, 0);
    const json info = json::parse(bytes_of(folder / "i.json"));
    EXPECT_EQ(info["hatch_source"], "box");
    EXPECT_EQ(info["hatch_charts"], 10) << "two caps and eight sides";
    EXPECT_EQ(info["hatch_creases"], 24);
    EXPECT_EQ(info["hatch_chart_borders"], 0);
    EXPECT_EQ(info["hatch_singularities"], 0);
}

}  // namespace hw::test
