// What cannot be written is one message and exit code 2; what was there before is there, and nothing is left beside: on
// a full disk, a read-only one and in a folder that is not the user's to write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "hatchway/core/error.hpp"
#include "hatchway/io/level/edit.hpp"
#include "hatchway/walk/autosave.hpp"
#include "tests/program/hostile/outputs.hpp"
#include "tests/program/run_program.hpp"

using namespace hw::test;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

namespace {
namespace fs = std::filesystem;

constexpr int kDiskBytes = 1 << 20;

/// Makes this process see mounts of its own. False where that is not allowed.
bool has_own_mounts()
{
    static const bool is_done = [] {
        const uid_t user = ::geteuid();
        if (::unshare(CLONE_NEWNS | (user == 0 ? 0 : CLONE_NEWUSER)) != 0) return false;
        if (user != 0) std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
        return ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
    }();
    return is_done;
}

/// A small disk.
class SmallDisk : public testing::Test {
 protected:
    void SetUp() override
    {
        fs::create_directory(disk_);
        fs::copy_file(kContent / "models" / "prism.glb", model_);
        const std::string size = "size=" + std::to_string(kDiskBytes);
        if (!has_own_mounts() || ::mount("none", disk_.c_str(), "tmpfs", 0, size.c_str()) != 0)
            GTEST_SKIP() << "nothing can be mounted here";
        is_mounted_ = true;
    }
    void TearDown() override
    {
        if (is_mounted_) ::umount(disk_.c_str());
    }

    /// Fills the disk up to `room_bytes`, of whole pages.
    void leave_room(std::uintmax_t room_bytes) const
    {
        std::ofstream filler(disk_ / "filler", std::ios::binary);
        const std::string page(4096, 'x');
        while (fs::space(disk_).available > room_bytes && filler.write(page.data(), 4096).flush()) continue;
    }
    void make_read_only() const
    {
        ASSERT_EQ(::mount("none", disk_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0);
    }

    TemporaryFolder folder_;
    fs::path disk_ = folder_.path() / "disk";
    fs::path model_ = folder_.path() / "prism.glb";

 private:
    bool is_mounted_ = false;
};

/// With the old output of a command on it.
class no_room : public SmallDisk, public testing::WithParamInterface<CommandOutput> {
 protected:
    using State = std::map<std::string, std::string>;

    ProgramResult write(bool is_new, const ProgramLimits& limits = {}) const
    {
        return run_program(GetParam().arguments(model_, disk_, is_new), 60.0, {}, limits);
    }
    State state() const { return state_of(disk_ / GetParam().name); }
    /// `why` is a regular expression.
    void expect_refused(const ProgramResult& result, const std::string& why, const State& old) const
    {
        EXPECT_EQ(result.exit_code, 2) << result.err;
        EXPECT_THAT(result.err, ContainsRegex(why));
        EXPECT_THAT(result.err, HasSubstr(disk_.string()));
        EXPECT_THAT(result.err, Not(HasSubstr(".tmp"))) << "a name that the user does not know";
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_EQ(state(), old);
        EXPECT_EQ(left_behind_in(disk_), 0);
    }
};

/// What a walk does on it.
class no_room_for_a_walk : public SmallDisk {
 protected:
    /// The message of a save that fails; empty when it does not.
    static std::string save(const fs::path& level)
    {
        try {
            hw::edit_level_file(level, [](const hw::Level&) {
                return std::vector<hw::StyleAssignment>{{.nodes = "prism", .style = "pen_and_ink"}};
            });
        } catch (const hw::Error& error) {
            return error.what();
        }
        return "";
    }
    fs::path level() const
    {
        fs::copy_file(model_, disk_ / "prism.glb");
        std::ofstream(disk_ / "a.level.json") << R"({"format": "hatchway-level/1", "scene": "prism.glb"})";
        return disk_ / "a.level.json";
    }
};

std::string name_of(const testing::TestParamInfo<CommandOutput>& info)
{
    std::string name = info.param.name;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

}  // namespace

TEST_P(no_room, on_a_full_disk_leaves_what_was_there)
{
    ASSERT_EQ(write(false).exit_code, 0);
    const auto old = state();
    leave_room(0);
    expect_refused(write(true), "No space left on device", old);
    fs::remove(disk_ / "filler");
    leave_room(4096);
    const ProgramResult into_a_page = write(true);  // some outputs are as small
    if (into_a_page.exit_code != 0) expect_refused(into_a_page, "No space left on device", old);
    fs::remove(disk_ / "filler");
    EXPECT_EQ(write(true).exit_code, 0);
    EXPECT_NE(state(), old) << "with room it is written";
}

TEST_P(no_room, on_a_read_only_disk_leaves_what_was_there)
{
    ASSERT_EQ(write(false).exit_code, 0);
    make_read_only();
    expect_refused(write(true), "Read-only file system|nothing can be written into the folder", state());
}

TEST_P(no_room, in_a_folder_of_somebody_else_leaves_what_was_there)
{
    ASSERT_EQ(write(false).exit_code, 0);
    ::chmod(disk_.c_str(), 0555);
    expect_refused(write(true, {.is_root_like_others = true}),
                   "Permission denied|nothing can be written into the folder", state());
}

INSTANTIATE_TEST_SUITE_P(of, no_room, testing::Values(kMapFolder, kCompiled, kBaked, kPicture, kSvg, kPdf), name_of);

TEST_F(no_room_for_a_walk, a_save_says_so_and_leaves_the_level)
{
    const fs::path file = level();
    const std::string before = bytes_of(file);
    leave_room(0);
    EXPECT_THAT(save(file), HasSubstr("No space left on device"));
    EXPECT_EQ(bytes_of(file), before);
    fs::remove(disk_ / "filler");
    make_read_only();
    EXPECT_THAT(save(file), HasSubstr("is write-protected"));
    EXPECT_EQ(bytes_of(file), before);
    EXPECT_EQ(left_behind_in(disk_), 0);
}

TEST_F(no_room_for_a_walk, what_is_unsaved_is_kept_in_the_state_folder_instead)
{
    ::setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
    const fs::path file = level();
    {
        hw::Autosave walk(file);
        walk.keep("one");
        leave_room(0);
        walk.keep(std::string(10'000, 't'));
    }
    EXPECT_EQ(hw::Autosave(file).left(), std::string(10'000, 't')) << "not what was kept beside before";
    make_read_only();
    hw::Autosave(file).keep("three");
    EXPECT_EQ(hw::Autosave(file).left(), "three");
    ::unsetenv("XDG_STATE_HOME");
}
