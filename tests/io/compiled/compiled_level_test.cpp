#include "hatchway/io/compiled/key.hpp"
#include "hatchway/io/compiled/level.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/io/compiled/portal_file.hpp"
#include "tests/io/compiled/rooms.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace hw::test;

hw::Level level_in(const fs::path& folder)
{
    hw::Level level;
    level.file = folder / "a.level.json";
    level.project_root = folder;
    return level;
}

}  // namespace

TEST(compiled_level, reads_what_was_written)
{
    const Rooms rooms;
    const std::vector<std::byte> bytes = rooms.bytes();
    const hw::CompiledLevel read = rooms.read(bytes);
    EXPECT_EQ(read.key, rooms.level.key);
    EXPECT_EQ(read.effort, rooms.level.effort);
    EXPECT_EQ(hw::compiled_level_bytes(read, rooms.chunks), bytes) << "nothing is lost on the way";
    for (const double x : {-9.0, -4.0, 0.0, 4.0, 9.0}) {
        for (const double z : {-4.5, 0.0, 3.5}) {
            EXPECT_EQ(seen_from(read.visibility, {x, 0, z}), seen_from(rooms.level.visibility, {x, 0, z}));
            EXPECT_EQ(hw::visible_leaf_count(read.visibility, {x, 0, z}, 0.1),
                      hw::visible_leaf_count(rooms.level.visibility, {x, 0, z}, 0.1));
        }
    }
    ASSERT_EQ(read.visibility.tree.nodes.size(), rooms.level.visibility.tree.nodes.size());
    for (std::size_t i = 0; i < read.visibility.tree.nodes.size(); ++i) {
        const hw::ExactPlane& a = read.visibility.tree.nodes[i].plane;
        const hw::ExactPlane& b = rooms.level.visibility.tree.nodes[i].plane;
        EXPECT_TRUE(a.unit_normal == b.unit_normal && a.unit_offset == b.unit_offset);
    }
}

TEST(compiled_level, of_any_size_reads_what_was_written)
{
    for (const double scale : {1e-7, 1e-5, 1e-3, 1e3, 1e5}) {
        const Rooms rooms(0, scale);
        const std::vector<std::byte> bytes = rooms.bytes();
        EXPECT_EQ(hw::compiled_level_bytes(rooms.read(bytes), rooms.chunks), bytes) << scale;
    }
}

TEST(compiled_level, is_the_same_for_any_number_of_threads)
{
    EXPECT_EQ(Rooms(1).bytes(), Rooms(2).bytes());
    EXPECT_EQ(Rooms(1).bytes(), Rooms(7).bytes());
}

