#include "hatchway/core/files/user_folders.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/recent_files.hpp"
#include "tests/temporary_folder.hpp"

namespace {
namespace fs = std::filesystem;

/// A home of its own for one test, with the process's environment put back at the end.
class user_folders : public testing::Test {
 protected:
    user_folders()
    {
        set("HOME", home_.path());
        for (const char* name : {"XDG_CACHE_HOME", "XDG_STATE_HOME"}) set(name, "");
    }
    ~user_folders() override
    {
        for (const auto& [name, value] : before_) ::setenv(name.c_str(), value.c_str(), 1);
    }
    void set(const std::string& name, const std::string& value)
    {
        if (const char* old = std::getenv(name.c_str())) before_.emplace_back(name, old);
        ::setenv(name.c_str(), value.c_str(), 1);
    }

    TemporaryFolder home_;
    std::vector<std::pair<std::string, std::string>> before_;
};

}  // namespace

TEST_F(user_folders, are_made_for_the_user_alone)
{
    EXPECT_EQ(hw::user_cache_folder().path(), home_.path() / ".cache/hatchway");
    EXPECT_EQ(hw::user_state_folder().path(), home_.path() / ".local/state/hatchway");
    for (const char* name : {".cache/hatchway", ".local/state/hatchway"})
        EXPECT_EQ(fs::status(home_.path() / name).permissions(), fs::perms::owner_all) << name;
}

TEST_F(user_folders, lie_where_the_environment_says)
{
    set("XDG_CACHE_HOME", home_.path() / "a/b");
    EXPECT_EQ(hw::user_cache_folder().path(), home_.path() / "a/b/hatchway");
    set("XDG_CACHE_HOME", "relative");
    EXPECT_EQ(hw::user_cache_folder().path(), home_.path() / ".cache/hatchway");
    set("HOME", "");
    EXPECT_THROW(hw::user_cache_folder(), hw::Error);
}

TEST_F(user_folders, may_lie_on_another_disk_by_a_link_of_the_user)
{
    fs::create_directories(home_.path() / "disk/hatchway");
    fs::create_directory_symlink("disk", home_.path() / ".cache");
    hw::user_cache_folder().write("a", {});
    EXPECT_TRUE(fs::exists(home_.path() / "disk/hatchway/a")) << "the folder that the environment names";
    fs::remove(home_.path() / ".cache");
    fs::create_directory(home_.path() / ".cache");
    fs::create_directory_symlink("../disk/hatchway", home_.path() / ".cache/hatchway");
    EXPECT_TRUE(hw::user_cache_folder().read("a", 10)) << "the program's own";
    fs::permissions(home_.path() / "disk/hatchway", fs::perms::all);
    EXPECT_THROW(hw::user_cache_folder(), hw::Error) << "others may write into it";
    fs::remove_all(home_.path() / "disk");
    EXPECT_THROW(hw::user_cache_folder(), hw::Error) << "a link to nothing";
}

TEST_F(user_folders, that_others_could_have_filled_are_refused)
{
    fs::create_directories(home_.path() / ".cache");
    if (::geteuid() == 0) {
        fs::create_directories(home_.path() / "elsewhere");
        fs::permissions(home_.path() / "elsewhere", fs::perms::owner_all);
        fs::create_directory_symlink("../elsewhere", home_.path() / ".cache/hatchway");
        ASSERT_EQ(::lchown((home_.path() / ".cache/hatchway").c_str(), 12345, 12345), 0);
        EXPECT_THROW(hw::user_cache_folder(), hw::Error) << "somebody else's link";
        fs::remove(home_.path() / ".cache/hatchway");
    }
    hw::user_cache_folder();
    for (const fs::perms others : {fs::perms::group_write, fs::perms::others_write}) {
        fs::permissions(home_.path() / ".cache/hatchway", fs::perms::owner_all | others);
        EXPECT_THROW(hw::user_cache_folder(), hw::Error);
    }
    if (::geteuid() != 0) return;
    fs::permissions(home_.path() / ".cache/hatchway", fs::perms::owner_all);
    ASSERT_EQ(::chown((home_.path() / ".cache/hatchway").c_str(), 12345, 12345), 0);
    EXPECT_THROW(hw::user_cache_folder(), hw::Error) << "somebody else's";
}

TEST_F(user_folders, keep_what_was_used_last)
{
    const hw::FolderHandle folder = hw::user_cache_folder();
    const std::vector<std::byte> bytes(100);
    const auto is_there = [&](const std::string& name) { return fs::exists(folder.path() / name); };
    for (int i = 0; i < 4; ++i) {
        folder.write(std::to_string(i), bytes);
        fs::last_write_time(folder.path() / std::to_string(i),
                            fs::file_time_type::clock::now() - std::chrono::hours(9 - i));
    }
    fs::create_symlink("/etc/hostname", folder.path() / "link");
    hw::note_use(folder, "0");
    hw::keep_recent(folder, 250);
    EXPECT_TRUE(is_there("0")) << "used just now";
    EXPECT_FALSE(is_there("1"));
    EXPECT_FALSE(is_there("2"));
    EXPECT_TRUE(is_there("3"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link")) << "what is no file of ours stays";
    hw::keep_recent(folder, 10);
    EXPECT_TRUE(is_there("0")) << "the newest stays, however large";
    EXPECT_FALSE(is_there("3"));
}
