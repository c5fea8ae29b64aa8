#include "hatchway/stage/file_watch.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace {
namespace fs = std::filesystem;

class file_watch : public testing::Test {
 protected:
    file_watch() : folder_(fs::temp_directory_path() / ("hatchway_watch_" + std::to_string(::getpid())))
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "map");
        write("level.json", "a");
        write("map/level_0.png", "b");
        watch_.watch({folder_ / "level.json", folder_ / "map"});
    }
    ~file_watch() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
    std::vector<fs::path> changed() { return watch_.changed(); }

    fs::path folder_;
    hw::FileWatch watch_{std::chrono::milliseconds(0)};
};

}  // namespace

TEST_F(file_watch, is_silent_while_nothing_changes)
{
    EXPECT_TRUE(changed().empty());
    EXPECT_TRUE(changed().empty());
}

TEST_F(file_watch, tells_a_changed_file_once)
{
    write("level.json", "longer");
    EXPECT_EQ(changed(), std::vector<fs::path>{folder_ / "level.json"});
    EXPECT_TRUE(changed().empty());
}

TEST_F(file_watch, names_a_folder_where_a_file_came_or_went)
{
    watch_.watch({folder_ / "map"});
    write("map/level_1.png", "new");
    EXPECT_EQ(changed(), std::vector<fs::path>{folder_ / "map"});
    fs::remove(folder_ / "map/level_1.png");
    fs::last_write_time(folder_ / "map", fs::file_time_type::clock::now() + std::chrono::seconds(2));
    EXPECT_EQ(changed(), std::vector<fs::path>{folder_ / "map"});
}

TEST_F(file_watch, walks_no_tree_however_its_links_go_round)
{
    for (const char* name : {"map/a", "map/b"}) fs::create_directory_symlink(".", folder_ / name);
    const auto start = std::chrono::steady_clock::now();
    hw::FileWatch watch{std::chrono::milliseconds(0)};
    watch.watch({folder_ / "map"});
    EXPECT_TRUE(watch.changed().empty());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST_F(file_watch, waits_for_a_file_that_an_editor_replaces)
{
    fs::remove(folder_ / "level.json");
    EXPECT_TRUE(changed().empty());
    write("level.json", "back again");
    EXPECT_EQ(changed().size(), 1u);
}

TEST_F(file_watch, looks_no_more_often_than_its_period)
{
    hw::FileWatch slow(std::chrono::hours(1));
    slow.watch({folder_ / "level.json"});
    EXPECT_TRUE(slow.changed().empty());
    write("level.json", "longer");
    EXPECT_TRUE(slow.changed().empty());
}
