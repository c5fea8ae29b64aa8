// Whatever the program writes is there as it was or as it shall be, at whichever system call the program is killed;
// what a killed one left beside is gone after the next. HATCHWAY_WHOLE_CORPORA=1: at every call that changes a file,
// and at others up to a thousand kills in all.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <numeric>
#include <random>

#include "hatchway/io/level/edit.hpp"
#include "hatchway/walk/autosave.hpp"
#include "tests/program/hostile/outputs.hpp"
#include "tests/program/hostile/traced_run.hpp"
#include "tests/program/run_program.hpp"

using namespace hw::test;

namespace {
namespace fs = std::filesystem;

constexpr std::uint64_t kKillsOfAll = 165;  // of each of eight outputs; two make fewer calls than that
constexpr std::uint64_t kKillsOfSample = 16;
constexpr int kCleanEvery = 5;
#ifdef __SANITIZE_ADDRESS__
constexpr bool kIsSanitized = true;  // slow, and half of the calls are not ours
#else
constexpr bool kIsSanitized = false;
#endif

/// Something that the program writes: a file or a folder of files.
struct Output {
    std::string name;
    std::function<void(bool is_new)> write;  ///< As the body of run_traced().
};

bool is_whole()
{
    return !kIsSanitized && std::getenv("HATCHWAY_WHOLE_CORPORA") != nullptr;
}

class kills : public testing::Test {
 protected:
    static void TearDownTestSuite()
    {
        if (!is_whole()) return;
        EXPECT_GE(killed_of_all, 1000) << "kills in all";
    }
    kills() { fs::copy_file(kContent / "models" / "prism.glb", folder_.path() / "prism.glb"); }

    Output output_of(const CommandOutput& command) const
    {
        return {command.name, [&command, this](bool is_new) {
                    begin_trace();
                    become_program(command.arguments(folder_ / "prism.glb", folder_.path(), is_new));
                }};
    }
    void expect_old_or_new(const Output& output);

    TemporaryFolder folder_;

 private:
    void write_whole(const Output& output, bool is_new) const
    {
        const TracedEnd end = run_traced([&] { output.write(is_new); }, 0, Calls::all);
        EXPECT_EQ(end.exit_code, 0) << output.name;
    }
    void put_back(const std::string& name) const
    {
        fs::remove_all(folder_ / name);
        fs::copy(saved_.path() / name, folder_ / name, fs::copy_options::recursive);
    }
    TemporaryFolder saved_;
    static inline int killed_of_all = 0;
};

/// Which calls to be killed at: of `count`, `wanted` ones, or all.
std::vector<std::uint64_t> some_of(std::uint64_t count, std::uint64_t wanted, std::mt19937& random)
{
    std::vector<std::uint64_t> calls(count);
    std::iota(calls.begin(), calls.end(), 1);
    if (wanted >= count) return calls;
    std::shuffle(calls.begin(), calls.end(), random);
    calls.resize(wanted);
    return calls;
}

void kills::expect_old_or_new(const Output& output)
{
    run_program({"--version"});  // makes the folders of a user of all programs of this test
    write_whole(output, false);
    const auto old_state = state_of(folder_ / output.name);
    fs::copy(folder_ / output.name, saved_.path() / output.name, fs::copy_options::recursive);
    std::map<Calls, std::uint64_t> counts;
    for (const Calls calls : {Calls::changing, Calls::all}) {
        put_back(output.name);
        const TracedEnd whole = run_traced([&] { output.write(true); }, 0, calls);
        if (!whole.is_traced) GTEST_SKIP() << "processes may not be looked at here";
        ASSERT_EQ(whole.exit_code, 0) << output.name;
        counts[calls] = whole.calls;
    }
    const auto new_state = state_of(folder_ / output.name);
    ASSERT_NE(old_state, new_state) << "nothing can be told";

    const std::uint64_t wanted = is_whole() ? kKillsOfAll : kKillsOfSample;
    std::mt19937 random(20011);
    int killed = 0;
    const auto kill_at = [&](Calls calls, std::uint64_t number) {
        put_back(output.name);
        const TracedEnd end = run_traced([&] { output.write(true); }, number, calls);
        const auto state = state_of(folder_ / output.name);
        EXPECT_TRUE(state == old_state || state == new_state)
            << output.name << " is neither old nor new after a kill at call " << number << " of kind "
            << static_cast<int>(calls);
        // With threads a run can have fewer calls than the one before.
        EXPECT_TRUE(end.is_killed || state == new_state);
        if (end.is_killed && ++killed % kCleanEvery != 0) return;
        write_whole(output, true);
        EXPECT_EQ(state_of(folder_ / output.name), new_state);
        EXPECT_EQ(left_behind_in(folder_.path()), 0) << "after a whole run";
    };
    const std::uint64_t changing = std::min(counts[Calls::changing], is_whole() ? counts[Calls::changing] : wanted / 2);
    for (const std::uint64_t number : some_of(counts[Calls::changing], changing, random))
        kill_at(Calls::changing, number);
    const std::uint64_t others = wanted > changing ? wanted - changing : 0;
    for (const std::uint64_t number : some_of(counts[Calls::all], others, random)) kill_at(Calls::all, number);
    EXPECT_GE(killed * 2, static_cast<int>(std::min(wanted, counts[Calls::all])));
    killed_of_all += killed;
    RecordProperty("kills", killed);
    RecordProperty("changing_calls", static_cast<int>(counts[Calls::changing]));
    RecordProperty("calls", static_cast<int>(counts[Calls::all]));
}

}  // namespace

TEST_F(kills, leave_the_old_map_s_folder_or_the_new)
{
    expect_old_or_new(output_of(kMapFolder));
}

TEST_F(kills, leave_the_old_compiled_level_or_the_new)
{
    expect_old_or_new(output_of(kCompiled));
}

TEST_F(kills, leave_the_old_baked_light_or_the_new)
{
    expect_old_or_new(output_of(kBaked));
}

TEST_F(kills, leave_the_old_picture_or_the_new)
{
    expect_old_or_new(output_of(kPicture));
}

TEST_F(kills, leave_the_old_svg_or_the_new)
{
    expect_old_or_new(output_of(kSvg));
}

TEST_F(kills, leave_the_old_pdf_or_the_new)
{
    expect_old_or_new(output_of(kPdf));
}

TEST_F(kills, leave_the_old_level_or_the_saved_one)
{
    const auto level_with = [](const std::string& style) {
        return R"({"format": "hatchway-level/1", "scene": "prism.glb", "assign": [{"nodes": "*", "style": ")" + style +
               "\"}]}";
    };
    // What a walk does at Ctrl+S.
    const auto save = [&](bool is_new) {
        if (!is_new) folder_.write("a.level.json", level_with("photoreal"));
        begin_trace();
        if (is_new) {
            hw::edit_level_file(folder_.path() / "a.level.json", [](const hw::Level&) {
                return std::vector<hw::StyleAssignment>{{.nodes = "prism", .style = "pen_and_ink"}};
            });
        }
        ::_exit(0);
    };
    expect_old_or_new({"a.level.json", save});
}

TEST_F(kills, leave_the_old_autosave_or_the_new)
{
    const std::string name = "of_a_walk";
    const fs::path level = folder_.path() / name / "a.level.json";
    const auto keep = [&](bool is_new) {
        fs::create_directories(folder_.path() / name);
        hw::Autosave walk(level);
        begin_trace();
        walk.keep(is_new ? std::string(100'000, 'n') : std::string(100'000, 'o'));
        ::_exit(0);  // as a kill after the end: the lock is left, and taken by the next
    };
    expect_old_or_new({name, keep});
}
