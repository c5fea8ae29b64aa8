#include "hatchway/core/radix_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

TEST(radix_sort, does_what_a_stable_sort_does_in_all_bits_of_the_keys)
{
    std::mt19937 random(3);
    for (const std::uint32_t most : {0u, 7u, 4000u, 1u << 23, ~0u}) {
        std::vector<hw::KeyedIndex> items;
        for (std::uint32_t i = 0; i < 5000; ++i)
            items.push_back({static_cast<std::uint32_t>(random() % (std::uint64_t{most} + 1)), i});
        std::vector<hw::KeyedIndex> expected = items;
        std::stable_sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
        hw::radix_sort(items);
        ASSERT_EQ(items.size(), expected.size());
        for (std::size_t i = 0; i < items.size(); ++i) {
            ASSERT_EQ(items[i].key, expected[i].key);
            ASSERT_EQ(items[i].index, expected[i].index) << "equal keys keep their order";
        }
    }
}

TEST(radix_sort, of_nothing_is_nothing)
{
    std::vector<hw::KeyedIndex> items;
    hw::radix_sort(items);
    EXPECT_TRUE(items.empty());
}
