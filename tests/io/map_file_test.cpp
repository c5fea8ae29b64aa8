#include "hatchway/io/images/map_file.hpp"

#include <gtest/gtest.h>

#include "hatchway/io/images/images.hpp"
#include "tests/io/expect_error.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;

void write_gray(const fs::path& file, int width, int height, int channels = 1)
{
    const hw::Pixels pixels{
        .width = width,
        .height = height,
        .channels = channels,
        .bytes = std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * channels, 128)};
    hw::write_png(file, pixels);
}

constexpr const char* kInk =
    R"({"format": "hatchway-map/1", "kind": "ink", "levels": 3, "size_m": 2.5, "spacing_texels": 16})";

}  // namespace

TEST(map_file, levels_are_read_from_fine_to_coarse)
{
    const TemporaryFolder folder;
    folder.write("map.json", kInk);
    write_gray(folder.path() / "level_0.png", 8, 4);
    write_gray(folder.path() / "level_1.png", 4, 2);
    write_gray(folder.path() / "level_2.png", 2, 1);
    const hw::MapLevels map = hw::read_map(folder.path());
    EXPECT_EQ(map.kind, hw::MapKind::ink);
    EXPECT_EQ(map.size_m, 2.5);
    EXPECT_EQ(map.spacing_texels, 16.0);
    ASSERT_EQ(map.levels.size(), 3u);
    EXPECT_EQ(map.levels[2].width, 2);
}

TEST(map_file, a_level_that_is_not_half_the_one_before_is_refused)
{
    const TemporaryFolder folder;
    folder.write("map.json", kInk);
    write_gray(folder.path() / "level_0.png", 8, 4);
    write_gray(folder.path() / "level_1.png", 4, 3);
    const auto parts = error_of([&] { hw::read_map(folder.path()); });
    EXPECT_THAT(parts.file, testing::EndsWith("level_1.png"));
    EXPECT_THAT(parts.expected, testing::HasSubstr("4 x 2"));
}

TEST(map_file, colours_missing_levels_and_high_hatch_maps_are_refused)
{
    const TemporaryFolder folder;
    folder.write("map.json", kInk);
    EXPECT_THROW(hw::read_map(folder.path()), hw::Error) << "no level";
    write_gray(folder.path() / "level_0.png", 8, 4, 3);
    EXPECT_THROW(hw::read_map(folder.path()), hw::Error) << "three channels";
    folder.write("map.json", R"({"format": "hatchway-map/1", "kind": "hatch", "levels": 1})");
    write_gray(folder.path() / "level_0.png", 8, 4);
    EXPECT_THROW(hw::read_map(folder.path()), hw::Error) << "four texels high";
    write_gray(folder.path() / "level_0.png", 8, 1);
    EXPECT_EQ(hw::read_map(folder.path()).kind, hw::MapKind::hatch);
}

TEST(map_file, ramps_are_strips_of_colour_with_one_level_and_images_are_pictures)
{
    const TemporaryFolder folder;
    folder.write("map.json", R"({"format": "hatchway-map/1", "kind": "ramp", "levels": 1})");
    write_gray(folder.path() / "level_0.png", 8, 2, 3);
    EXPECT_THROW(hw::read_map(folder.path()), hw::Error) << "two texels high";
    write_gray(folder.path() / "level_0.png", 8, 1, 3);
    EXPECT_EQ(hw::read_map(folder.path()).kind, hw::MapKind::ramp);
    folder.write("map.json", R"({"format": "hatchway-map/1", "kind": "ramp", "levels": 2})");
    write_gray(folder.path() / "level_1.png", 4, 1, 3);
    EXPECT_THROW(hw::read_map(folder.path()), hw::Error) << "two levels";
    folder.write("map.json", R"({"format": "hatchway-map/1", "kind": "image", "levels": 2})");
    EXPECT_EQ(hw::read_map(folder.path()).levels[1].channels, 3);
}

TEST(map_file, a_wrong_description_is_named_by_its_pointer)
{
    const std::pair<const char*, const char*> cases[] = {
        {R"({"format": "hatchway-map/2", "kind": "ink", "levels": 1})", "/format"},
        {R"({"format": "hatchway-map/1", "kind": "oil", "levels": 1})", "/kind"},
        {R"({"format": "hatchway-map/1", "kind": "ink", "levels": 0})", "/levels"},
        {R"({"format": "hatchway-map/1", "kind": "ink", "levels": 1.5})", "/levels"},
        {R"({"format": "hatchway-map/1", "kind": "ink", "levels": 1000000})", "/levels"},
        {R"({"format": "hatchway-map/1", "kind": "ink", "levels": 1, "size_m": -1})", "/size_m"},
        {R"({"format": "hatchway-map/1", "kind": "ink", "levels": 1, "size": 1})", "/size"},
    };
    for (const auto& [text, pointer] : cases) {
        const TemporaryFolder folder;
        folder.write("map.json", text);
        write_gray(folder.path() / "level_0.png", 8, 8);
        EXPECT_EQ(error_of([&] { hw::read_map(folder.path()); }).pointer, pointer) << text;
    }
}

TEST(map_file, maps_stay_inside_of_the_project)
{
    const TemporaryFolder folder;
    folder.write("project/maps/stone/map.json", kInk);
    folder.write("outside/map.json", kInk);
    hw::Level level;
    level.file = folder.path() / "project/level.json";
    level.project_root = folder.path() / "project";
    EXPECT_EQ(hw::find_map(level, hw::MapKind::ink, "maps/stone", "/a"),
              fs::canonical(folder.path() / "project/maps/stone"));
    for (const char* name : {"../outside", "maps/missing", "no_such_built_in_map", "/etc"})
        EXPECT_EQ(error_of([&] { hw::find_map(level, hw::MapKind::ink, name, "/a"); }).pointer, "/a") << name;
    folder.write("project/mp/map.json", kInk);
    EXPECT_EQ(hw::find_map(level, hw::MapKind::ink, "mp", "/a"), fs::canonical(folder.path() / "project/mp"))
        << "a folder beside the level, where no built-in map has its name";
    fs::create_symlink(folder.path() / "outside/map.json", folder.path() / "project/maps/stone/level_0.png");
    EXPECT_THAT(error_of([&] { hw::read_map(folder.path() / "project/maps/stone"); }).what,
                testing::HasSubstr("goes through the link"));
}

TEST(map_file, the_maps_of_the_project_can_be_read)
{
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(HATCHWAY_SOURCE_DIR) / "content/maps")) {
        if (entry.path().filename() != "map.json") continue;
        EXPECT_NO_THROW(hw::read_map(entry.path().parent_path())) << entry.path();
        ++count;
    }
    EXPECT_GT(count, 0);
}

TEST(map_file, a_description_that_is_a_link_out_of_the_map_is_refused)
{
    const TemporaryFolder folder;
    folder.write("outside.json", kInk);
    fs::create_directory(folder.path() / "stone");
    fs::create_symlink("../outside.json", folder.path() / "stone/map.json");
    EXPECT_THAT(error_of([&] { hw::read_map(folder.path() / "stone"); }).what,
                testing::HasSubstr("goes through the link"));
}

TEST(map_file, a_missing_format_says_which_is_expected)
{
    const TemporaryFolder folder;
    folder.write("map.json", R"({"kind": "ink", "levels": 1})");
    EXPECT_EQ(error_of([&] { hw::read_map(folder.path()); }).expected, "\"hatchway-map/1\"");
}
