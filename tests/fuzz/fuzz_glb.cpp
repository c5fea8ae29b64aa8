// Binary glTF files as they are, and with the lengths that they have: else what lies behind a text that was changed
// would be tried only where its length stayed.
#include <cstring>

#include "hatchway/core/error.hpp"
#include "tests/fuzz/target.hpp"

namespace {

void put_word(std::string& bytes, std::size_t place, std::size_t value)
{
    const auto word = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data() + place, &word, sizeof(word));
}

/// The first chunk ends where the second begins, at the word BIN, and the last with the file.
std::string with_true_lengths(std::string bytes)
{
    constexpr std::size_t kHeader = 12, kChunkHeader = 8;
    if (bytes.size() < kHeader + kChunkHeader) return bytes;
    const std::size_t first = kHeader + kChunkHeader;
    std::size_t bin = bytes.find(std::string("BIN\0", 4), first);
    if (bin != std::string::npos && bin >= first + 4) {
        bytes.insert(bin - 4, (4 - (bin - 4 - first) % 4) % 4, ' ');
        bin = bytes.find(std::string("BIN\0", 4), first);
    } else {
        bin = std::string::npos;
    }
    while (bytes.size() % 4 != 0) bytes += ' ';
    put_word(bytes, 8, bytes.size());
    put_word(bytes, kHeader, (bin == std::string::npos ? bytes.size() : bin - 4) - first);
    if (bin != std::string::npos) put_word(bytes, bin - 4, bytes.size() - bin - 4);
    return bytes;
}

}  // namespace

void hw::fuzz::try_bytes(std::string_view bytes)
{
    const std::string sealed = with_true_lengths(std::string(bytes));
    if (sealed != bytes) {
        try {
            use_gltf(sealed);
        } catch (const Error& error) {
            require(exit_code(error) == 2);
        }
    }
    use_gltf(bytes);
}
