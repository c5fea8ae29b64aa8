#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hatchway/world/light/lightmap.hpp"

namespace hw {

/// The lightmap as bytes, and back. Reading checks a hash over all bytes, then every count, index and place against
/// the scene, and throws hw::Error that names `file` for whatever does not fit.
std::vector<std::byte> lightmap_bytes(const Lightmap& lightmap);
Lightmap lightmap_from_bytes(std::span<const std::byte> bytes, const Scene& scene, const std::string& file);

}  // namespace hw
