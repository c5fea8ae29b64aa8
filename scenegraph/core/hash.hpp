#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace hw {

/// FNV-1a over bytes, continued from `seed`. For cache keys and equality of images, not against an adversary.
std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t seed = 0xcbf29ce484222325ull);

}  // namespace hw
