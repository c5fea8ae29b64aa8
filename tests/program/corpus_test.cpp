// Files that strangers made. They lie beside the project, so the tests skip where they are absent.
#include <gtest/gtest.h>

#include "tests/program/run_program.hpp"
#include "tests/shared_data.hpp"

namespace hw::test {
namespace {
namespace fs = std::filesystem;

std::vector<fs::path> models_in(const fs::path& folder)
{
    std::vector<fs::path> files;
    if (!fs::exists(folder)) return files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string extension = entry.path().extension();
        if (extension == ".gltf" || extension == ".glb") files.push_back(entry.path());
    }
    return files;
}

}  // namespace

TEST(corpus, malformed_files_end_in_a_message_within_two_seconds)
{
    const std::vector<fs::path> files = sampled(models_in(kSharedData / "malformed" / "gltf_validator"), 60);
    HATCHWAY_NEEDS_DATA(!files.empty(), "malformed files beside the project");
    const hw::test::TemporaryFolder folder;
    for (const fs::path& file : files) {
        const ProgramResult result = run_program(
            {"render", file.string(), "--size", "32x32", "--samples", "1", "--out", folder / "a.png"}, 10.0);
        EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 2) << file << ' ' << result.exit_code << '\n'
                                                                    << result.err;
        EXPECT_LT(result.seconds, 2.0) << file;
        EXPECT_TRUE(result.exit_code != 2 || result.err.find("error") != std::string::npos) << file;
    }
}

TEST(corpus, hard_meshes_open_in_every_style)
{
    const std::vector<fs::path> files = models_in(kSharedData / "hard");
    HATCHWAY_NEEDS_DATA(!files.empty(), "hard meshes beside the project");
    const hw::test::TemporaryFolder folder;
    for (const fs::path& file : files)
        for (const char* style : {"*=photoreal", "*=pen_and_ink", "*=hybrid", "*=technical", "*=id_outline"}) {
            std::vector<std::string> arguments{"render", file.string(), "--style", style,
                                               "--size", "64x48",       "--out",   folder / "a.png"};
            // The PVS does not know the style: making it once is enough.
            if (style != std::string("*=photoreal")) arguments.push_back("--no-pvs");
            const ProgramResult result = run_program(arguments, 30.0);
            EXPECT_EQ(result.exit_code, 0) << file << ' ' << style << '\n' << result.err;
        }
}

}  // namespace hw::test
