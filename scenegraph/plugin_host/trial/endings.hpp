#pragma once

#include <signal.h>

#include <array>

namespace hw {

/// How a signal ends a program, for messages: "it" is a plugin.
struct Ending {
    int signal;
    const char* what;
};

/// The signals of faults of a program's own.
inline constexpr std::array kEndings{Ending{SIGSEGV, "it crashed (segmentation fault)"},
                                     Ending{SIGBUS, "it crashed (bus error)"},
                                     Ending{SIGFPE, "it crashed (arithmetic error)"},
                                     Ending{SIGILL, "it crashed (illegal instruction)"}, Ending{SIGABRT, "it aborted"}};

/// Safe in a signal handler.
inline const char* ending_by(int signal)
{
    for (const Ending& ending : kEndings)
        if (ending.signal == signal) return ending.what;
    return "it was killed";
}

}  // namespace hw
