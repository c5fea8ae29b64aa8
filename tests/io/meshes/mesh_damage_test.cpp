// A thousand damaged files: each is read or refused by hw::Error, none crashes, none reads outside of its bytes (the
// tests run under sanitizers, too). The seed is fixed.
#include <gtest/gtest.h>

#include <random>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "tests/io/meshes/mesh_texts.hpp"

using namespace mesh_texts;

namespace {

constexpr int kDamagedFiles = 1000;

struct GoodFile {
    std::string text;
    std::string name;
};

std::vector<GoodFile> good_files()
{
    const std::string obj = obj_text() + "o Other\nf -1/1/1 -2/2/1 -3/1/1\nl 1 2\n";
    return {{ply_text(), "a.ply"}, {ply_binary(false), "a.ply"}, {ply_binary(true), "a.ply"},
            {obj, "a.obj"},        {stl_text(), "a.stl"},        {stl_binary(), "a.stl"},
            {off_text(), "a.off"}, {off_text("OFF"), "a.off"}};
}

/// One to four changes: a byte, a word replaced, a stretch cut out or doubled, the end cut off.
std::string damaged(std::string text, std::mt19937& random)
{
    static const std::string words[] = {"4294967295", "-1", "nan",  "1e39", "0",      "\n", "element face 9",
                                        "f 1 2 3 4",  "//", "\\\n", "#",    "vertex", " ",  std::string(300, '7')};
    const auto below = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
        const std::size_t place = below(text.size());
        const std::size_t length = below(std::min<std::size_t>(text.size() - place, 40) + 1);
        switch (below(5)) {
            case 0:
                if (!text.empty()) text[place] = static_cast<char>(random());
                break;
            case 1:
                text.replace(place, length / 8, words[below(std::size(words))]);
                break;
            case 2:
                text.erase(place, length);
                break;
            case 3:
                text.insert(place, text.substr(place, length));
                break;
            case 4:
                text.resize(below(4) == 0 ? place : text.size());
                break;
        }
    }
    return text;
}

}  // namespace

TEST(mesh_damage, a_thousand_damaged_files_are_read_or_refused)
{
    const std::vector<GoodFile> files = good_files();
    const TemporaryFolder folder;
    hw::set_log_level(hw::LogLevel::off);
    std::mt19937 random(20110117);
    int refused = 0;
    for (int i = 0; i < kDamagedFiles; ++i) {
        const GoodFile& good = files[static_cast<std::size_t>(i) % files.size()];
        const auto file = folder.write(good.name, damaged(good.text, random));
        try {
            const hw::Scene scene = hw::import_model(file, folder.path());
            EXPECT_FALSE(scene.objects.empty());
            for (const hw::MeshData& mesh : scene.meshes)
                for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
        } catch (const hw::Error& error) {
            EXPECT_EQ(hw::exit_code(error), 2) << error.what();
            ++refused;
        }
    }
    hw::set_log_level(hw::LogLevel::info);
    EXPECT_GT(refused, kDamagedFiles / 4);
    EXPECT_LT(refused, kDamagedFiles) << "some damage leaves a mesh";
}
