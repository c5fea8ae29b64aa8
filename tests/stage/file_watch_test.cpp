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

TEST_F(file_watch, names_the_folder_of_a_changed_file)
{
    write("map/level_0.png", "longer");
    EXPECT_EQ(changed(), std::vector<fs::path>{folder_ / "map"});
    write("map/level_1.png", "new");
    EXPECT_EQ(changed(), std::vector<fs::path>{folder_ / "map"});
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
