// The examples of docs/write_a_style.md are the files of docs/examples, word for word: out_of_tree_test.cpp builds and
// draws them.
#include <gtest/gtest.h>

#include "hatchway/core/files/files.hpp"

namespace {
namespace fs = std::filesystem;

const fs::path kDocs = fs::path(HATCHWAY_SOURCE_DIR) / "docs";

std::string text_of(const fs::path& file)
{
    return hw::read_text_file(file, 1 << 20);
}

TEST(manual, prints_every_example_word_for_word)
{
    const std::string page = text_of(kDocs / "write_a_style.md");
    int found = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kDocs / "examples")) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".cpp" && extension != ".frag") continue;
        const std::string block = (extension == ".cpp" ? "```cpp\n" : "```glsl\n") + text_of(entry.path()) + "```";
        EXPECT_NE(page.find(block), std::string::npos) << entry.path() << " differs from what the page prints";
        ++found;
    }
    EXPECT_GE(found, 10);
}

}  // namespace
