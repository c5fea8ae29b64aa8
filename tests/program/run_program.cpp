#include "tests/program/run_program.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace hw::test {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

/// The user's own folders of all programs that a test runs: nobody's home is touched.
const fs::path& own_folder()
{
    static const TemporaryFolder folder;
    return folder.path();
}

[[noreturn]] void become(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                         const ProgramLimits& limits, int out, int err)
{
    const auto limit = [](__rlimit_resource resource, std::uint64_t most) {
        const rlimit both{most, most};
        if (most != 0) ::setrlimit(resource, &both);
    };
    limit(RLIMIT_CPU, limits.cpu_s);
    limit(RLIMIT_DATA, limits.memory_bytes);
    if (limits.is_root_like_others) ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0);
    ::setenv("XDG_CACHE_HOME", (own_folder() / "cache").c_str(), 1);
    ::setenv("XDG_STATE_HOME", (own_folder() / "state").c_str(), 1);
    for (const std::string& setting : environment) {
        const std::size_t sign = setting.find('=');
        if (sign == std::string::npos)
            ::unsetenv(setting.c_str());
        else
            ::setenv(setting.substr(0, sign).c_str(), setting.c_str() + sign + 1, 1);
    }
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    const std::string program = HATCHWAY_BUILD_DIR "/bin/hatchway";
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(program.c_str(), argv.data());
    ::_exit(127);
}

/// Reads both pipes until their other ends are closed or the time is over.
void read_both(std::array<pollfd, 2> pipes, std::array<std::string*, 2> texts, Clock::time_point end)
{
    int open_count = 2;
    while (open_count > 0) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0 || ::poll(pipes.data(), pipes.size(), static_cast<int>(left)) <= 0) return;
        for (std::size_t i = 0; i < pipes.size(); ++i) {
            if (pipes[i].revents == 0) continue;
            std::array<char, 4096> buffer;
            const ssize_t count = ::read(pipes[i].fd, buffer.data(), buffer.size());
            if (count > 0) {
                texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
            } else {
                pipes[i].fd = -1;
                --open_count;
            }
        }
    }
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments, double limit_s,
                          const std::vector<std::string>& environment, const ProgramLimits& limits)
{
    std::array<int, 2> out{}, err{};
    if (::pipe2(out.data(), O_CLOEXEC) != 0 || ::pipe2(err.data(), O_CLOEXEC) != 0) return {};
    const auto start = Clock::now();
    own_folder();
    const pid_t child = ::fork();
    if (child == 0) become(arguments, environment, limits, out[1], err[1]);
    ::close(out[1]);
    ::close(err[1]);

    ProgramResult result;
    const auto end = start + std::chrono::milliseconds(static_cast<long>(limit_s * 1000.0));
    read_both({pollfd{out[0], POLLIN, 0}, pollfd{err[0], POLLIN, 0}}, {&result.out, &result.err}, end);
    ::close(out[0]);
    ::close(err[0]);
    const bool is_late = Clock::now() >= end;
    if (is_late) ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    result.exit_code = is_late ? 124 : WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return result;
}

void become_program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment)
{
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    become(arguments, environment, {}, nowhere, nowhere);
}

TemporaryFolder::TemporaryFolder()
{
    static std::atomic<int> counter{0};
    path_ = fs::temp_directory_path() /
            ("hatchway_test_" + std::to_string(::getpid()) + "_" + std::to_string(counter.fetch_add(1)));
    fs::remove_all(path_);
    fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder()
{
    fs::remove_all(path_);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const
{
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
}

std::vector<std::string> TemporaryFolder::names() const
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string bytes_of(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

}  // namespace hw::test
