#include "hatchway/io/compiled/packed_rows.hpp"

namespace hw {
namespace {

constexpr std::uint8_t kPlainBits = 0;
constexpr std::uint8_t kRuns = 1;

std::size_t byte_count(int columns)
{
    return (static_cast<std::size_t>(columns) + 7) / 8;
}

void add_length(std::vector<std::uint8_t>& bytes, std::uint32_t length)
{
    for (; length >= 128; length >>= 7) bytes.push_back(static_cast<std::uint8_t>(length | 128));
    bytes.push_back(static_cast<std::uint8_t>(length));
}

bool bit_of(std::span<const std::uint64_t> row, int column)
{
    return (row[static_cast<std::size_t>(column) / 64] >> (column % 64) & 1) != 0;
}

/// False when the runs would be no shorter than the plain bits.
bool add_runs(std::span<const std::uint64_t> row, int columns, std::vector<std::uint8_t>& bytes)
{
    const std::size_t start = bytes.size();
    bytes.push_back(kRuns);
    bool value = false;
    for (int column = 0; column < columns;) {
        const int from = column;
        while (column < columns && bit_of(row, column) == value) ++column;
        add_length(bytes, static_cast<std::uint32_t>(column - from));
        value = !value;
        if (bytes.size() - start > byte_count(columns)) {
            bytes.resize(start);
            return false;
        }
    }
    return true;
}

bool take_length(std::span<const std::uint8_t>& bytes, std::uint32_t& length)
{
    length = 0;
    for (int shift = 0; shift < 28 && !bytes.empty(); shift += 7) {
        const std::uint8_t byte = bytes.front();
        bytes = bytes.subspan(1);
        length |= static_cast<std::uint32_t>(byte & 127) << shift;
        if ((byte & 128) == 0) return true;
    }
    return false;
}

void set_run(std::span<std::uint64_t> row, std::uint32_t from, std::uint32_t end)
{
    for (std::uint32_t column = from; column < end;) {
        const std::uint32_t count = std::min(end - column, 64 - column % 64);
        const std::uint64_t ones = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
        row[column / 64] |= ones << (column % 64);
        column += count;
    }
}

bool take_runs(std::span<const std::uint8_t> bytes, std::uint32_t columns, std::span<std::uint64_t> row)
{
    std::uint32_t column = 0;
    for (bool value = false; column < columns; value = !value) {
        std::uint32_t length = 0;
        if (!take_length(bytes, length) || length > columns - column) return false;
        if (length == 0 && column > 0) return false;
        if (value) set_run(row, column, column + length);
        column += length;
    }
    return bytes.empty();
}

bool take_plain(std::span<const std::uint8_t> bytes, int columns, std::span<std::uint64_t> row)
{
    if (bytes.size() != byte_count(columns)) return false;
    for (std::size_t i = 0; i < bytes.size(); ++i) row[i / 8] |= static_cast<std::uint64_t>(bytes[i]) << (i % 8 * 8);
    return columns % 8 == 0 || bytes.back() >> (columns % 8) == 0;
}

}  // namespace

PackedRows pack_rows(const LeafRows& rows)
{
    PackedRows packed;
    for (int i = 0; i < rows.leaf_count(); ++i) {
        const std::span<const std::uint64_t> row = rows.row(i);
        if (!add_runs(row, rows.column_count(), packed.bytes)) {
            packed.bytes.push_back(kPlainBits);
            for (std::size_t byte = 0; byte < byte_count(rows.column_count()); ++byte)
                packed.bytes.push_back(static_cast<std::uint8_t>(row[byte / 8] >> (byte % 8 * 8)));
        }
        packed.ends.push_back(static_cast<std::uint32_t>(packed.bytes.size()));
    }
    return packed;
}

std::optional<LeafRows> unpack_rows(std::span<const std::uint32_t> ends, std::span<const std::uint8_t> bytes,
                                    int row_count, int column_count)
{
    if (row_count < 0 || column_count < 0 || ends.size() != static_cast<std::size_t>(row_count)) return std::nullopt;
    LeafRows rows(row_count, column_count);
    std::uint32_t begin = 0;
    for (int i = 0; i < row_count; ++i) {
        const std::uint32_t end = ends[static_cast<std::size_t>(i)];
        if (end <= begin || end > bytes.size()) return std::nullopt;
        const std::span<const std::uint8_t> packed = bytes.subspan(begin + 1, end - begin - 1);
        const bool is_good = bytes[begin] == kRuns
                                 ? take_runs(packed, static_cast<std::uint32_t>(column_count), rows.row(i))
                                 : bytes[begin] == kPlainBits && take_plain(packed, column_count, rows.row(i));
        if (!is_good) return std::nullopt;
        begin = end;
    }
    if (begin != bytes.size()) return std::nullopt;
    return rows;
}

}  // namespace hw
