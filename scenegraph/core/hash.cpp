#include "hatchway/core/hash.hpp"

namespace hw {

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t seed)
{
    std::uint64_t hash = seed;
    for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ull;
    return hash;
}

}  // namespace hw
