#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/program/run_program.hpp"

namespace hw::test {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

json read_json(const fs::path& file)
{
    return json::parse(bytes_of(file));
}

/// The number of the file itself: what is written anew has another.
ino_t inode_of(const fs::path& file)
{
    struct stat facts {};
    EXPECT_EQ(::stat(file.c_str(), &facts), 0);
    return facts.st_ino;
}

/// A folder with prism.glb.
struct PrismFolder : TemporaryFolder {
    PrismFolder() { fs::copy_file(kContent / "models" / "prism.glb", path() / "prism.glb"); }
    std::string model() const { return *this / "prism.glb"; }
    /// The user's cache folder of these runs.
    std::vector<std::string> environment() const { return {"XDG_CACHE_HOME=" + (cache_ / "home")}; }
    fs::path caches() const { return fs::path(cache_ / "home") / "hatchway"; }
    ProgramResult run(const std::vector<std::string>& words) const { return run_program(words, 60.0, environment()); }
    /// The one file in the cache.
    fs::path compiled() const
    {
        std::error_code missing;
        const fs::directory_iterator entry(caches(), missing);
        return missing || entry == fs::directory_iterator() ? fs::path() : entry->path();
    }
    ProgramResult render(const std::vector<std::string>& more = {}, const std::string& picture = "a.png") const
    {
        std::vector<std::string> words{"render",    model(), "--size", "64x64",
                                       "--samples", "1",     "--out",  *this / picture};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    /// One that has to wait for the visibility.
    ProgramResult render_leaves(std::vector<std::string> more = {}) const
    {
        more.insert(more.end(), {"--show", "leaves"});
        return render(more);
    }

 private:
    TemporaryFolder cache_;
};

/// Two rooms with a doorway, closed all around, and a sealed level of them.
std::string sealed_level(const TemporaryFolder& folder, const std::string& start)
{
    const ProgramResult made = run_program({"measure", "scale", "--rooms", "2", "--write", folder / "rooms.glb"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return folder.write(
        "rooms.level.json",
        R"({"format": "hatchway-level/1", "scene": "rooms.glb", "sealed": true, "start": {"position": )" + start +
            R"(, "look_at": [3, 1, 3]}})");
}

}  // namespace

TEST(compile, what_it_writes_is_what_render_takes)
{
    const PrismFolder folder;
    ASSERT_EQ(folder.run({"compile", folder.model(), "--json", folder / "c.json"}).exit_code, 0);
    ASSERT_TRUE(fs::exists(folder.compiled()));
    EXPECT_EQ(read_json(folder / "c.json")["file"], folder.compiled().string());
    EXPECT_EQ(read_json(folder / "c.json")["bytes"], fs::file_size(folder.compiled()));
    const auto written = inode_of(folder.compiled());
    ASSERT_EQ(folder.render().exit_code, 0);
    EXPECT_EQ(inode_of(folder.compiled()), written) << "the same file";
    EXPECT_EQ(folder.render({"--no-cache"}, "b.png").exit_code, 0);
    EXPECT_EQ(bytes_of(folder / "a.png"), bytes_of(folder / "b.png"));
}

TEST(compile, a_picture_waits_for_no_compiler)
{
    const PrismFolder folder;
    EXPECT_EQ(folder.render().exit_code, 0);
    EXPECT_EQ(folder.compiled(), fs::path());
}

TEST(compile, a_picture_of_leaves_compiles_at_the_first_start_and_after_damage)
{
    const PrismFolder folder;
    ASSERT_EQ(folder.render_leaves().exit_code, 0);
    const std::string good = bytes_of(folder.compiled());
    for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), std::string(good.size(), 'x')}) {
        std::ofstream(folder.compiled(), std::ios::binary) << bad;
        const ProgramResult result = folder.render_leaves();
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.err, HasSubstr("left aside"));
        EXPECT_EQ(bytes_of(folder.compiled()), good);
    }
}

TEST(compile, looking_and_measuring_leave_nothing_behind)
{
    const PrismFolder folder;
    EXPECT_EQ(folder.run({"check", folder.model()}).exit_code, 0);
    EXPECT_EQ(folder.run({"info", folder.model()}).exit_code, 0);
    EXPECT_EQ(folder.render({"--no-cache"}).exit_code, 0);
    EXPECT_THAT(folder.names(), ElementsAre("a.png", "prism.glb"));
    EXPECT_EQ(folder.compiled(), fs::path());
}

TEST(compile, nothing_is_written_beside_a_level_and_nothing_there_is_believed)
{
    const PrismFolder folder;
    ASSERT_EQ(folder.render_leaves().exit_code, 0);
    EXPECT_THAT(folder.names(), ElementsAre("a.png", "prism.glb"));
    // What was once read from beside the level, and is forged: a link to a user's file.
    folder.write("source.cpp", "mine");
    fs::create_directory(folder / ".hatchway");
    fs::create_symlink("../source.cpp", folder / ".hatchway/prism.glb.compiled");
    fs::remove(folder.compiled());
    const ProgramResult result = folder.render_leaves();
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(bytes_of(folder / "source.cpp"), "mine");
    EXPECT_TRUE(fs::is_symlink(folder / ".hatchway/prism.glb.compiled"));
    EXPECT_TRUE(fs::exists(folder.compiled()));
}

TEST(compile, links_in_the_cache_are_replaced_and_never_followed)
{
    const PrismFolder folder;
    ASSERT_EQ(folder.render_leaves().exit_code, 0);
    const fs::path compiled = folder.compiled();
    const std::string good = bytes_of(compiled);
    folder.write("source.cpp", "mine");
    fs::remove(compiled);
    fs::create_symlink(folder / "source.cpp", compiled);
    EXPECT_EQ(folder.render_leaves().exit_code, 0);
    EXPECT_EQ(bytes_of(folder / "source.cpp"), "mine");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(compiled)));
    EXPECT_EQ(bytes_of(compiled), good);
}

