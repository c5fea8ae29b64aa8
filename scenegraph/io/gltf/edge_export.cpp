#include "hatchway/io/gltf/edge_export.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/io/gltf/edges.hpp"
#include "hatchway/io/gltf/mesh.hpp"

namespace hw {
namespace {

constexpr const char* kExtension = "EXT_mesh_primitive_edge_visibility";
constexpr int kUnsignedByte = 5121;

enum Visibility : std::uint8_t { hidden, silhouette, drawn, repeated };

/// What each edge of a surface shows, by its two positions, lower first.
using EdgeValues = std::map<std::array<std::uint32_t, 2>, Visibility>;

EdgeValues edge_values(const Surface& surface, float crease_rad, EdgeExport& counts)
{
    EdgeValues values;
    const EdgeClasses classes = classes_at(surface, crease_rad);
    const auto add = [&](EdgeRange range, Visibility value) {
        for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
            const auto [a, b] = edge_vertices(surface, edge);
            values[{std::min(a, b), std::max(a, b)}] = value;
            ++(value == Visibility::drawn ? counts.drawn_edges : counts.silhouette_edges);
        }
    };
    for (const EdgeRange range : classes.candidates) add(range, Visibility::silhouette);
    for (const EdgeRange range : classes.ridges) add(range, Visibility::drawn);
    for (const EdgeRange range : classes.valleys) add(range, Visibility::drawn);
    for (const EdgeRange range : classes.artist) add(range, Visibility::drawn);
    add(classes.borders, Visibility::drawn);
    return values;
}

/// The corner of a face that stands for a vertex of its triangle: the surface may have turned the face over, and
/// stitching may have moved it a little.
std::uint32_t position_of(const Surface& surface, std::uint32_t face, const glm::vec3& vertex)
{
    const auto& corners = surface.faces[face];
    return *std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
        return glm::distance(glm::dvec3(surface.positions[a]), glm::dvec3(vertex)) <
               glm::distance(glm::dvec3(surface.positions[b]), glm::dvec3(vertex));
    });
}

/// Two bits for each side of each triangle.
std::vector<std::uint8_t> visibility_bits(const MeshData& mesh, const Surface& surface, EdgeValues values)
{
    std::vector<std::uint8_t> bits((mesh.indices.size() + 3) / 4, 0);
    std::vector<std::uint32_t> face_of(mesh.triangle_count(), kNoFace);
    for (std::uint32_t face = 0; face < surface.faces.size(); ++face)
        if (surface.face_triangle[face] != kNoFace) face_of[surface.face_triangle[face]] = face;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (face_of[i / 3] == kNoFace) continue;
        const auto place = [&](std::size_t corner) {
            return position_of(surface, face_of[i / 3], mesh.positions[mesh.indices[corner]]);
        };
        const std::uint32_t from = place(i), to = place(i % 3 == 2 ? i - 2 : i + 1);
        const auto found = values.find({std::min(from, to), std::max(from, to)});
        if (found == values.end()) continue;
        bits[i / 4] = static_cast<std::uint8_t>(bits[i / 4] | found->second << (2 * (i % 4)));
        if (found->second == Visibility::drawn) found->second = Visibility::repeated;
    }
    return bits;
}

class EdgeWriter {
 public:
    EdgeWriter(const std::filesystem::path& file, const std::filesystem::path& root)
        : model_(load_gltf(file, root)), json_(model_.json)
    {
    }

    EdgeExport run(float crease_rad)
    {
        join_buffers();
        if (!json_.contains("meshes")) return counts_;
        for (std::size_t mesh = 0; mesh < json_.at("meshes").size(); ++mesh)
            for (std::size_t i = 0; i < json_.at("meshes")[mesh].at("primitives").size(); ++i)
                add_edges({mesh, i}, crease_rad);
        auto& used = json_["extensionsUsed"];
        if (counts_.primitives > 0 && std::find(used.begin(), used.end(), kExtension) == used.end())
            used.push_back(kExtension);
        if (used.is_null()) json_.erase("extensionsUsed");
        return counts_;
    }

