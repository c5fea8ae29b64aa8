#include "hatchway/plugin_host/new_style.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hatchway/core/files/files.hpp"
#include "tests/plugin_host/plugin_tests.hpp"
#include "tests/temporary_folder.hpp"

using namespace hw;
using namespace hw::test;
using testing::HasSubstr;

namespace {

namespace fs = std::filesystem;

}  // namespace

TEST(new_style, writes_all_files_with_the_style_s_name_in_them)
{
    const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    const auto files = write_new_style("soft_pencil", folder);
    EXPECT_EQ(files.size(), 4u);
    const std::string source = read_text_file(folder / "soft_pencil" / "soft_pencil.cpp", 100000);
    EXPECT_THAT(source, HasSubstr("HW_STYLE(soft_pencil, "));
    EXPECT_THAT(source, HasSubstr("class SoftPencil final"));
    for (const fs::path& file : files) EXPECT_EQ(read_text_file(file, 100000).find('@'), std::string::npos) << file;
}

TEST(new_style, the_class_is_at_most_sixty_lines_long)
{
    const TemporaryFolder temporary;
    write_new_style("soft_pencil", temporary.path());
    const std::string source = read_text_file(temporary.path() / "soft_pencil" / "soft_pencil.cpp", 100000);
    EXPECT_LE(lines_of_code(source), 60);
    EXPECT_GE(lines_of_code(source), 30) << "a complete style";
}

TEST(new_style, refuses_a_bad_name_and_writes_nothing)
{
    const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    for (const char* name : {"", "Pencil", "2b", "../x", "a-b"})
        EXPECT_THAT(refusal([&] { write_new_style(name, folder); }), HasSubstr("expected a-z, 0-9 and _")) << name;
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST(new_style, refuses_to_write_over_something)
{
    const TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
    fs::create_directories(folder / "pencil");
    EXPECT_THAT(refusal([&] { write_new_style("pencil", folder); }), HasSubstr("already something of that name"));
}
