// By ptrace and not by strace: a call is counted through all threads, so that every one can be reached.
#include "tests/program/hostile/traced_run.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

namespace hw::test {
namespace {

constexpr long kOptions =
    PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACECLONE | PTRACE_O_TRACEFORK | PTRACE_O_TRACEVFORK | PTRACE_O_EXITKILL;
constexpr int kSystemCall = SIGTRAP | 0x80;

bool is_changing(std::uint64_t call, std::uint64_t flags)
{
    switch (call) {
        case SYS_openat:
            return (flags & (O_WRONLY | O_RDWR | O_CREAT)) != 0;
        case SYS_write:
        case SYS_pwrite64:
        case SYS_writev:
        case SYS_fsync:
        case SYS_fdatasync:
        case SYS_ftruncate:
        case SYS_fallocate:
        case SYS_renameat2:
        case SYS_unlinkat:
        case SYS_mkdirat:
        case SYS_fchmod:
        case SYS_flock:
            return true;
        default:
            break;
    }
#ifdef SYS_rename
    return call == SYS_rename || call == SYS_renameat || call == SYS_mkdir || call == SYS_rmdir || call == SYS_unlink;
#else
    return false;
#endif
}

/// Whether the thread is about to make a call that counts.
bool enters(pid_t thread, Calls counted)
{
    __ptrace_syscall_info info = {};
    if (::ptrace(PTRACE_GET_SYSCALL_INFO, thread, sizeof info, &info) <= 0) return false;
    if (info.op != PTRACE_SYSCALL_INFO_ENTRY) return false;
    return counted == Calls::all || is_changing(info.entry.nr, info.entry.args[2]);
}

class Tracer {
 public:
    Tracer(pid_t child, std::uint64_t kill_at, Calls counted) : child_(child), kill_at_(kill_at), counted_(counted) {}

    TracedEnd run()
    {
        int status = 0;
        ::waitpid(child_, &status, 0);
        if (!WIFSTOPPED(status) || ::ptrace(PTRACE_SETOPTIONS, child_, nullptr, kOptions) != 0) return end_untraced();
        end_.is_traced = true;
        known_.insert(child_);
        ::ptrace(PTRACE_SYSCALL, child_, nullptr, nullptr);
        while (end_.exit_code < 0 && !is_over_) {
            const pid_t thread = ::waitpid(-1, &status, __WALL);
            if (thread < 0) break;
            WIFSTOPPED(status) ? go_on(thread, status) : take_end(thread, status);
        }
        return end_;
    }

 private:
    TracedEnd end_untraced()
    {
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
        return end_;
    }
    void go_on(pid_t thread, int status)
    {
        int signal = WSTOPSIG(status);
        const bool is_first_stop = known_.insert(thread).second && signal == SIGSTOP;
        if (signal == kSystemCall && enters(thread, counted_) && ++end_.calls == kill_at_) {
            end_.is_killed = true;
            ::kill(child_, SIGKILL);
            return;
        }
        if (signal == kSystemCall || signal == SIGTRAP || is_first_stop) signal = 0;
        ::ptrace(PTRACE_SYSCALL, thread, nullptr, signal);
    }
    void take_end(pid_t thread, int status)
    {
        if (thread != child_) return;
        is_over_ = true;
        if (!end_.is_killed) end_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    pid_t child_;
    std::uint64_t kill_at_;
    Calls counted_;
    TracedEnd end_;
    std::set<pid_t> known_;
    bool is_over_ = false;
};

}  // namespace

TracedEnd run_traced(const std::function<void()>& body, std::uint64_t kill_at, Calls counted)
{
    const pid_t child = ::fork();
    if (child == 0) {
        body();
        ::_exit(0);
    }
    return Tracer(child, kill_at, counted).run();
}

void begin_trace()
{
    ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    ::raise(SIGSTOP);
}

}  // namespace hw::test
