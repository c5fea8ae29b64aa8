#include "hatchway/core/disjoint_sets.hpp"

#include <gtest/gtest.h>

TEST(disjoint_sets, are_named_by_their_smallest_number_in_whatever_order_they_are_joined)
{
    hw::DisjointSets rising(6), falling(6);
    for (const std::uint32_t i : {1u, 2u, 4u}) rising.join(i, i + 1);
    for (const std::uint32_t i : {4u, 2u, 1u}) falling.join(i + 1, i);
    for (hw::DisjointSets* sets : {&rising, &falling}) {
        EXPECT_EQ(sets->of(0), 0u);
        for (const std::uint32_t i : {1u, 2u, 3u}) EXPECT_EQ(sets->of(i), 1u);
        EXPECT_EQ(sets->of(5), 4u);
        EXPECT_EQ(sets->join(5, 3), 1u);
        EXPECT_EQ(sets->of(4), 1u);
    }
}

TEST(disjoint_sets, grow_by_numbers_that_are_alone)
{
    hw::DisjointSets sets;
    EXPECT_EQ(sets.size(), 0u);
    sets.add();
    sets.add();
    EXPECT_EQ(sets.size(), 2u);
    EXPECT_EQ(sets.of(1), 1u);
}
