// Rows are the same on every machine only if no function decides about them whose last bit differs between C libraries
// and processors. IEEE prescribes the bits of + - * / and of sqrt and fma alone.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace fs = std::filesystem;

TEST(visibility, calls_no_function_whose_bits_are_the_machines)
{
    const std::regex inexact(
        R"(\b(?:std|glm)::(pow|exp2?|expm1|log(?:2|10|1p)?|cbrt|hypot|a?(?:sin|cos|tan)h?|atan2|erf|[lt]gamma)\()");
    ASSERT_TRUE(std::regex_search(std::string("x = std::pow(y, 4.0);"), inexact));
    const fs::path sources = fs::path(HATCHWAY_SOURCE_DIR) / "scenegraph";
    std::size_t files = 0;
    for (const char* folder : {"world/visibility", "geometry/exact"})
        for (const auto& entry : fs::recursive_directory_iterator(sources / folder)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
            ++files;
            std::ostringstream text;
            text << std::ifstream(entry.path()).rdbuf();
            const std::string source = std::regex_replace(text.str(), std::regex("//[^\n]*"), "");
            std::smatch found;
            EXPECT_FALSE(std::regex_search(source, found, inexact)) << entry.path() << ": " << found.str();
        }
    EXPECT_GT(files, 40u);
}
