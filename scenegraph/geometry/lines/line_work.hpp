#pragma once

#include <atomic>
#include <cstdint>

#include "hatchway/core/budget.hpp"

namespace hw {

/// The steps of a line drawing, counted on all threads: where they run out, and so whether they do, does not depend on
/// the number of threads.
class LineWork {
 public:
    LineWork() : most_(Budget().left(Cost::line_steps)) {}

    /// Throws hw::Error where the budget runs out.
    void spend(std::uint64_t steps)
    {
        if (spent_.fetch_add(steps, std::memory_order_relaxed) + steps <= most_) return;
        Budget().require(Cost::line_steps, most_ + 1, "", "");
    }

 private:
    std::uint64_t most_;
    std::atomic<std::uint64_t> spent_{0};
};

}  // namespace hw
