#pragma once

#include "hatchway/io/gltf/check/gltf_checked.hpp"

namespace hw {

/// The nodes are a tree without loops, their transforms are of one kind, their extras are as we read them.
void check_nodes(const GltfChecked& gltf);

}  // namespace hw
