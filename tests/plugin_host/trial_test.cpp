// Libraries of --plugin-dir are tried in a process of their own: fixtures/deadly/dies.cpp has a library for each way in
// which a plugin ends a program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/plugin_host/plugin_tests.hpp"
#include "tests/temporary_folder.hpp"

using namespace hw;
using namespace hw::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace {
namespace fs = std::filesystem;

const fs::path kDeadly = HATCHWAY_BUILD_DIR "/tests/plugin_host/deadly";

/// A user's cache folder of its own and a folder of plugins.
class plugin_trial : public testing::Test {
 protected:
    plugin_trial()
    {
        set_log_level(LogLevel::off);
        ::setenv("XDG_CACHE_HOME", cache_.path().c_str(), 1);
        // A sanitizer reports what a signal is to end.
        ::setenv("ASAN_OPTIONS", "handle_segv=0:handle_abort=0:handle_sigfpe=0:detect_leaks=0", 1);
    }
    ~plugin_trial() override { ::unsetenv("XDG_CACHE_HOME"); }

    void take(const std::string& name, const fs::path& folder = kDeadly) const
    {
        fs::copy_file(folder / (name + ".so"), plugins_.path() / (name + ".so"));
    }
    PluginRegistry registry(Trial trial = Trial::if_new) const
    {
        return PluginRegistry({.has_installed = false, .folders = {plugins_.path()}, .trial = trial});
    }
    /// Why the only plugin is refused; empty when it is not.
    std::string refusal() const
    {
        const PluginRegistry loaded = registry();
        return loaded.refused().empty() ? "" : loaded.refused().front().why;
    }
    std::string refusal_of(const std::string& name) const
    {
        take(name);
        return refusal();
    }
    std::vector<fs::path> verdicts() const
    {
        std::vector<fs::path> files;
        std::error_code missing;
        for (const auto& entry : fs::directory_iterator(cache_.path() / "hatchway" / "plugins", missing))
            files.push_back(entry.path());
        return files;
    }
    /// Rewrites the only verdict, so that whoever reads it is found out.
    void mark_verdict() const
    {
        ASSERT_EQ(verdicts().size(), 1u);
        std::ofstream(verdicts().front()) << "refused: it was marked";
    }

    TemporaryFolder cache_;
    TemporaryFolder plugins_;
};

/// Whether a process runs that was started for this library.
bool is_being_tried(const fs::path& library)
{
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator("/proc", gone)) {
        std::ifstream file(entry.path() / "cmdline", std::ios::binary);
        const std::string words((std::istreambuf_iterator<char>(file)), {});
        if (words.find("try-plugin") != std::string::npos && words.find(library.string()) != std::string::npos)
            return true;
    }
    return false;
}

/// A process that was killed is still listed until the system has taken it down.
bool is_gone_within(std::chrono::seconds limit, const fs::path& library)
{
    const auto end = std::chrono::steady_clock::now() + limit;
    while (is_being_tried(library)) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

}  // namespace

TEST_F(plugin_trial, one_that_writes_to_null_is_refused)
{
    EXPECT_THAT(refusal_of("null_write"),
                StartsWith("it crashed (segmentation fault) in its trial, drawing a small frame; --retry-plugins"));
}

TEST_F(plugin_trial, one_that_aborts_is_refused)
{
    EXPECT_THAT(refusal_of("aborts"), StartsWith("it aborted in its trial, being prepared"));
}

TEST_F(plugin_trial, one_that_exits_is_refused_also_with_the_code_of_success)
{
    EXPECT_THAT(refusal_of("exits"), StartsWith("it ended the program by exit(0) in its trial, drawing a small frame"));
    fs::remove(plugins_.path() / "exits.so");
    EXPECT_THAT(refusal_of("quits"), StartsWith("it ended the program by exit(0) in its trial, drawing a small frame"));
}

TEST_F(plugin_trial, one_whose_destructor_throws_is_refused)
{
    EXPECT_THAT(refusal_of("throwing_destructor"), StartsWith("it aborted in its trial, being taken down"));
}

TEST_F(plugin_trial, one_that_runs_for_ever_is_refused_after_ten_seconds)
{
    EXPECT_THAT(refusal_of("runs_for_ever"), StartsWith("it did not end within 10 seconds in its trial, drawing"));
    EXPECT_TRUE(is_gone_within(std::chrono::seconds(5), plugins_.path() / "runs_for_ever.so"));
}

