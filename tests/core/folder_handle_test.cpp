#include "hatchway/core/files/folder_handle.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/folder_draft.hpp"
#include "tests/temporary_folder.hpp"

namespace {
namespace fs = std::filesystem;

std::vector<std::byte> bytes(std::size_t count, char value)
{
    return std::vector<std::byte>(count, static_cast<std::byte>(value));
}

std::size_t count_in(const fs::path& folder)
{
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// A process that does `work` until it is killed.
template <typename Work>
pid_t start(Work work)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    for (unsigned round = 0;; ++round) work(round);
}

/// Starts `work` and kills it at a random moment, HATCHWAY_KILLS times; `check` looks each time.
template <typename Work, typename Check>
void kill_at_random(Work work, Check check)
{
    const char* stated = std::getenv("HATCHWAY_KILLS");
    const int times = stated ? std::atoi(stated) : 100;
    std::mt19937 random(7);
    std::uniform_int_distribution<int> moment_us(0, 25000);
    for (int i = 0; i < times; ++i) {
        const pid_t child = start(work);
        ::usleep(static_cast<useconds_t>(moment_us(random)));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        check();
    }
}

}  // namespace

TEST(folder_handle, follows_no_link_in_it)
{
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "outside");
    folder.write("outside/secret", "secret");
    fs::create_directories(folder.path() / "in");
    fs::create_directory_symlink("../outside", folder.path() / "in/link");
    fs::create_symlink("../outside/secret", folder.path() / "in/file");
    const hw::FolderHandle in(folder.path() / "in");
    EXPECT_THROW(in.folder("link"), hw::Error);
    EXPECT_THROW(in.made_folder("link", 0700), hw::Error);
    EXPECT_THROW(in.read("file", 100), hw::Error);
    EXPECT_FALSE(in.read("none", 100).has_value());
    for (const char* name : {"..", ".", "", "a/b", "../outside/secret"}) {
        EXPECT_THROW(in.read(name, 100), hw::Error) << name;
        EXPECT_THROW(in.write(name, {}), hw::Error) << name;
        EXPECT_THROW(in.folder(name), hw::Error) << name;
    }
    in.write("file", bytes(3, 'n'));
    in.remove("link");
    EXPECT_EQ(hw::read_text_file(folder.path() / "outside/secret", 100), "secret");
}

TEST(folder_handle, a_kill_at_any_moment_leaves_the_old_file_or_the_new)
{
    const TemporaryFolder folder;
    const hw::FolderHandle handle(folder.path());
    handle.write("file", bytes(1, 'a'));
    kill_at_random(
        [&](unsigned round) {
            handle.write("file", bytes(1 + round * 4093 % 50000, static_cast<char>('a' + round % 26)));
        },
        [&] {
            const auto found = handle.read("file", 1 << 20);
            ASSERT_TRUE(found && !found->empty());
            const auto round = static_cast<unsigned>(found->front()) - 'a';
            ASSERT_EQ(*found, std::vector<std::byte>(found->size(), found->front())) << round;
        });
}

TEST(folder_handle, the_next_process_removes_what_a_killed_one_left)
{
    const TemporaryFolder folder;
    const auto leave = [&](const char* name) { std::ofstream(folder.path() / name) << "left"; };
    fs::create_directory(folder.path() / ".hatchway-00000000f01de400.tmp");
    fs::create_directory(folder.path() / ".hatchway-plan.tmp");  // a user's own
    for (const char* name : {".hatchway-0123456789abcdef.tmp", ".hatchway-00000000f01de400.tmp/level_0.png",
                             ".hatchway-00000000000e1d00.tmp", ".hatchway-other.tmp2", "kept",
                             ".hatchway-plan.tmp/thesis.txt", ".hatchway-0123456789ABCDEF.tmp"})
        leave(name);
    fs::create_symlink("kept", folder.path() / ".hatchway-0000000000000011.tmp");
    const hw::Descriptor lock(::open((folder.path() / ".hatchway-00000000000e1d00.tmp").c_str(), O_RDONLY | O_CLOEXEC));
    ASSERT_EQ(::flock(lock.value(), LOCK_EX), 0) << "as a process that lives";
    hw::FolderHandle(folder.path()).write("new", bytes(3, 'n'));
    EXPECT_FALSE(fs::exists(folder.path() / ".hatchway-0123456789abcdef.tmp"));
    EXPECT_FALSE(fs::exists(folder.path() / ".hatchway-00000000f01de400.tmp"));
    for (const char* name :
         {".hatchway-00000000000e1d00.tmp", ".hatchway-other.tmp2", ".hatchway-0000000000000011.tmp", "kept", "new",
          ".hatchway-plan.tmp", ".hatchway-plan.tmp/thesis.txt", ".hatchway-0123456789ABCDEF.tmp"})
        EXPECT_TRUE(fs::exists(fs::symlink_status(folder.path() / name))) << name;
}

