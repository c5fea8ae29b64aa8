#pragma once

#include <span>

#include "hatchway/io/gltf/check/property_rules.hpp"

namespace hw {

/// The rules of a whole glTF document, extensions that we read included.
std::span<const PropertyRule> gltf_rules();

}  // namespace hw