TEST(compiled_level, damage_is_refused_and_never_a_crash)
{
    const Rooms rooms;
    const std::vector<std::byte> good = rooms.bytes();
    ASSERT_LT(good.size(), 100'000u) << "so that the test is short";
    std::mt19937 random(1);
    for (int round = 0; round < 10'000; ++round) {
        std::vector<std::byte> bytes = good;
        if (round % 4 == 0) {
            bytes.resize(random() % good.size());
        } else {
            const int flips = 1 + static_cast<int>(random() % 3);
            for (int i = 0; i < flips; ++i) bytes[random() % bytes.size()] ^= std::byte(1u << random() % 8);
        }
        if (bytes == good) continue;
        if (!is_taken(rooms, bytes)) continue;
        // Only bits that say nothing may have changed, or the key, which whoever reads a file compares.
        hw::CompiledLevel read = rooms.read(bytes);
        read.key = rooms.level.key;
        EXPECT_EQ(hw::compiled_level_bytes(read, rooms.chunks), good) << "round " << round;
    }
}

TEST(compiled_level, what_was_made_to_deceive_is_never_a_crash)
{
    const Rooms rooms;
    const std::vector<std::byte> good = rooms.bytes();
    const Signature signature(good);
    ASSERT_NE(signature.hash, kNoPlace);
    std::mt19937 random(2);
    int taken = 0;
    for (int round = 0; round < 10'000; ++round) {
        std::vector<std::byte> bytes = good;
        const std::size_t at = signature.content + random() % signature.size;
        if (round % 2 == 0) {
            bytes[at] = std::byte(random());
        } else {
            const std::uint32_t word = random() % 3 == 0 ? 0xffffffffu : random() % 2 == 0 ? 0x7fffffffu : random();
            std::memcpy(bytes.data() + std::min(at, bytes.size() - 4), &word, 4);
        }
        signature.renew(bytes);
        taken += is_taken(rooms, bytes);
    }
    EXPECT_GT(taken, 0) << "signed files get past the hash, so that the checks behind it are what is tested";
}

TEST(compiled_level, of_a_scene_without_anything_to_see_is_read)
{
    hw::Scene scene;
    std::vector<hw::MeshChunks> chunks;
    hw::CompiledLevel level{
        .key = 1, .effort = hw::PvsEffort::full, .visibility = build_visibility(scene, {}, chunks, {})};
    const std::vector<std::byte> bytes = hw::compiled_level_bytes(level, chunks);
    EXPECT_EQ(hw::compiled_level_from_bytes(bytes, scene, chunks, "empty").visibility.tree.leaf_count, 1);
}

// Found by a fuzzer: four bytes further on, the first plane reads as one, but its numbers are of 8 bytes.
TEST(compiled_level, numbers_that_start_where_none_may_stand_are_refused)
{
    const Rooms rooms;
    const std::vector<std::byte> good = rooms.bytes();
    const Signature signature(good);
    int refused = 0;
    for (std::size_t at = signature.content; at + 4 <= signature.content + signature.size; at += 4) {
        std::vector<std::byte> bytes = good;
        std::uint32_t word = 0;
        std::memcpy(&word, &bytes[at], 4);
        word += 4;
        std::memcpy(&bytes[at], &word, 4);
        signature.renew(bytes);
        try {
            rooms.read(bytes);
        } catch (const hw::Error& error) {
            refused += std::string_view(error.what()).find("start where none may stand") != std::string_view::npos;
        }
    }
    EXPECT_GE(refused, 2) << "planes and corners; of portals the first number is read as their count, 0";
}

TEST(compiled_level, portals_that_are_written_as_a_portal_file_show_the_same)
{
    const Rooms rooms;
    const hw::PortalGraph& graph = rooms.level.visibility.portals;
    const hw::PortalFile file = hw::parse_portals(hw::portals_text(graph), "rooms.prt");
    const hw::PvsOptions options{.effort = hw::PvsEffort::exact};
    const hw::LeafRows ours = hw::build_pvs(graph, options).rows;
    const hw::LeafRows theirs = hw::build_pvs(file.graph, options).rows;
    ASSERT_EQ(ours.leaf_count(), theirs.leaf_count());
    EXPECT_GT(graph.portals.size(), 0u);
    for (int leaf = 0; leaf < ours.leaf_count(); ++leaf)
        EXPECT_TRUE(std::equal(ours.row(leaf).begin(), ours.row(leaf).end(), theirs.row(leaf).begin())) << leaf;
}

TEST(compiled_level, of_another_scene_is_refused)
{
    const Rooms rooms;
    const std::vector<std::byte> bytes = rooms.bytes();
    SceneBuilder more;
    hw::Scene& scene = hw::test::rooms(more);
    more.box({1, 0, 1}, {2, 1, 2}, false);
    std::vector<hw::MeshChunks> chunks;
    for (hw::MeshData& mesh : scene.meshes) chunks.push_back(hw::split_into_chunks(mesh));
    EXPECT_THROW(hw::compiled_level_from_bytes(bytes, scene, chunks, "x"), hw::Error);
}

TEST(compiled_level, is_known_by_what_decides_about_sight_and_by_nothing_else)
{
    SceneBuilder builder;
    hw::Scene& scene = rooms(builder);
    const hw::VisibilityOptions options;
    const hw::Level level;
    const auto key_of = [&](const hw::Scene& of, const hw::Level& in) {
        return hw::compiled_level_key(hw::geometry_key(of), of, in, options);
    };
    const std::uint64_t key = key_of(scene, level);
    scene.materials[0].base_colour = glm::vec4(0.1f);
    scene.nodes[0].name = "another";
    EXPECT_EQ(key_of(scene, level), key);
    const auto changes = [&](auto change) {
        SceneBuilder other;
        hw::Scene& changed = rooms(other);
        hw::Level with = level;
        change(changed, with);
        return key_of(changed, with) != key;
    };
    EXPECT_TRUE(changes([](hw::Scene& s, hw::Level&) { s.meshes[0].positions[3].x += 1e-3f; }));
    EXPECT_TRUE(changes([](hw::Scene& s, hw::Level&) { std::swap(s.meshes[0].indices[0], s.meshes[0].indices[1]); }));
    EXPECT_TRUE(changes([](hw::Scene& s, hw::Level&) { s.nodes[1].world_from_node[3].y += 1.0; }));
    EXPECT_TRUE(changes([](hw::Scene& s, hw::Level&) { s.nodes[1].is_animated = true; }));
    EXPECT_TRUE(changes([](hw::Scene& s, hw::Level&) { s.materials[0].is_double_sided = true; }));
    EXPECT_TRUE(changes([](hw::Scene& s, hw::Level&) { s.materials[0].alpha_mode = hw::AlphaMode::blend; }));
    EXPECT_TRUE(changes([](hw::Scene&, hw::Level& l) { l.structure = std::vector<std::string>{"n0"}; }));
}

TEST(compiled_level, is_kept_in_a_folder_and_found_again)
{
    const TemporaryFolder folder;
    const Rooms rooms;
    const hw::FolderHandle cache(folder.path());
    const std::string name = hw::compiled_level_name(level_in(folder.path()));
    const auto find = [&](std::uint64_t key, hw::PvsEffort effort) {
        return hw::find_compiled_level(cache, name, key, effort, rooms.scene, rooms.chunks).has_value();
    };
    EXPECT_FALSE(find(rooms.level.key, hw::PvsEffort::full));
    cache.write(name, hw::compiled_level_bytes(rooms.level, rooms.chunks));
    EXPECT_TRUE(find(rooms.level.key, hw::PvsEffort::full));
    EXPECT_TRUE(find(rooms.level.key, hw::PvsEffort::fast));
    EXPECT_FALSE(find(rooms.level.key, hw::PvsEffort::exact)) << "less than what is wanted";
    EXPECT_FALSE(find(rooms.level.key + 1, hw::PvsEffort::full)) << "made from something else";
    folder.write(name, "damaged");
    EXPECT_FALSE(find(rooms.level.key, hw::PvsEffort::full));
}

TEST(compiled_level, is_not_taken_from_behind_a_link)
{
    const TemporaryFolder folder;
    const Rooms rooms;
    const std::string name = hw::compiled_level_name(level_in(folder.path()));
    hw::FolderHandle(folder.path()).write("elsewhere", hw::compiled_level_bytes(rooms.level, rooms.chunks));
    fs::create_symlink("elsewhere", folder.path() / name);
    EXPECT_FALSE(hw::find_compiled_level(hw::FolderHandle(folder.path()), name, rooms.level.key, hw::PvsEffort::full,
                                         rooms.scene, rooms.chunks));
}

TEST(compiled_level, has_a_short_name_of_its_own_in_a_cache_folder)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "one");
    fs::create_directory_symlink("one", folder.path() / "alias");
    const auto name_in = [&](const char* place) { return hw::compiled_level_name(level_in(folder.path() / place)); };
    EXPECT_NE(name_in("one"), name_in("two"));
    EXPECT_EQ(name_in("one"), name_in("alias")) << "the same level";
    hw::Level level;
    std::string long_name(246, 'x');
    level.file = folder.path() / long_name.append(".glb");
    EXPECT_LT(hw::compiled_level_name(level).size(), 40u);
}
