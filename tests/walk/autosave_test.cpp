#include "hatchway/walk/autosave.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/temporary_folder.hpp"

namespace {
namespace fs = std::filesystem;

/// A folder with a level, and a state folder of the user.
class autosave : public testing::Test {
 protected:
    autosave() { ::setenv("XDG_STATE_HOME", state_.path().c_str(), 1); }
    ~autosave() override { ::unsetenv("XDG_STATE_HOME"); }

    /// A file of the level's folder; there need be none.
    fs::path level(const std::string& name = "a.level.json") const { return folder_.path() / name; }
    static int files_in(const fs::path& folder)
    {
        std::error_code missing;
        return static_cast<int>(std::distance(fs::directory_iterator(folder, missing), fs::directory_iterator()));
    }
    TemporaryFolder folder_, state_;
};

}  // namespace

TEST_F(autosave, keeps_beside_the_level_what_the_next_walk_through_the_same_file_finds)
{
    {
        hw::Autosave first(level());
        EXPECT_EQ(first.left(), "");
        first.keep("one");
        first.keep("two");
    }
    EXPECT_EQ(files_in(folder_.path()), 1) << "no lock is left";
    EXPECT_EQ(files_in(state_.path() / "hatchway"), 0);
    EXPECT_EQ(hw::Autosave(folder_.path() / "." / "a.level.json").left(), "two");
    EXPECT_EQ(hw::Autosave(level("b.level.json")).left(), "");
    hw::Autosave(level()).keep("");
    EXPECT_EQ(hw::Autosave(level()).left(), "");
    EXPECT_EQ(files_in(folder_.path()), 0);
}

TEST_F(autosave, goes_with_a_folder_that_is_moved)
{
    const fs::path before = folder_.path() / "before";
    fs::create_directory(before);
    hw::Autosave(before / "a.level.json").keep("one");
    fs::rename(before, folder_.path() / "after");
    EXPECT_EQ(hw::Autosave(folder_.path() / "after" / "a.level.json").left(), "one");
}

TEST_F(autosave, keeps_walks_at_the_same_time_apart)
{
    {
        hw::Autosave one(level());
        one.keep("one");
        hw::Autosave two(level());
        EXPECT_EQ(two.left(), "") << "what belongs to a walk that goes on is not offered";
        two.keep("two");
        EXPECT_EQ(one.left(), "one");
    }
    hw::Autosave one(level()), two(level());
    EXPECT_EQ(one.left(), "one");
    EXPECT_EQ(two.left(), "two");
}

TEST_F(autosave, offers_what_a_second_walk_left_to_a_walk_alone)
{
    {
        hw::Autosave one(level()), two(level());
        two.keep("two");
    }
    EXPECT_EQ(hw::Autosave(level()).left(), "two");
}

TEST_F(autosave, keeps_in_the_state_folder_where_nothing_can_be_written_beside)
{
    // Root may write everywhere, so a name is taken away instead: what is kept in a folder cannot replace a folder.
    hw::Autosave first(level());
    first.keep("one");
    fs::path kept;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        if (entry.path().extension() == ".json") kept = entry.path();
    fs::remove(kept);
    fs::create_directory(kept);
    first.keep("two");
    EXPECT_EQ(first.left(), "two");
    fs::remove(kept);
    EXPECT_EQ(first.left(), "two");
    first.keep("three");
    EXPECT_EQ(files_in(state_.path() / "hatchway"), 1) << "the lock; the older text is gone";
    EXPECT_EQ(first.left(), "three");
}

TEST_F(autosave, in_a_folder_that_is_not_there_uses_the_state_folder)
{
    const fs::path nowhere = folder_.path() / "none" / "a.level.json";
    hw::Autosave(nowhere).keep("one");
    EXPECT_EQ(hw::Autosave(nowhere).left(), "one");
}

TEST_F(autosave, follows_no_link_that_lies_beside_the_level)
{
    const fs::path secret = state_.write("secret", "mine");
    hw::Autosave(level()).keep("one");
    fs::path kept;
    for (const auto& entry : fs::directory_iterator(folder_.path())) kept = entry.path();
    fs::remove(kept);
    fs::create_symlink(secret, kept);
    hw::Autosave walk(level());
    EXPECT_EQ(walk.left(), "");
    walk.keep("two");
    EXPECT_EQ(hw::read_text_file(secret, 100), "mine");
    EXPECT_EQ(walk.left(), "two");
}

TEST_F(autosave, of_a_file_with_the_longest_name_is_kept)
{
    const std::string name = std::string(246, 'a') + ".glb";
    hw::Autosave(level(name)).keep("one");
    EXPECT_EQ(hw::Autosave(level(name)).left(), "one");
}

TEST_F(autosave, without_any_folder_keeps_nothing_and_throws_nothing)
{
    const std::string file = folder_.write("file", "in the way").string();
    ::setenv("XDG_STATE_HOME", file.c_str(), 1);
    hw::Autosave none(folder_.path() / "none" / "a.level.json");
    none.keep("lost");
    EXPECT_EQ(none.left(), "");
}
