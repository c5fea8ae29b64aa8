#include "hatchway/core/glob.hpp"

#include <fnmatch.h>
#include <gtest/gtest.h>

#include <random>

namespace {

/// Patterns and texts over so few characters that about every tenth pair matches.
class RandomGlobs {
 public:
    std::string pattern()
    {
        std::string pattern;
        while (below(6) != 0) {
            const int kind = below(10);
            if (kind == 0 && !pattern.ends_with('*'))
                pattern += '*';
            else if (kind == 1)
                pattern += '?';
            else if (kind == 2)
                pattern += a_class();
            else
                pattern += character();
        }
        return pattern;
    }
    std::string text()
    {
        std::string text;
        while (below(5) != 0) text += character();
        return text;
    }

 private:
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    char character() { return "abc/"[below(4)]; }
    std::string a_class()
    {
        static constexpr const char* kParts[]{"a", "b", "a-b", "b-c", "c", "ab", "a-c", "-"};
        return std::string("[") + (below(3) == 0 ? "!" : "") + kParts[below(8)] + (below(2) == 0 ? "c" : "") + ']';
    }

    std::mt19937 random_{7};
};

}  // namespace

TEST(glob, without_double_stars_says_what_fnmatch_says)
{
    RandomGlobs next;
    int matches = 0;
    for (int i = 0; i < 200'000; ++i) {
        const std::string pattern = next.pattern(), text = next.text();
        if (pattern == "*") continue;  // means everything here, also across '/'
        const bool expected = ::fnmatch(pattern.c_str(), text.c_str(), FNM_PATHNAME | FNM_NOESCAPE) == 0;
        ASSERT_EQ(hw::glob_matches(pattern, text), expected) << pattern << " of " << text;
        matches += expected;
    }
    EXPECT_GT(matches, 4'000);
}
