#pragma once

#include <cstddef>
#include <string>

#include "hatchway/io/gltf/check/gltf_checked.hpp"

namespace hw {

/// An element of a glTF type, as an accessor stores it: bytes in all, and components.
struct ElementSize {
    std::size_t bytes = 0;
    int components = 0;
    std::size_t component_bytes = 0;
};
ElementSize element_size(int component_type, const std::string& type);

/// Views lie inside of their buffers, accessors inside of their views, sparse ones too.
void check_buffers(const GltfChecked& gltf);

}  // namespace hw
