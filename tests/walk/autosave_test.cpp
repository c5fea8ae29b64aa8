#include "hatchway/walk/autosave.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/temporary_folder.hpp"

namespace {

/// A state folder of its own.
class autosave : public testing::Test {
 protected:
    autosave() { ::setenv("XDG_STATE_HOME", folder_.path().c_str(), 1); }
    ~autosave() override { ::unsetenv("XDG_STATE_HOME"); }

    TemporaryFolder folder_;
};

}  // namespace

TEST_F(autosave, keeps_what_the_next_walk_through_the_same_file_finds)
{
    {
        hw::Autosave first("a.level.json");
        EXPECT_EQ(first.left(), "");
        first.keep("one");
        first.keep("two");
    }
    EXPECT_EQ(hw::Autosave("./a.level.json").left(), "two");
    EXPECT_EQ(hw::Autosave("b.level.json").left(), "");
    hw::Autosave("a.level.json").keep("");
    EXPECT_EQ(hw::Autosave("a.level.json").left(), "");
}

TEST_F(autosave, keeps_walks_at_the_same_time_apart)
{
    {
        hw::Autosave one("a.level.json");
        one.keep("one");
        hw::Autosave two("a.level.json");
        EXPECT_EQ(two.left(), "") << "what belongs to a walk that goes on is not offered";
        two.keep("two");
        EXPECT_EQ(one.left(), "one");
    }
    hw::Autosave one("a.level.json"), two("a.level.json");
    EXPECT_EQ(one.left(), "one");
    EXPECT_EQ(two.left(), "two");
}

TEST_F(autosave, without_a_folder_keeps_nothing_and_throws_nothing)
{
    const std::string file = folder_.write("file", "in the way").string();
    ::setenv("XDG_STATE_HOME", file.c_str(), 1);
    hw::Autosave none("a.level.json");
    none.keep("lost");
    EXPECT_EQ(none.left(), "");
}
