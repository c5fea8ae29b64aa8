#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hw {

/// The parts of a glTF file, views into its bytes. Private to io.
struct GltfParts {
    std::string_view json;
    std::optional<std::span<const std::byte>> binary;  ///< The BIN chunk of a .glb.
};

/// Splits a .glb into its chunks; a file without its magic number is JSON as a whole, if its
/// name does not end in .glb. Throws hw::Error with the byte
/// where the container is broken.
GltfParts split_gltf(std::span<const std::byte> bytes, const std::string& file);

}  // namespace hw