TEST_F(plugin_trial, one_that_takes_memory_without_end_is_refused)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer takes memory itself";
#endif
    EXPECT_THAT(refusal_of("takes_memory"), StartsWith("it took more than a gigabyte of memory in its trial"));
}

TEST_F(plugin_trial, one_that_makes_up_an_index_is_refused)
{
    EXPECT_THAT(refusal_of("made_up_index"), StartsWith("it crashed (segmentation fault) in its trial, drawing"));
}

TEST_F(plugin_trial, one_that_recurses_for_ever_is_refused)
{
    EXPECT_THAT(refusal_of("recurses"), StartsWith("it crashed (segmentation fault) in its trial, drawing"));
}

TEST_F(plugin_trial, one_that_dies_while_it_is_loaded_or_unloaded_is_refused)
{
    EXPECT_THAT(refusal_of("at_load"), StartsWith("it crashed (segmentation fault) in its trial, being loaded"));
    fs::remove(plugins_.path() / "at_load.so");
    EXPECT_THAT(refusal_of("exits_at_load"), StartsWith("it ended the program by exit(0) in its trial, being loaded"));
    fs::remove(plugins_.path() / "exits_at_load.so");
    EXPECT_THAT(refusal_of("at_unload"), StartsWith("it crashed (segmentation fault) in its trial, being unloaded"));
}

TEST_F(plugin_trial, what_a_plugin_leaves_running_ends_with_its_trial)
{
    EXPECT_EQ(refusal_of("forks"), "");
    EXPECT_TRUE(is_gone_within(std::chrono::seconds(5), plugins_.path() / "forks.so"));
}

TEST_F(plugin_trial, the_others_of_the_folder_are_loaded_and_so_is_what_throws)
{
    take("aborts");
    take("none");
    take("throws_in_make", kMisbehaving);
    take("throws_where_told", kMisbehaving);
    const PluginRegistry loaded = registry();
    EXPECT_THAT(loaded.names(PluginKind::style), ElementsAre("none", "throws_in_make", "throws_where_told"));
    ASSERT_EQ(loaded.refused().size(), 1u);
    EXPECT_EQ(loaded.refused().front().name, "aborts");
}

TEST_F(plugin_trial, one_that_was_tried_is_not_tried_again)
{
    EXPECT_EQ(refusal_of("none"), "");
    mark_verdict();
    EXPECT_THAT(refusal(), StartsWith("it was marked; --retry-plugins")) << "the verdict was read";
}

TEST_F(plugin_trial, one_that_changed_is_tried_again)
{
    EXPECT_EQ(refusal_of("none"), "");
    mark_verdict();
    std::ofstream(plugins_.path() / "none.so", std::ios::app) << "changed";
    EXPECT_THAT(registry().refused(), IsEmpty());
    EXPECT_EQ(verdicts().size(), 2u);
}

TEST_F(plugin_trial, one_that_was_left_out_is_taken_back_when_it_is_tried_anew)
{
    EXPECT_EQ(refusal_of("none"), "");
    mark_verdict();
    EXPECT_THAT(registry(Trial::anew).refused(), IsEmpty());
    EXPECT_THAT(registry().refused(), IsEmpty()) << "and stays so";
}

TEST_F(plugin_trial, those_of_the_installation_are_not_tried)
{
    const fs::path installed = fs::path(HATCHWAY_BUILD_DIR) / HATCHWAY_LIBDIR / "hatchway" / "plugins";
    EXPECT_FALSE(PluginRegistry({.folders = {installed}}).plugins().empty());
    EXPECT_THAT(verdicts(), IsEmpty());
}

TEST_F(plugin_trial, without_a_cache_folder_a_plugin_is_tried_at_every_start)
{
    ::setenv("XDG_CACHE_HOME", plugins_.write("in_the_way", "").c_str(), 1);
    EXPECT_THAT(refusal_of("aborts"), HasSubstr("in its trial"));
    EXPECT_THAT(refusal(), HasSubstr("in its trial"));
}

TEST_F(plugin_trial, a_damaged_verdict_is_no_verdict)
{
    EXPECT_EQ(refusal_of("none"), "");
    for (const char* text : {"", "goo", "good\n", "\x01\x02"}) {
        std::ofstream(verdicts().front()) << text;
        EXPECT_EQ(refusal(), "") << text;
    }
}
