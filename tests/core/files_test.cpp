#include "hatchway/core/files/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hatchway/core/error.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;

/// Files in a folder of their own.
class files : public testing::Test {
 protected:
    files() { hw::write_file_atomically(folder_ / "old", std::string_view("old")); }

    std::string refusal(const std::string& name) const
    {
        try {
            hw::write_file_atomically(folder_ / name, std::string_view("new"));
        } catch (const hw::Error& error) {
            EXPECT_EQ(error.parts().file, (folder_ / name).string());
            return error.parts().what;
        }
        return "";
    }
    std::string text(const std::string& name) const { return hw::read_text_file(folder_ / name, 100); }
    std::ptrdiff_t entry_count() const { return std::distance(fs::directory_iterator(folder_), {}); }

    TemporaryFolder temporary_;
    const fs::path folder_ = temporary_.path();
};

}  // namespace

TEST_F(files, a_write_protected_file_is_not_replaced)
{
    fs::permissions(folder_ / "old", fs::perms{0444});
    EXPECT_EQ(refusal("old"), "cannot write: is write-protected");
    EXPECT_EQ(text("old"), "old");
    EXPECT_EQ(entry_count(), 1);
}

TEST_F(files, a_replaced_file_keeps_its_mode)
{
    fs::permissions(folder_ / "old", fs::perms{0640});
    EXPECT_EQ(refusal("old"), "");
    EXPECT_EQ(text("old"), "new");
    EXPECT_EQ(fs::status(folder_ / "old").permissions(), fs::perms{0640});
    EXPECT_EQ(entry_count(), 1);
}

TEST_F(files, a_link_is_replaced_and_what_it_leads_to_stays)
{
    fs::create_directory(folder_ / "sub");
    fs::create_symlink("old", folder_ / "link");
    fs::create_symlink("to_come", folder_ / "early");
    fs::create_symlink("sub", folder_ / "to_folder");
    fs::create_symlink("round", folder_ / "round");
    for (const char* name : {"link", "early", "to_folder", "round"}) {
        EXPECT_EQ(refusal(name), "") << name;
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder_ / name))) << name;
        EXPECT_EQ(text(name), "new") << name;
    }
    EXPECT_EQ(text("old"), "old");
    EXPECT_FALSE(fs::exists(folder_ / "to_come"));
    EXPECT_TRUE(fs::is_empty(folder_ / "sub"));
}

TEST_F(files, folders_that_a_user_typed_may_be_links)
{
    fs::create_directory(folder_ / "sub");
    fs::create_directory_symlink("sub", folder_ / "typed");
    EXPECT_EQ(refusal("typed/new"), "");
    EXPECT_EQ(text("sub/new"), "new");
}

TEST_F(files, a_name_as_long_as_the_file_system_allows_can_be_written)
{
    EXPECT_EQ(refusal(std::string(255, 'x')), "");
    EXPECT_NE(refusal(std::string(256, 'x')), "");
    EXPECT_EQ(entry_count(), 2);
}

TEST_F(files, what_is_no_file_is_not_replaced)
{
    ASSERT_EQ(::mkfifo((folder_ / "fifo").c_str(), 0600), 0);
    fs::create_directory(folder_ / "sub");
    for (const char* name : {"fifo", "sub"}) EXPECT_EQ(refusal(name), "cannot write: is not a regular file");
    EXPECT_TRUE(fs::is_fifo(folder_ / "fifo"));
}

TEST_F(files, a_folder_that_is_missing_is_refused)
{
    EXPECT_THROW(hw::write_file_atomically(folder_ / "missing/new", std::string_view("new")), hw::Error);
}

TEST_F(files, no_link_below_the_root_is_followed_wherever_it_leads)
{
    fs::create_directory(folder_ / "sub");
    fs::create_symlink(folder_ / "none" / "yet", folder_ / "out");
    fs::create_symlink("old", folder_ / "in");
    fs::create_directory_symlink(".", folder_ / "sub/loop");
    fs::create_directory_symlink("sub", folder_ / "alias");
    const auto resolve = [&](const char* path) {
        return hw::resolve_inside(folder_, folder_, path, "level", "/scene");
    };
    const fs::path root = fs::canonical(folder_);
    EXPECT_EQ(resolve("old"), root / "old");
    EXPECT_EQ(resolve("sub/../old"), root / "old");
    EXPECT_EQ(resolve("new/file"), root / "new/file");
    EXPECT_EQ(resolve("sub/"), root / "sub");
    for (const char* path : {"out", "out/file", "in", "sub/loop/loop/a", "alias/a", "alias", "../x", "sub/../../x"})
        EXPECT_THROW(resolve(path), hw::Error) << path;
    EXPECT_EQ(hw::resolve_inside(folder_, folder_ / "alias", "a", "level", ""), root / "sub/a") << "the user typed it";
}
