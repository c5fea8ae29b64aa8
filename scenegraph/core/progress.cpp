#include "hatchway/core/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "hatchway/core/plain_text.hpp"

namespace hw {

Progress::Progress(std::string title, std::uint64_t steps)
    : title_(plain_text(title)),
      steps_(std::max<std::uint64_t>(steps, 1)),
      start_(std::chrono::steady_clock::now()),
      is_terminal_(isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
    if (drawn_percent_.load() >= 0) std::fputs("\r\033[K", stderr);
}

void Progress::advance(std::uint64_t steps)
{
    const std::uint64_t done = done_.fetch_add(steps) + steps;
    if (!is_terminal_ || std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
    draw(done);
}

void Progress::draw(std::uint64_t done)
{
    const int percent = static_cast<int>(100 * std::min(done, steps_) / steps_);
    if (drawn_percent_.exchange(percent) == percent) return;
    constexpr int kWidth = 40;
    const int filled = percent * kWidth / 100;
    std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r%s [%s] %3d %%", title_.c_str(), bar.c_str(), percent);
    std::fflush(stderr);
}

}  // namespace hw