TEST(folder_lock, lets_one_at_a_time_change_a_folder)
{
    const TemporaryFolder folder;
    const hw::FolderHandle handle(folder.path());
    handle.write("count", {});
    const auto add_one = [&] {
        const hw::FolderLock lock(handle);
        std::vector<std::byte> value = *handle.read("count", 1000);
        value.push_back({});
        handle.write("count", value);
    };
    constexpr int kEach = 20;
    const auto add = [&] {
        for (int i = 0; i < kEach; ++i) add_one();
    };
    const pid_t child = ::fork();
    if (child == 0) {
        add();
        ::_exit(0);
    }
    std::thread other(add);
    add();
    other.join();
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(handle.read("count", 1000)->size(), 3u * kEach);
}

TEST(folder_draft, a_kill_at_any_moment_leaves_the_old_folder_or_the_new)
{
    const TemporaryFolder folder;
    const fs::path place = folder.path() / "map";
    constexpr int kFiles = 5;
    const auto put = [&](unsigned round) {
        hw::FolderDraft draft(place);
        for (int i = 0; i < kFiles; ++i)
            draft.fill(
                [&](const auto& path) { hw::write_file_atomically(path / std::to_string(i), std::to_string(round)); });
        draft.put();
    };
    put(0);
    kill_at_random(put, [&] {
        ASSERT_EQ(count_in(place), static_cast<std::size_t>(kFiles));
        const std::string first = hw::read_text_file(place / "0", 100);
        for (int i = 1; i < kFiles; ++i) ASSERT_EQ(hw::read_text_file(place / std::to_string(i), 100), first);
    });
}

TEST(folder_draft, what_is_not_put_is_gone)
{
    const TemporaryFolder folder;
    {
        hw::FolderDraft draft(folder.path() / "map/");
        draft.fill([](const auto& path) { hw::write_file_atomically(path / "a", std::string_view("a")); });
    }
    EXPECT_EQ(count_in(folder.path()), 0u);
}

TEST(folder_draft, replaces_a_link_and_not_what_it_leads_to)
{
    const TemporaryFolder folder;
    folder.write("outside/file", "old");
    fs::create_directory_symlink("outside", folder.path() / "map");
    hw::FolderDraft draft(folder.path() / "map");
    draft.fill([](const auto& path) { hw::write_file_atomically(path / "file", std::string_view("new")); });
    draft.put();
    EXPECT_FALSE(fs::is_symlink(folder.path() / "map"));
    EXPECT_EQ(hw::read_text_file(folder.path() / "map/file", 100), "new");
    EXPECT_EQ(hw::read_text_file(folder.path() / "outside/file", 100), "old");
    EXPECT_EQ(count_in(folder.path()), 2u);
}

TEST(folder_draft, a_new_folder_replaces_nothing)
{
    const TemporaryFolder folder;
    folder.write("taken/file", "old");
    hw::FolderDraft draft(folder.path() / "taken");
    EXPECT_THROW(draft.put_new(), hw::Error);
    hw::FolderDraft other(folder.path() / "free");
    other.put_new();
    EXPECT_TRUE(fs::is_directory(folder.path() / "free"));
    EXPECT_EQ(hw::read_text_file(folder.path() / "taken/file", 100), "old");
}
