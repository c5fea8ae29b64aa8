#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hw {

/// A number to sort by, and what it stands for.
struct KeyedIndex {
    std::uint32_t key;
    std::uint32_t index;
};

/// Sorts by rising key, in linear time; equal keys keep their order.
inline void radix_sort(std::vector<KeyedIndex>& items)
{
    constexpr int kBits = 11, kPasses = 3;
    constexpr std::uint32_t kDigits = 1u << kBits;
    std::array<std::array<std::uint32_t, kDigits>, kPasses> begin{};
    const auto digit = [](std::uint32_t key, int pass) { return key >> (kBits * pass) & (kDigits - 1); };
    for (const KeyedIndex& item : items)
        for (int pass = 0; pass < kPasses; ++pass) ++begin[pass][digit(item.key, pass)];
    std::vector<KeyedIndex> other(items.size());
    for (int pass = 0; pass < kPasses; ++pass) {
        std::uint32_t sum = 0;
        for (std::uint32_t& count : begin[pass]) {
            const std::uint32_t own = count;
            count = sum;
            sum += own;
        }
        for (const KeyedIndex& item : items) other[begin[pass][digit(item.key, pass)]++] = item;
        items.swap(other);
    }
}

}  // namespace hw
