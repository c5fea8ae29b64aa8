#include "hatchway/core/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hatchway/core/error.hpp"

namespace {

namespace fs = std::filesystem;

/// Files in a folder of their own.
class files : public testing::Test {
 protected:
    files()
    {
        std::string name = (fs::temp_directory_path() / "hatchway_files_XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        hw::write_file_atomically(folder_ / "old", std::string_view("old"));
    }
    ~files() override { fs::remove_all(folder_); }

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

    fs::path folder_;
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

TEST_F(files, a_link_stays_a_link_and_its_target_is_written)
{
    fs::create_directory(folder_ / "sub");
    fs::create_symlink("../old", folder_ / "sub/link");
    fs::create_symlink("sub/link", folder_ / "link");
    fs::create_symlink("to_come", folder_ / "early");
    EXPECT_EQ(refusal("link"), "");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link") && fs::is_symlink(folder_ / "sub/link"));
    EXPECT_EQ(text("old"), "new");
    EXPECT_EQ(refusal("early"), "");
    EXPECT_TRUE(fs::is_symlink(folder_ / "early"));
    EXPECT_EQ(text("to_come"), "new");
}

TEST_F(files, links_that_go_round_are_refused)
{
    fs::create_symlink("b", folder_ / "a");
    fs::create_symlink("a", folder_ / "b");
    EXPECT_NE(refusal("a"), "");
    EXPECT_TRUE(fs::is_symlink(folder_ / "a"));
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
    EXPECT_NE(refusal("missing/new"), "");
}

TEST_F(files, links_that_lead_nowhere_stay_unresolved)
{
    fs::create_symlink(folder_ / "none" / "yet", folder_ / "out");
    fs::create_symlink("old", folder_ / "in");
    const auto resolve = [&](const char* path) {
        return hw::resolve_inside(folder_, folder_, path, "level", "/scene");
    };
    EXPECT_EQ(resolve("in"), fs::canonical(folder_) / "old");
    EXPECT_EQ(resolve("new/file"), fs::canonical(folder_) / "new/file");
    for (const char* path : {"out", "out/file"}) EXPECT_THROW(resolve(path), hw::Error) << path;
}
