// EXT_mesh_primitive_edge_visibility on two triangles of a square: the first line is the extension's JSON, what follows
// the bytes that accessor 2 reads.
#include <fmt/format.h>

#include "tests/fuzz/target.hpp"
#include "tests/io/gltf/model_builder.hpp"

namespace {

constexpr const char* kDocument = R"({{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": {0}}}],
"bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 12}},
                {{"buffer": 0, "byteOffset": 60, "byteLength": {1}}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4}},
              {{"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 6}},
              {{"bufferView": 2, "componentType": 5121, "type": "SCALAR", "count": {1}}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1,
             "extensions": {{"EXT_mesh_primitive_edge_visibility": {2}}}}}]}}],
"nodes": [{{"mesh": 0}}], "extensionsUsed": ["EXT_mesh_primitive_edge_visibility"]}})";

template <typename Value>
std::string bytes_of(const std::vector<Value>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

}  // namespace

void hw::fuzz::try_bytes(std::string_view bytes)
{
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string extension(bytes.substr(0, end)), visibility(bytes.substr(std::min(end + 1, bytes.size())));
    const std::string square =
        bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
    use_gltf(ModelBuilder::container(
        fmt::format(kDocument, square.size() + visibility.size(), visibility.size(), extension), square + visibility));
}
