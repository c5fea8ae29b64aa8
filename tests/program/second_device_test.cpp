// Pictures of one OpenGL implementation beside those of others: what looks right on one may lean on its habits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hatchway/io/images/images.hpp"
#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

struct Shown {
    std::string name;
    Words arguments;
};

Words hall_in(const std::string& style)
{
    return {
        (kContent / "models/hall.glb").string(), "--style", "*=" + style, "--eye", "0,1.7,9.6", "--target", "0,3,-9"};
}

std::vector<Shown> what_is_shown()
{
    Words from_above = hall_in("pen_and_ink");
    from_above[4] = "0,9,0.1";
    from_above[6] = "0,0,0";
    from_above.insert(from_above.end(), {"--ortho", "14"});
    return {{"hall_photoreal", hall_in("photoreal")},
            {"hall_pen_and_ink", hall_in("pen_and_ink")},
            {"hall_hybrid", hall_in("hybrid")},
            {"hall_technical", hall_in("technical")},
            {"hall_id_outline", hall_in("id_outline")},
            {"hall_plan", from_above},
            {"prism_level", {(kContent / "levels/prism.level.json").string()}},
            {"hall_level", {(kContent / "levels/hall.level.json").string(), "--camera", "entrance"}}};
}

struct Device {
    Words options;      ///< For `render`.
    Words environment;  ///< What chooses the device.
};

/// What two pictures of the same view differ in.
struct Difference {
    int inked = 0;    ///< Pixels of the first that are not paper.
    int unlike = 0;   ///< Pixels more than kUnlike apart.
    int largest = 0;  ///< Of all channels, of 255.
};

const Words kOneSample{"--samples", "1"};  ///< All that some devices have.
constexpr int kUnlike = 16;
constexpr int kPaper = 250;

Difference difference(const Pixels& a, const Pixels& b)
{
    Difference found;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            int apart = 0;
            for (int k = 0; k < 3; ++k) apart = std::max(apart, std::abs(a.at(x, y)[k] - b.at(x, y)[k]));
            found.inked += std::min({a.at(x, y)[0], a.at(x, y)[1], a.at(x, y)[2]}) < kPaper ? 1 : 0;
            found.unlike += apart > kUnlike ? 1 : 0;
            found.largest = std::max(found.largest, apart);
        }
    return found;
}

struct Picture {
    Pixels pixels;
    std::string device;
};

Picture picture_of(const Shown& shown, const Device& device)
{
    const TemporaryFolder folder;
    Words words{"render"};
    for (const Words& more : {shown.arguments, device.options}) words.insert(words.end(), more.begin(), more.end());
    const std::string png = folder / "p.png", json = folder / "p.json";
    for (const std::string& word : Words{"--size", "320x200", "--out", png, "--json", json}) words.push_back(word);
    const ProgramResult result = run_program(words, 120.0, device.environment);
    EXPECT_EQ(result.exit_code, 0) << shown.name << ": " << result.err;
    if (result.exit_code != 0) return {};
    return {read_image(png), nlohmann::json::parse(bytes_of(json)).at("device")};
}

/// Where and by which build results are made, as `hatchway measure` says it.
nlohmann::ordered_json origin()
{
    const TemporaryFolder folder;
    const std::string json = folder / "bsp.json";
    EXPECT_EQ(
        run_program({"measure", "bsp", kContent / "models/prism.glb", "--points", "1000", "--json", json}).exit_code,
        0);
    auto result = nlohmann::ordered_json::parse(bytes_of(json)).at("origin");
    result["command"] = "test_program --gtest_filter='second_device.*'";
    return result;
}

/// For docs/method/devices.md: HATCHWAY_DEVICES_JSON names the file for all that was compared in this process.
void keep(const Shown& shown, const std::string& compared, const Difference& found)
{
    static auto rows = nlohmann::ordered_json::array();
    rows.push_back({{"compared", compared},
                    {"scene", shown.name},
                    {"inked", found.inked},
                    {"unlike", found.unlike},
                    {"largest", found.largest}});
    const char* file = std::getenv("HATCHWAY_DEVICES_JSON");
    if (file == nullptr) return;
    static const nlohmann::ordered_json made = origin();
    std::ofstream(file) << nlohmann::ordered_json{{"rows", rows}, {"origin", made}}.dump(2) << '\n';
}

/// At most this share of the inked pixels may be unlike: edges that fall to the neighbouring pixel.
void expect_same_pictures(const Device& one, const Device& other, const std::string& other_name, double most)
{
    for (const Shown& shown : what_is_shown()) {
        const Picture a = picture_of(shown, one);
        const Picture b = picture_of(shown, other);
        ASSERT_FALSE(a.pixels.is_empty() || b.pixels.is_empty());
        EXPECT_NE(b.device.find(other_name), std::string::npos) << "drawn by " << b.device;
        const Difference found = difference(a.pixels, b.pixels);
        keep(shown, other_name.empty() ? "hardware" : other_name, found);
        EXPECT_GT(found.inked, 2000) << shown.name;
        EXPECT_LE(found.unlike, most * found.inked) << shown.name << ", at most " << found.largest << " apart";
    }
}

TEST(second_device, draws_the_same_with_softpipe)
{
    expect_same_pictures({kOneSample, {}}, {kOneSample, {"GALLIUM_DRIVER=softpipe"}}, "softpipe", 0.005);
}

/// ANGLE on SwiftShader, as browsers bring it: HATCHWAY_ANGLE names the folder with its libEGL.so and libGLESv2.so.
TEST(second_device, draws_the_same_with_angle)
{
    const char* angle = std::getenv("HATCHWAY_ANGLE");
    if (angle == nullptr) GTEST_SKIP() << "HATCHWAY_ANGLE names no folder with ANGLE's libraries";
    // Under the names that programs ask for, beside all that the libraries look for beside themselves.
    const TemporaryFolder folder;
    for (const fs::directory_entry& file : fs::directory_iterator(angle))
        fs::create_symlink(file.path(), folder / file.path().filename().string());
    fs::create_symlink(fs::path(angle) / "libEGL.so", folder / "libEGL.so.1");
    fs::create_symlink(fs::path(angle) / "libGLESv2.so", folder / "libGLESv2.so.2");
    const Words environment{"ANGLE_DEFAULT_PLATFORM=swiftshader", "LD_LIBRARY_PATH=" + folder.path().string()};
    // Vertices lie on sixteenths of a pixel there, so every edge may lie elsewhere.
    expect_same_pictures({}, {{}, environment}, "ANGLE", 0.025);
}

/// What only a software renderer takes, and what only a graphics card: docs/devices.md lists it.
TEST(second_device, draws_the_same_taken_for_hardware_and_for_software)
{
    expect_same_pictures({{"--as-software"}, {}}, {{"--as-hardware"}, {}}, "", 0.001);
}

}  // namespace
}  // namespace hw::test