    bool has_images_beside() const
    {
        if (!json_.contains("images")) return false;
        return std::any_of(json_.at("images").begin(), json_.at("images").end(), [](const nlohmann::json& image) {
            return image.contains("uri") && !image.at("uri").get<std::string>().starts_with("data:");
        });
    }

    std::string glb()
    {
        if (!binary_.empty()) json_["buffers"] = {{{"byteLength", binary_.size()}}};
        std::string text = json_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::size_t binary_size = binary_.empty() ? 0 : 8 + binary_.size();
        std::string bytes = "glTF";
        append_word(bytes, 2);
        append_word(bytes, static_cast<std::uint32_t>(20 + text.size() + binary_size));
        append_word(bytes, static_cast<std::uint32_t>(text.size()));
        bytes += "JSON" + text;
        if (binary_.empty()) return bytes;
        append_word(bytes, static_cast<std::uint32_t>(binary_.size()));
        bytes.append("BIN\0", 4);
        return bytes + binary_;
    }

 private:
    static void append_word(std::string& bytes, std::uint32_t word)
    {
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i) & 0xff);
    }
    void pad() { binary_.resize((binary_.size() + 3) / 4 * 4, '\0'); }

    /// A .glb holds one buffer.
    void join_buffers()
    {
        std::vector<std::size_t> first;
        for (const tinygltf::Buffer& buffer : model_.data.buffers) {
            first.push_back(binary_.size());
            binary_.append(reinterpret_cast<const char*>(buffer.data.data()), buffer.data.size());
            pad();
        }
        if (!json_.contains("bufferViews")) return;
        for (nlohmann::json& view : json_["bufferViews"]) {
            const std::size_t offset = view.value("byteOffset", std::size_t{0}) + first[view.at("buffer").get<int>()];
            view["buffer"] = 0;
            view["byteOffset"] = offset;
        }
    }

    bool is_solid(const nlohmann::json& primitive) const
    {
        if (!primitive.contains("material")) return true;
        const nlohmann::json& material = json_.at("materials")[primitive.at("material").get<int>()];
        return material.value("alphaMode", "OPAQUE") == "OPAQUE" && !material.value("doubleSided", false);
    }

    void add_edges(const PrimitiveId& id, float crease_rad)
    {
        nlohmann::json& primitive = json_["meshes"][id.mesh]["primitives"][id.primitive];
        const bool is_list = primitive.value("mode", TINYGLTF_MODE_TRIANGLES) == TINYGLTF_MODE_TRIANGLES;
        std::optional<MeshData> mesh;
        if (is_list) mesh = convert_primitive(model_, id, totals_);
        if (!mesh) {
            ++counts_.skipped_primitives;
            return;
        }
        mesh->artist_edges = artist_edges(model_, id, *mesh);
        const Surface surface = build_surface(*mesh, {.is_solid = is_solid(primitive)});
        const std::vector<std::uint8_t> bits =
            visibility_bits(*mesh, surface, edge_values(surface, crease_rad, counts_));
        const std::size_t view = json_["bufferViews"].size(), accessor = json_["accessors"].size();
        json_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bits.size()}});
        json_["accessors"].push_back(
            {{"bufferView", view}, {"componentType", kUnsignedByte}, {"count", bits.size()}, {"type", "SCALAR"}});
        primitive["extensions"][kExtension] = {{"visibility", accessor}};
        binary_.append(bits.begin(), bits.end());
        pad();
        ++counts_.primitives;
    }

    GltfModel model_;
    nlohmann::json json_;
    std::string binary_;
    Budget budget_;
    ImportTotals totals_{budget_};
    EdgeExport counts_;
};

}  // namespace

EdgeExport export_edges(const std::filesystem::path& model, const std::filesystem::path& project_root,
                        const std::filesystem::path& out, float crease_rad)
{
    EdgeWriter writer(model, project_root);
    const auto folder = [](const std::filesystem::path& file) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(file).parent_path());
    };
    if (writer.has_images_beside() && folder(model) != folder(out))
        throw Error({.what = "the images of the model lie beside it, and the result would not find them",
                     .file = out.string(),
                     .expected = "a name in the folder of the model"});
    const EdgeExport counts = writer.run(crease_rad);
    write_file_atomically(out, writer.glb());
    return counts;
}

}  // namespace hw
