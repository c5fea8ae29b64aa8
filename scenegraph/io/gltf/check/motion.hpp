#pragma once

#include "hatchway/io/gltf/check/gltf_checked.hpp"

namespace hw {

/// Skins have a matrix for each joint, animations the values that their keys ask for.
void check_motion(const GltfChecked& gltf);

}  // namespace hw
