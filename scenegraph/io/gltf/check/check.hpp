#pragma once

#include <string>

#include "hatchway/io/json/fwd.hpp"

namespace hw {

/// Proves that a glTF document keeps its promises, as far as the JSON alone tells: everything that gltf_rules() states;
/// buffer views inside of their buffers, accessors inside of their views; a node tree without loops, within limits;
/// attributes of the right types and of equal counts; counts of weights, matrices and animation keys. Whole numbers
/// written as 1.0 become whole. Throws hw::Error with the JSON pointer. Private to io.
void check_gltf(nlohmann::json& document, const std::string& file);

}  // namespace hw
