#pragma once

#include <string>

#include "hatchway/style/needs.hpp"

namespace hw {

/// The image that a text on the command line names: "edge_map operator=c1 width_px=2". Throws hw::Error when it is
/// empty or a parameter has no value.
ImageKey image_key_of(const std::string& text);

}  // namespace hw
