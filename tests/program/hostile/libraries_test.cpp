// A folder of a stranger may hold libraries under any name: the program takes none from where it is run.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;

/// The names of all libraries of this process, which are those of the program.
std::vector<std::string> library_names()
{
    std::vector<std::string> names;
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);)
        if (line.find(".so") != std::string::npos) names.push_back(line.substr(line.rfind('/') + 1));
    return names;
}

TEST(libraries, are_never_taken_from_the_current_folder)
{
    const TemporaryFolder folder;
    const std::vector<std::string> names = library_names();
    ASSERT_GT(names.size(), 20u);
    for (const std::string& name : names) folder.write(name, "no library");
    for (const char* name : {"libhatchway.so.0", "libEGL.so.1", "libEGL_mesa.so.0", "libGL.so.1", "libGLESv2.so.2",
                             "libOpenGL.so.0", "libepoxy.so.0", "libglfw.so.3", "libpng16.so.16", "libjpeg.so.62",
                             "libfmt.so.9", "libspdlog.so.1.10", "libtbb.so.12", "libembree3.so.3", "libcairo.so.2"})
        folder.write(name, "no library");
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    const ProgramResult result =
        run_program({"render", (kContent / "models/prism.glb").string(), "--size", "64x64", "--out", "p.png"});
    fs::current_path(before);
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace
}  // namespace hw::test
