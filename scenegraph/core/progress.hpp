#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

namespace hw {

/// A progress bar on stderr for work that takes over a second; silent when stderr is not a terminal.
class Progress {
 public:
    /// `steps` is the amount of work in any unit, at least 1.
    Progress(std::string title, std::uint64_t steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Thread safe.
    void advance(std::uint64_t steps = 1);

 private:
    void draw(std::uint64_t done);

    std::string title_;
    std::uint64_t steps_;
    std::atomic<std::uint64_t> done_{0};
    std::atomic<int> drawn_percent_{-1};
    std::chrono::steady_clock::time_point start_;
    bool is_terminal_;
};

}  // namespace hw
