#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string_view>
#include <vector>

// Data that lies beside the project: models, scenes and malformed files of others, which a checkout may lack.

namespace hw::test {

inline const std::filesystem::path kSharedData = std::filesystem::path(HATCHWAY_SOURCE_DIR) / ".." / "shared" / "data";

inline bool is_set(const char* variable)
{
    const char* value = std::getenv(variable);
    return value != nullptr && std::string_view(value) == "1";
}

/// `count` of the files, the same in each run; all of them with HATCHWAY_WHOLE_CORPORA=1, which ./check --all sets.
inline std::vector<std::filesystem::path> sampled(std::vector<std::filesystem::path> files, std::size_t count)
{
    std::sort(files.begin(), files.end());
    if (is_set("HATCHWAY_WHOLE_CORPORA")) return files;
    std::vector<std::filesystem::path> sample;
    std::mt19937 random(20011);
    std::sample(files.begin(), files.end(), std::back_inserter(sample), count, random);
    return sample;
}

}  // namespace hw::test

/// Skips a test whose data is absent; with HATCHWAY_REQUIRE_DATA=1 it fails instead.
#define HATCHWAY_NEEDS_DATA(is_there, what)                                                                \
    if (!(is_there)) {                                                                                     \
        if (hw::test::is_set("HATCHWAY_REQUIRE_DATA")) FAIL() << "HATCHWAY_REQUIRE_DATA, but no " << what; \
        GTEST_SKIP() << "no " << what;                                                                     \
    }                                                                                                      \
    static_assert(true)
