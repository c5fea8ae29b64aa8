#pragma once

#include <cstddef>

#include "hatchway/io/gltf/check/gltf_checked.hpp"

namespace hw {

/// How many morph targets a mesh has.
std::size_t target_count(const nlohmann::json& mesh);

/// Attributes and indices have the types of glTF and equal counts; as many weights as morph targets.
void check_meshes(const GltfChecked& gltf);

}  // namespace hw