TEST(compile, a_cache_that_others_can_write_into_is_left_alone)
{
    const PrismFolder folder;
    ASSERT_EQ(folder.render_leaves().exit_code, 0);
    const fs::path compiled = folder.compiled();
    EXPECT_EQ(fs::status(folder.caches()).permissions(), fs::perms::owner_all);
    fs::remove(compiled);
    fs::permissions(folder.caches(), fs::perms::all);
    const ProgramResult result = folder.render_leaves();
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("others may write into the folder"));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(fs::exists(compiled));
}

TEST(compile, without_a_cache_folder_nothing_is_kept_and_one_line_says_so)
{
    const PrismFolder folder;
    folder.write("file", "in the way");
    const ProgramResult result =
        run_program({"render", folder.model(), "--size", "64x64", "--out", folder / "a.png"}, 60.0,
                    {"XDG_CACHE_HOME=" + (folder / "file/cache"), "MESA_SHADER_CACHE_DISABLE=true"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("--cache"));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST(compile, a_cache_folder_may_be_named)
{
    const PrismFolder folder;
    ASSERT_EQ(folder.render_leaves({"--cache", folder / "cache"}).exit_code, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "cache"), fs::directory_iterator()), 1);
    EXPECT_EQ(folder.compiled(), fs::path());
    fs::create_directory_symlink("cache", folder / "link");
    EXPECT_EQ(folder.render({"--cache", folder / "link"}).exit_code, 2) << "a link is no folder of the user's naming";
}

TEST(compile, never_writes_over_what_it_reads)
{
    const PrismFolder folder;
    const std::string before = bytes_of(folder.model());
    EXPECT_EQ(folder.run({"compile", folder.model(), "--out", folder.model()}).exit_code, 2);
    EXPECT_EQ(folder.run({"compile", folder.model(), "--prt", folder.model()}).exit_code, 2);
    EXPECT_EQ(bytes_of(folder.model()), before);
    EXPECT_EQ(folder.compiled(), fs::path());
}

TEST(compile, writes_portals_that_pvs_reads)
{
    const TemporaryFolder folder;
    const std::string level = sealed_level(folder, "[1, 1.5, 1]");
    ASSERT_EQ(run_program({"compile", level, "--prt", folder / "r.prt", "--json", folder / "c.json"}).exit_code, 0);
    const ProgramResult pvs = run_program({"pvs", folder / "r.prt", "--json", folder / "p.json"});
    ASSERT_EQ(pvs.exit_code, 0) << pvs.err;
    EXPECT_GT(read_json(folder / "p.json")["portals"], 0);
    EXPECT_EQ(2 * read_json(folder / "p.json")["portals"].get<int>(), read_json(folder / "c.json")["portals"]);
}

TEST(compile, has_the_same_bytes_for_any_number_of_threads)
{
    const TemporaryFolder folder;
    const std::string level = sealed_level(folder, "[1, 1.5, 1]");
    ASSERT_EQ(run_program({"compile", level, "-j", "1", "--out", folder / "one"}).exit_code, 0);
    ASSERT_EQ(run_program({"compile", level, "-j", "2", "--out", folder / "two"}).exit_code, 0);
    EXPECT_EQ(bytes_of(folder / "one"), bytes_of(folder / "two"));
}

TEST(leaks, of_a_sealed_level_are_named_and_drawn)
{
    const TemporaryFolder folder;
    const std::string closed = sealed_level(folder, "[1, 1.5, 1]");
    ASSERT_EQ(run_program({"check", closed, "--json", folder / "closed.json"}).exit_code, 0);
    EXPECT_TRUE(read_json(folder / "closed.json")["leaks"].empty());

    const std::string open = sealed_level(folder, "[-2, 1.5, 1]");
    const ProgramResult result = run_program({"check", open, "--json", folder / "open.json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("leak: "));
    ASSERT_EQ(read_json(folder / "open.json")["leaks"].size(), 1u);
}

TEST(leaks, lines_are_drawn_over_the_picture)
{
    const TemporaryFolder folder;
    const std::string level = sealed_level(folder, "[1, 1.5, 1]");
    const auto picture = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"render",  level,      "--size", "160x120", "--eye",
                                       "1,1.5,1", "--target", "5,1,5",  "--out",   folder / "p.png"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramResult result = run_program(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return bytes_of(folder / "p.png");
    };
    const std::string plain = picture({});
    for (const char* kind : {"leaves", "portals", "pvs", "wire"}) EXPECT_NE(picture({"--show", kind}), plain) << kind;
    EXPECT_EQ(picture({"--leak"}), plain) << "there is none";
    EXPECT_EQ(run_program({"render", level, "--show", "walls", "--out", folder / "p.png"}).exit_code, 2);
}

TEST(render, parts_of_a_path_are_the_pictures_that_the_whole_has)
{
    const PrismFolder folder;
    const auto render = [&](const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> words{"render", folder.model(), "--path", "turntable", "--frames",
                                       "5",      "--size",       "32x32",  "--out",     folder / out};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words).exit_code;
    };
    ASSERT_EQ(render("all", {}), 0);
    ASSERT_EQ(render("part", {"--part", "2/3"}), 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "part"), fs::directory_iterator()), 2);
    for (const char* name : {"frame_0001.png", "frame_0004.png"})
        EXPECT_EQ(bytes_of(folder.path() / "part" / name), bytes_of(folder.path() / "all" / name));
    for (const char* bad : {"0/3", "4/3", "2", "a/b", "1/3x"}) EXPECT_EQ(render("bad", {"--part", bad}), 2) << bad;
}

}  // namespace hw::test
