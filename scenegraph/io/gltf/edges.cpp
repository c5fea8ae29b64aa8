#include "hatchway/io/gltf/edges.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <nlohmann/json.hpp>

#include "hatchway/io/gltf/accessor.hpp"

namespace hw {
namespace {

constexpr std::uint32_t kDrawnEdge = 2;
constexpr std::size_t kEdgesPerByte = 4;

}  // namespace

std::vector<std::uint32_t> artist_edges(const GltfModel& model, const PrimitiveId& id, const MeshData& mesh)
{
    const nlohmann::json& primitive = model.json.at("meshes")[id.mesh].at("primitives")[id.primitive];
    const nlohmann::json* extension = GltfModel::extension(primitive, "EXT_mesh_primitive_edge_visibility");
    const bool is_list = model.data.meshes[id.mesh].primitives[id.primitive].mode == TINYGLTF_MODE_TRIANGLES;
    if (!extension || !extension->contains("visibility") || !is_list) return {};

    const int accessor = extension->at("visibility").get<int>();
    const AccessorReader bits(model, accessor);
    const std::size_t edge_count = mesh.indices.size();
    const std::size_t byte_count = (edge_count + kEdgesPerByte - 1) / kEdgesPerByte;
    const bool is_bytes = model.data.accessors[accessor].componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    if (!is_bytes || bits.components() != 1 || bits.count() < byte_count)
        model.refuse(id.pointer() + "/extensions/EXT_mesh_primitive_edge_visibility/visibility",
                     fmt::format("the accessor has {} elements", bits.count()),
                     fmt::format("{} unsigned bytes", byte_count));
    std::vector<std::uint32_t> edges;
    for (std::size_t i = 0; i < edge_count; ++i) {
        const std::uint32_t value = (bits.index_at(i / kEdgesPerByte) >> (2 * (i % kEdgesPerByte))) & 3;
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        if (value == kDrawnEdge) edges.insert(edges.end(), {mesh.indices[i], mesh.indices[next]});
    }
    return edges;
}

}  // namespace hw
