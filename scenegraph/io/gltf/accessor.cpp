#include "hatchway/io/gltf/accessor.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>

#include "hatchway/io/gltf/check/buffers.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

constexpr const char* kTypeNames[] = {"", "", "VEC2", "VEC3", "VEC4"};

std::string type_name(int type)
{
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return "SCALAR";
        case TINYGLTF_TYPE_MAT2:
            return "MAT2";
        case TINYGLTF_TYPE_MAT3:
            return "MAT3";
        case TINYGLTF_TYPE_MAT4:
            return "MAT4";
        default:
            return kTypeNames[type];
    }
}

/// Unaligned data are read too: the format forbids them, exporters write them.
template <typename T>
T read_as(const std::byte* place)
{
    T value;
    std::memcpy(&value, place, sizeof(T));
    return value;
}

template <typename T>
float read_component(const std::byte* place, bool is_normalised)
{
    const auto value = static_cast<float>(read_as<T>(place));
    return is_normalised ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f) : value;
}

std::uint32_t read_unsigned(const std::byte* place, int component_type)
{
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return read_as<std::uint8_t>(place);
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return read_as<std::uint16_t>(place);
    return read_as<std::uint32_t>(place);
}

float read_float(const std::byte* place, int component_type, bool is_normalised)
{
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return read_component<std::int8_t>(place, is_normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return read_component<std::uint8_t>(place, is_normalised);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return read_component<std::int16_t>(place, is_normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return read_component<std::uint16_t>(place, is_normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return read_component<std::uint32_t>(place, is_normalised);
        default:
            return read_as<float>(place);
    }
}

}  // namespace

AccessorReader::AccessorReader(const GltfModel& model, int index)
{
    const tinygltf::Accessor& accessor = model.data.accessors[index];
    const ElementSize element = element_size(accessor.componentType, type_name(accessor.type));
    count_ = accessor.count;
    components_ = element.components;
    component_type_ = accessor.componentType;
    is_normalised_ = accessor.normalized;
    element_bytes_ = element.bytes;
    stride_ = element.bytes;
    if (accessor.bufferView >= 0) {
        const std::size_t view_stride = model.data.bufferViews[accessor.bufferView].byteStride;
        if (view_stride != 0) stride_ = view_stride;
        bytes_ = model.view(accessor.bufferView).subspan(accessor.byteOffset);
    }
    if (accessor.sparse.isSparse) read_sparse_indices(model, accessor, index);
}

void AccessorReader::read_sparse_indices(const GltfModel& model, const tinygltf::Accessor& accessor, int index)
{
    const auto& sparse = accessor.sparse;
    const std::size_t bytes = element_size(sparse.indices.componentType, "SCALAR").bytes;
    const auto indices = model.view(sparse.indices.bufferView).subspan(sparse.indices.byteOffset);
    sparse_values_ = model.view(sparse.values.bufferView).subspan(sparse.values.byteOffset);
    for (int i = 0; i < sparse.count; ++i) {
        const std::uint32_t element = read_unsigned(indices.data() + i * bytes, sparse.indices.componentType);
        const bool is_rising = sparse_elements_.empty() || element > sparse_elements_.back();
        if (!is_rising || element >= count_)
            model.refuse(pointer_to("/accessors", static_cast<std::size_t>(index)) + "/sparse/indices",
                         fmt::format("index {} stands at place {}", element, i),
                         fmt::format("rising indices below {}", count_));
        sparse_elements_.push_back(element);
    }
}

const std::byte* AccessorReader::find(std::size_t element) const
{
    const auto found = std::ranges::lower_bound(sparse_elements_, element);
    if (found != sparse_elements_.end() && *found == element)
        return sparse_values_.data() + (found - sparse_elements_.begin()) * element_bytes_;
    return bytes_.empty() ? nullptr : bytes_.data() + element * stride_;
}

glm::vec4 AccessorReader::at(std::size_t element) const
{
    glm::vec4 value(0.0f);
    const std::byte* place = find(element);
    if (!place) return value;
    const std::size_t component_bytes = element_size(component_type_, "SCALAR").bytes;
    for (int i = 0; i < std::min(components_, 4); ++i)
        value[i] = read_float(place + i * component_bytes, component_type_, is_normalised_);
    return value;
}

std::uint32_t AccessorReader::index_at(std::size_t element) const
{
    const std::byte* place = find(element);
    return place ? read_unsigned(place, component_type_) : 0;
}

}  // namespace hw
