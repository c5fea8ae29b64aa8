#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/world/visibility/rows/pvs.hpp"

namespace hw {

/// Rows of bits as bytes. A row begins with 0: the bits as they are, eight to a byte, lowest first; or with 1: lengths
/// of alternating runs, zeros first, seven bits to a byte, lowest first, the top bit set in all bytes of a length but
/// the last.
struct PackedRows {
    std::vector<std::uint32_t> ends;  ///< Where each row ends in `bytes`.
    std::vector<std::uint8_t> bytes;
};

/// Each row in the shorter form.
PackedRows pack_rows(const LeafRows& rows);

/// The rows again; nothing when `ends` or `bytes` do not hold `row_count` rows of exactly `column_count` bits.
std::optional<LeafRows> unpack_rows(std::span<const std::uint32_t> ends, std::span<const std::uint8_t> bytes,
                                    int row_count, int column_count);

}  // namespace hw
