#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace hw::measure {

/// Calls `work(i)` once for each i below `count`, in no certain order, on this thread and others: `threads` in all, 0
/// as many as the machine has. `work` must not throw.
template <typename Work>
void share_work(std::size_t count, unsigned threads, const Work& work)
{
    std::atomic<std::size_t> taken{0};
    const auto take = [&] {
        for (std::size_t i = taken++; i < count; i = taken++) work(i);
    };
    const unsigned all = threads > 0 ? threads : std::thread::hardware_concurrency();
    std::vector<std::thread> others;
    for (unsigned i = 1; i < all; ++i) others.emplace_back(take);
    take();
    for (std::thread& other : others) other.join();
}

}  // namespace hw::measure
