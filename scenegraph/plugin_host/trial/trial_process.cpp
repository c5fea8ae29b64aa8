#include "hatchway/plugin_host/trial/trial_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "hatchway/core/files/files.hpp"
#include "hatchway/core/files/folder_handle.hpp"
#include "hatchway/plugin_host/trial/endings.hpp"

namespace hw {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongest(10);
constexpr rlim_t kMostCpu_s = 60;  // of what it started and left behind, too
constexpr rlim_t kMostBytes = 1ull << 30;
constexpr int kReportPipe = 3;
constexpr int kAskAgain_ms = 20;
constexpr std::string_view kDrawn = "drawn", kPrepared = "prepared", kMemory = "memory";

struct Child {
    pid_t id = -1;
    Descriptor report{-1};
};

/// The program with `words`, its report on descriptor kReportPipe; no id when it cannot be started.
Child started(const std::filesystem::path& program, std::array<std::string, 3> words)
{
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {};
    Child child{-1, Descriptor(ends[0])};
    const Descriptor write_end(ends[1]);
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, write_end.value(), kReportPipe);
    posix_spawnattr_t how;
    ::posix_spawnattr_init(&how);
    ::posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
    ::posix_spawnattr_setpgroup(&how, 0);
    std::array<char*, 4> argv{words[0].data(), words[1].data(), words[2].data(), nullptr};
    if (::posix_spawn(&child.id, program.c_str(), &files, &how, argv.data(), environ) != 0) child.id = -1;
    ::posix_spawnattr_destroy(&how);
    ::posix_spawn_file_actions_destroy(&files);
    return child;
}

/// Where the program stands of the installation that this library is of.
std::filesystem::path program_file()
{
    return installation_prefix() / "bin" / "hatchway";
}

/// Adds what the pipe holds; false when nobody holds its other end any more.
bool read_some(int pipe, std::string& report)
{
    std::array<char, 256> part;
    const ssize_t count = ::read(pipe, part.data(), part.size());
    if (count > 0) report.append(part.data(), static_cast<std::size_t>(count));
    return count != 0;
}

/// Adds what the child tells until it ends; false when it does not end in time.
bool ends_in_time(const Child& child, std::string& report)
{
    const auto end = Clock::now() + kLongest;
    pollfd waiting{child.report.value(), POLLIN, 0};
    while (Clock::now() < end) {
        siginfo_t ended = {};
        const int status = ::waitid(P_PID, static_cast<id_t>(child.id), &ended, WEXITED | WNOHANG | WNOWAIT);
        if (status != 0 || ended.si_pid != 0) {  // who ignores the ends of children is not told of them
            while (::poll(&waiting, 1, 0) > 0 && read_some(waiting.fd, report)) continue;
            return true;
        }
        if (::poll(&waiting, 1, kAskAgain_ms) > 0 && !read_some(waiting.fd, report)) waiting.fd = -1;
    }
    return false;
}

/// The last line of the report.
std::string_view last_line(std::string_view report)
{
    if (report.ends_with('\n')) report.remove_suffix(1);
    return report.substr(report.rfind('\n') + 1);  // npos + 1 is 0
}

std::string words_of(int status)
{
    if (WIFSIGNALED(status)) return ending_by(WTERMSIG(status));
    return fmt::format("it ended the program by exit({})", WEXITSTATUS(status));
}

TrialResult result_of(std::string_view report, int status)
{
    if (report.empty()) return {.is_started = false};
    const std::string_view last = last_line(report);
    const bool has_ended = last == kDrawn || last == kPrepared;
    if (has_ended && WIFEXITED(status) && WEXITSTATUS(status) == 0) return {.is_drawn = last == kDrawn};
    if (last == kMemory) return {.why = "it took more than a gigabyte of memory in its trial"};
    return {.why = fmt::format("{} in its trial, {}", words_of(status), has_ended ? "being unloaded" : last)};
}

}  // namespace

TrialResult try_in_process(const std::filesystem::path& library)
{
    const Child child =
        started(program_file(), {"hatchway", "try-plugin", std::filesystem::absolute(library).string()});
    if (child.id < 0) return {.is_started = false};
    std::string report;
    const bool is_in_time = ends_in_time(child, report);
    ::kill(-child.id, SIGKILL);  // before its id may become another's: it is not waited for yet
    int status = 0;
    while (::waitpid(child.id, &status, 0) < 0 && errno == EINTR) continue;
    if (is_in_time) return result_of(report, status);
    return {.why =
                fmt::format("it did not end within {} seconds in its trial, {}", kLongest.count(), last_line(report))};
}

TrialReport::TrialReport() : pipe_(kReportPipe)
{
    const auto limit = [](auto resource, rlim_t most) {
        const rlimit both{most, most};
        ::setrlimit(resource, &both);
    };
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, kMostCpu_s);
#ifndef __SANITIZE_ADDRESS__  // which takes far more, of addresses that it does not use
    limit(RLIMIT_DATA, kMostBytes);
#endif
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::fcntl(pipe_, F_SETFD, FD_CLOEXEC);
}

void TrialReport::end(bool is_drawn) const
{
    tell(is_drawn ? kDrawn : kPrepared);
}

void TrialReport::fail_for_memory() const
{
    tell(kMemory);
    ::_exit(1);
}

void TrialReport::tell(std::string_view line) const
{
    std::array<char, 128> text;
    const std::size_t size = std::min(line.size(), text.size() - 1);
    std::memcpy(text.data(), line.data(), size);
    text[size] = '\n';
    [[maybe_unused]] const ssize_t told = ::write(pipe_, text.data(), size + 1);
}

}  // namespace hw
