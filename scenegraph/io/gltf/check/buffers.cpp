#include "hatchway/io/gltf/check/buffers.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr std::size_t kColumnAlignment = 4;
constexpr std::uint64_t kMaxZeroElements = 1u
                                           << 20;  ///< Of an accessor without data: its count costs the file nothing.

void check_view(const GltfChecked& gltf, const json& view, const std::string& pointer)
{
    const json& buffer = gltf.list("buffers")[*gltf.index(view, "buffer")];
    const std::uint64_t size = gltf.whole(buffer, "byteLength", 0);
    const std::uint64_t offset = gltf.whole(view, "byteOffset", 0);
    const std::uint64_t length = gltf.whole(view, "byteLength", 0);
    const std::uint64_t stride = gltf.whole(view, "byteStride", 4);
    if (stride % 4 != 0)
        gltf.refuse(pointer + "/byteStride", fmt::format("the stride is {}", stride), "a multiple of 4");
    if (offset > size || length > size - offset)
        gltf.refuse(pointer + "/byteLength", fmt::format("the view ends at byte {}", offset + length),
                    fmt::format("at most the buffer's {}", size));
}

struct Layout {
    std::uint64_t offset = 0;
    std::uint64_t stride = 0;
    std::uint64_t element = 0;
    std::uint64_t count = 0;
};

/// All operands are below 2^54, strides below 2^8: nothing overflows.
void check_fits(const GltfChecked& gltf, const json& object, const Layout& layout, const std::string& pointer)
{
    const json& view = gltf.list("bufferViews")[*gltf.index(object, "bufferView")];
    const std::uint64_t stride = gltf.whole(view, "byteStride", layout.stride);
    if (stride < layout.element)
        gltf.refuse(pointer, fmt::format("elements of {} bytes stand in a view of stride {}", layout.element, stride),
                    "a stride of at least an element");
    const std::uint64_t end = layout.offset + stride * (layout.count - 1) + layout.element;
    const std::uint64_t size = gltf.whole(view, "byteLength", 0);
    if (end > size)
        gltf.refuse(pointer, fmt::format("the data end at byte {} of the view", end), fmt::format("at most {}", size));
}

void check_sparse(const GltfChecked& gltf, const json& accessor, const ElementSize& element, const std::string& pointer)
{
    const json& sparse = accessor.at("sparse");
    const std::uint64_t count = gltf.whole(sparse, "count", 0);
    const std::uint64_t base_count = gltf.whole(accessor, "count", 0);
    if (count > base_count)
        gltf.refuse(pointer + "/sparse/count", fmt::format("{} elements are overridden", count),
                    fmt::format("at most the accessor's {}", base_count));
    const json& indices = sparse.at("indices");
    const json& values = sparse.at("values");
    const auto index = element_size(indices.at("componentType").get<int>(), "SCALAR");
    check_fits(
        gltf, indices,
        {.offset = gltf.whole(indices, "byteOffset", 0), .stride = index.bytes, .element = index.bytes, .count = count},
        pointer + "/sparse/indices");
    check_fits(gltf, values,
               {.offset = gltf.whole(values, "byteOffset", 0),
                .stride = element.bytes,
                .element = element.bytes,
                .count = count},
               pointer + "/sparse/values");
}

}  // namespace

ElementSize element_size(int component_type, const std::string& type)
{
    const std::size_t bytes = component_type <= 5121 ? 1 : component_type <= 5123 ? 2 : 4;
    const auto of = [&](int components) {
        return ElementSize{.bytes = bytes * components, .components = components, .component_bytes = bytes};
    };
    if (type == "SCALAR") return of(1);
    if (type.starts_with("VEC")) return of(type[3] - '0');
    // Columns of matrices start on multiples of four bytes.
    const int side = type[3] - '0';
    const std::size_t column = (bytes * side + kColumnAlignment - 1) / kColumnAlignment * kColumnAlignment;
    return {.bytes = column * side, .components = side * side, .component_bytes = bytes};
}

void check_buffers(const GltfChecked& gltf)
{
    const json& views = gltf.list("bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) check_view(gltf, views[i], pointer_to("/bufferViews", i));

    const json& accessors = gltf.list("accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) {
        const json& accessor = accessors[i];
        const std::string pointer = pointer_to("/accessors", i);
        const ElementSize element =
            element_size(accessor.at("componentType").get<int>(), accessor.at("type").get_ref<const std::string&>());
        if (accessor.contains("bufferView"))
            check_fits(gltf, accessor,
                       {.offset = gltf.whole(accessor, "byteOffset", 0),
                        .stride = element.bytes,
                        .element = element.bytes,
                        .count = gltf.whole(accessor, "count", 1)},
                       pointer);
        else if (gltf.whole(accessor, "count", 1) > kMaxZeroElements)
            gltf.refuse(pointer + "/count", fmt::format("{} elements have no bufferView", accessor.at("count").dump()),
                        fmt::format("at most {}", kMaxZeroElements));
        if (accessor.contains("sparse")) check_sparse(gltf, accessor, element, pointer);
    }
}

}  // namespace hw
