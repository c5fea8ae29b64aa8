#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "hatchway/io/gltf/model.hpp"

namespace tinygltf {
struct Accessor;
}

namespace hw {

/// Reads the elements of one accessor of a checked model, sparse overrides applied. The model must outlive it. Private
/// to io.
class AccessorReader {
 public:
    /// Throws hw::Error when sparse indices do not rise or are out of range.
    AccessorReader(const GltfModel& model, int accessor);

    std::size_t count() const { return count_; }
    int components() const { return components_; }

    /// Up to four components as floats; normalised ones by glTF's rule. Components that the element lacks are 0.
    glm::vec4 at(std::size_t element) const;

    /// The first component as a whole number, of an accessor with an unsigned component type.
    std::uint32_t index_at(std::size_t element) const;

 private:
    const std::byte* find(std::size_t element) const;
    void read_sparse_indices(const GltfModel& model, const tinygltf::Accessor& accessor, int index);

    std::span<const std::byte> bytes_;  ///< Empty: all elements are zero.
    std::size_t stride_ = 0;
    std::size_t count_ = 0;
    int components_ = 0;
    int component_type_ = 0;
    bool is_normalised_ = false;
    std::vector<std::uint32_t> sparse_elements_;  ///< Rising.
    std::span<const std::byte> sparse_values_;
    std::size_t element_bytes_ = 0;
};

}  // namespace hw
