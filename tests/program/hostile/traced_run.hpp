#pragma once

#include <cstdint>
#include <functional>

namespace hw::test {

/// Which system calls count.
enum class Calls : unsigned char {
    all,
    changing,  ///< Those that may change a folder or a file: open to write, write, sync, rename, remove, lock.
};

struct TracedEnd {
    bool is_traced = false;   ///< False: processes may not be looked at here.
    bool is_killed = false;   ///< False: it ended before its turn.
    std::uint64_t calls = 0;  ///< Counted, through all its threads.
    int exit_code = -1;       ///< When it was not killed; 128 + the signal of a crash.
};

/// Runs `body` in a process of its own and ends it by SIGKILL when it is about to make its call number `kill_at`, from
/// 1 on; 0: never. Counts from where the body calls begin_trace(). The process ends with the body.
TracedEnd run_traced(const std::function<void()>& body, std::uint64_t kill_at, Calls counted);

/// In the body: from here on calls count.
void begin_trace();

}  // namespace hw::test
