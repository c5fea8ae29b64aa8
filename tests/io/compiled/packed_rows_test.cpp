#include "hatchway/io/compiled/packed_rows.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

/// Rows whose bits come in runs of about `run` columns; of the first row none, of the last all.
hw::LeafRows random_rows(std::mt19937& random, int rows, int columns, int run)
{
    hw::LeafRows result(rows, columns);
    for (int row = 0; row < rows; ++row) {
        bool is_shown = row == rows - 1;
        for (int column = 0; column < columns; ++column) {
            if (row > 0 && row < rows - 1 && random() % static_cast<unsigned>(run) == 0) is_shown = !is_shown;
            if (is_shown) result.show(row, column);
        }
    }
    return result;
}

}  // namespace

TEST(packed_rows, come_back_as_they_were)
{
    std::mt19937 random(7);
    for (const int columns : {1, 7, 8, 63, 64, 65, 200, 1000})
        for (const int run : {1, 2, 5, 40, 400}) {
            const hw::LeafRows rows = random_rows(random, 9, columns, run);
            const hw::PackedRows packed = hw::pack_rows(rows);
            const std::optional<hw::LeafRows> again = hw::unpack_rows(packed.ends, packed.bytes, 9, columns);
            ASSERT_TRUE(again) << columns << ' ' << run;
            for (int row = 0; row < 9; ++row)
                for (int column = 0; column < columns; ++column)
                    ASSERT_EQ(again->sees(row, column), rows.sees(row, column)) << columns << ' ' << run;
            EXPECT_FALSE(hw::unpack_rows(packed.ends, packed.bytes, 9, columns + 64)) << "that many bits are not there";
            EXPECT_FALSE(hw::unpack_rows(packed.ends, packed.bytes, 8, columns)) << "a row is left over";
        }
}

TEST(packed_rows, of_long_runs_take_a_fraction_of_their_bits)
{
    std::mt19937 random(7);
    const hw::LeafRows rows = random_rows(random, 50, 8000, 400);
    EXPECT_LT(hw::pack_rows(rows).bytes.size(), 50u * 1000 / 8);
}
