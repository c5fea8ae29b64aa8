// Plugins of --plugin-dir that end the program: in their trial, and later.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/program/run_program.hpp"

using namespace hw::test;
using testing::HasSubstr;
using testing::Not;

namespace {
namespace fs = std::filesystem;

const fs::path kFixtures = HATCHWAY_BUILD_DIR "/tests/plugin_host";

/// A level, a folder of plugins and the user's own folders.
class plugins : public testing::Test {
 protected:
    plugins()
    {
        fs::create_directories(folder_.path() / "plugins");
        fs::copy_file(kContent / "models" / "prism.glb", folder_.path() / "prism.glb");
    }
    void take(const std::string& name, const std::string& from)
    {
        fs::copy_file(kFixtures / from / (name + ".so"), folder_.path() / "plugins" / (name + ".so"));
    }
    ProgramResult run(std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.end(), {"--plugin-dir", folder_ / "plugins"});
        return run_program(arguments, 60.0, {"XDG_CACHE_HOME=" + (folder_ / "cache"), kNoAsan});
    }
    /// Draws the prism in a style of this plugin that dies as told.
    ProgramResult draw(const std::string& plugin, const std::string& death) const
    {
        const std::string level = folder_.write(
            "a.level.json", R"({"format": "hatchway-level/1", "scene": "prism.glb", "styles": {"it": {"plugin": ")" +
                                plugin + R"(", "death": ")" + death +
                                R"("}}, "assign": [{"nodes": "*", "style": "it"}]})");
        return run({"render", level, "--size", "64x64", "--out", folder_ / "a.png"});
    }

    static constexpr const char* kNoAsan = "ASAN_OPTIONS=handle_segv=0:handle_abort=0:detect_leaks=0";
    TemporaryFolder folder_;
};

}  // namespace

TEST_F(plugins, that_die_in_their_trial_are_bad_input_for_a_level_that_uses_them_and_for_no_other)
{
    take("aborts", "deadly");
    take("none", "deadly");
    const ProgramResult used = draw("aborts", "aborts");
    EXPECT_EQ(used.exit_code, 2) << used.err;
    EXPECT_THAT(used.err, HasSubstr("the plugin \"aborts\""));
    EXPECT_THAT(used.err, HasSubstr("it aborted in its trial, being prepared; --retry-plugins tries it again"));
    EXPECT_FALSE(fs::exists(folder_ / "a.png"));
    EXPECT_EQ(draw("none", "none").exit_code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "a.png"));
}

TEST_F(plugins, that_crash_later_are_named_with_what_they_drew_and_left_out_until_they_are_tried_again)
{
    take("none", "deadly");
    ASSERT_EQ(draw("none", "none").exit_code, 0);
    const std::vector<std::pair<std::string, std::string>> deaths{
        {"null_write", "it crashed (segmentation fault) in surfaces, drawing Prism"},
        {"recurses", "it crashed (segmentation fault) in surfaces, drawing Prism"},
        {"aborts", "it aborted in prepare"},
        {"exits", "it ended the program by exit() in surfaces, drawing Prism"},
        {"throwing_destructor", "it aborted in a check of its parameters"}};
    for (const auto& [death, told] : deaths) {
        const ProgramResult crash = draw("none", death);
        EXPECT_NE(crash.exit_code, 0) << death;
        EXPECT_THAT(crash.err, HasSubstr("the plugin \"none\": " + told)) << death;
        EXPECT_THAT(crash.err, HasSubstr("; the next start leaves it out")) << death;

        const ProgramResult next = draw("none", "none");
        EXPECT_EQ(next.exit_code, 2) << death;
        EXPECT_THAT(next.err, HasSubstr(told + " when it was used last; --retry-plugins tries it again")) << death;

        EXPECT_EQ(run({"schema", "--retry-plugins", "--out", folder_ / "schema.json"}).exit_code, 0);
        EXPECT_EQ(draw("none", "none").exit_code, 0) << death << ": it was taken back";
    }
}

TEST_F(plugins, that_throw_do_not_end_the_schema_of_the_others)
{
    take("none", "deadly");
    take("throws_in_make", "misbehaving");
    const ProgramResult schema = run({"schema", "--out", folder_ / "schema.json"});
    EXPECT_EQ(schema.exit_code, 0) << schema.err;
    EXPECT_THAT(schema.err, HasSubstr("the plugin \"throws_in_make\" failed"));
    const std::string text = bytes_of(folder_ / "schema.json");
    EXPECT_THAT(text, HasSubstr("How it dies."));
    EXPECT_THAT(text, HasSubstr("pen_and_ink"));
    EXPECT_THAT(text, Not(HasSubstr("throws_in_make")));
}

TEST_F(plugins, are_tried_by_a_command_that_nobody_is_shown)
{
    const ProgramResult help = run_program({"--help"});
    EXPECT_THAT(help.out, Not(HasSubstr("try-plugin")));
    EXPECT_THAT(run_program({"no-such-command"}).err, Not(HasSubstr("try-plugin")));
    EXPECT_THAT(run_program({"render", "--help"}).out, HasSubstr("--retry-plugins"));
}
