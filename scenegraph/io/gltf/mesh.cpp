#include "hatchway/io/gltf/mesh.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "hatchway/core/limits.hpp"
#include "hatchway/geometry/unit_normal.hpp"
#include "hatchway/geometry/vertex_streams.hpp"
#include "hatchway/io/gltf/accessor.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

/// Reads one primitive, step by step.
class PrimitiveReader {
 public:
    PrimitiveReader(const GltfModel& model, const PrimitiveId& id)
        : model_(model), primitive_(model.data.meshes[id.mesh].primitives[id.primitive]), pointer_(id.pointer())
    {
    }

    bool is_surface() const
    {
        const int mode = primitive_.mode;
        return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
               mode == TINYGLTF_MODE_TRIANGLE_FAN;
    }
    int find(const char* attribute) const
    {
        const auto found = primitive_.attributes.find(attribute);
        return found == primitive_.attributes.end() ? kNone : found->second;
    }
    bool has_targets() const { return !primitive_.targets.empty(); }
    const std::string& pointer() const { return pointer_; }

    /// Three vertices of the model for each triangle.
    std::vector<std::uint32_t> corners(const Budget& budget) const
    {
        const std::size_t vertex_count = model_.data.accessors[find("POSITION")].count;
        const std::vector<std::uint32_t> order = vertex_order(vertex_count, budget);
        const bool is_list = primitive_.mode == TINYGLTF_MODE_TRIANGLES;
        const std::size_t triangle_count = is_list ? order.size() / 3 : order.size() < 3 ? 0 : order.size() - 2;
        budget.require(Cost::triangles, triangle_count, model_.file, pointer_);
        std::vector<std::uint32_t> corners;
        corners.reserve(3 * triangle_count);
        for (std::size_t i = 0; i < triangle_count; ++i) append_triangle(order, i, corners);
        return corners;
    }

 private:
    std::vector<std::uint32_t> vertex_order(std::size_t vertex_count, const Budget& budget) const
    {
        const bool is_indexed = primitive_.indices >= 0;
        const std::size_t count = is_indexed ? model_.data.accessors[primitive_.indices].count : vertex_count;
        budget.require(Cost::triangles, count / 3, model_.file, pointer_);
        std::vector<std::uint32_t> order(count);
        if (!is_indexed) {
            for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(i);
            return order;
        }
        const AccessorReader indices(model_, primitive_.indices);
        for (std::size_t i = 0; i < count; ++i) {
            order[i] = indices.index_at(i);
            if (order[i] >= vertex_count)
                model_.refuse(pointer_ + "/indices", fmt::format("element {} is the index {}", i, order[i]),
                              fmt::format("indices below the vertex count {}", vertex_count));
        }
        return order;
    }

    void append_triangle(const std::vector<std::uint32_t>& order, std::size_t i,
                         std::vector<std::uint32_t>& corners) const
    {
        if (primitive_.mode == TINYGLTF_MODE_TRIANGLES) {
            corners.insert(corners.end(), {order[3 * i], order[3 * i + 1], order[3 * i + 2]});
            return;
        }
        const bool is_fan = primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const std::size_t odd = i % 2;
        const std::uint32_t a = is_fan ? order[i + 1] : order[i];
        const std::uint32_t b = is_fan ? order[i + 2] : order[i + 1 + odd];
        const std::uint32_t c = is_fan ? order[0] : order[i + 2 - odd];
        // Strips are sewn together by triangles that were never meant to be seen.
        if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
    }

    const GltfModel& model_;
    const tinygltf::Primitive& primitive_;
    std::string pointer_;
};

/// The vertices that corners use, rising; corners become indices into them.
std::vector<std::uint32_t> drop_unused_vertices(std::vector<std::uint32_t>& corners)
{
    std::vector<std::uint32_t> used = corners;
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    if (used.back() + 1 == used.size()) return used;  // all are used: corners need no change
    for (std::uint32_t& corner : corners)
        corner = static_cast<std::uint32_t>(std::ranges::lower_bound(used, corner) - used.begin());
    return used;
}

template <typename Convert>
auto gather(const AccessorReader& reader, std::span<const std::uint32_t> elements, Convert convert)
{
    std::vector<decltype(convert(glm::vec4()))> values;
    values.reserve(elements.size());
    for (const std::uint32_t element : elements) values.push_back(convert(reader.at(element)));
    return values;
}

glm::vec2 finite_or_zero(const glm::vec4& uv)
{
    return std::isfinite(uv.x) && std::isfinite(uv.y) ? glm::vec2(uv) : glm::vec2(0.0f);
}

void read_positions(const GltfModel& model, const PrimitiveReader& source, std::span<const std::uint32_t> used,
                    MeshData& mesh)
{
    const AccessorReader reader(model, source.find("POSITION"));
    mesh.positions = gather(reader, used, [](const glm::vec4& v) { return glm::vec3(v); });
    for (std::size_t i = 0; i < used.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(mesh.positions[i][axis]) <= limits::kMaxCoordinate))
                model.refuse(source.pointer() + "/attributes/POSITION",
                             fmt::format("vertex {} has the coordinate {}", used[i], mesh.positions[i][axis]),
                             fmt::format("finite ones up to {:g}", limits::kMaxCoordinate));
}

void read_tangents(const GltfModel& model, int accessor, std::span<const std::uint32_t> used, MeshData& mesh)
{
    mesh.tangents = gather(AccessorReader(model, accessor), used, [](const glm::vec4& v) {
        return glm::vec4(unit_or_zero(glm::vec3(v)), v.w < 0.0f ? -1.0f : 1.0f);
    });
    const auto is_zero = [](const glm::vec4& v) { return glm::vec3(v) == glm::vec3(0.0f); };
    if (std::ranges::any_of(mesh.tangents, is_zero)) mesh.tangents.clear();  // better made than broken
}

void read_colours(const GltfModel& model, int accessor, std::span<const std::uint32_t> used, MeshData& mesh)
{
    const AccessorReader reader(model, accessor);
    const bool has_alpha = reader.components() == 4;
    mesh.colours = gather(reader, used, [&](glm::vec4 v) {
        if (!has_alpha) v.a = 1.0f;
        for (int i = 0; i < 4; ++i) v[i] = v[i] > 0.0f ? std::min(v[i], 1.0f) : 0.0f;  // NaN becomes 0
        return v;
    });
}

void read_streams(const GltfModel& model, const PrimitiveReader& source, std::span<const std::uint32_t> used,
                  MeshData& mesh)
{
    read_positions(model, source, used, mesh);
    if (const int accessor = source.find("NORMAL"); accessor != kNone) {
        mesh.has_own_normals = true;
        mesh.normals = gather(AccessorReader(model, accessor), used,
                              [](const glm::vec4& v) { return unit_or_zero(glm::vec3(v)); });
        if (const int tangents = source.find("TANGENT"); tangents != kNone) read_tangents(model, tangents, used, mesh);
    }
    if (const int accessor = source.find("TEXCOORD_0"); accessor != kNone)
        mesh.uv0 = gather(AccessorReader(model, accessor), used, finite_or_zero);
    if (const int accessor = source.find("TEXCOORD_1"); accessor != kNone)
        mesh.uv1 = gather(AccessorReader(model, accessor), used, finite_or_zero);
    if (const int accessor = source.find("COLOR_0"); accessor != kNone) read_colours(model, accessor, used, mesh);
}

template <typename T>
void unshare(std::vector<T>& stream, const std::vector<std::uint32_t>& corners)
{
    if (stream.empty()) return;
    std::vector<T> own;
    own.reserve(corners.size());
    for (const std::uint32_t corner : corners) own.push_back(stream[corner]);
    stream = std::move(own);
}

/// Gives each triangle its own vertices and its face's normal; zero for a triangle without area.
void add_flat_normals(MeshData& mesh)
{
    for_each_stream(mesh, [&](auto& stream) { unshare(stream, mesh.indices); });
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = static_cast<std::uint32_t>(i);
    mesh.normals.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
        // In double: edges of 1e-20 m have no cross product in float.
        const glm::dvec3 a(mesh.positions[i]);
        const glm::dvec3 cross =
            glm::cross(glm::dvec3(mesh.positions[i + 1]) - a, glm::dvec3(mesh.positions[i + 2]) - a);
        const double length = glm::length(cross);
        const glm::vec3 normal = length > 0.0 ? glm::vec3(cross / length) : glm::vec3(0.0f);
        std::fill_n(mesh.normals.begin() + static_cast<std::ptrdiff_t>(i), 3, normal);
    }
}

}  // namespace

std::string PrimitiveId::pointer() const
{
    return pointer_to(pointer_to("/meshes", mesh) + "/primitives", primitive);
}

namespace {

/// Primitives that share accessors, and accessors of zeroes, unpack a few bytes to any number of vertices: what a small
/// file may unpack to is bounded, too. A strip of bytes has three vertices for each.
void count_unpacked(const GltfModel& model, std::uint64_t vertices, const std::string& pointer, ImportTotals& totals)
{
    constexpr double kFree = 8e6, kMostOfByte = 4.0;
    std::uint64_t bytes = 0;
    for (const tinygltf::Buffer& buffer : model.data.buffers) bytes += buffer.data.size();
    const double most = Budget::factor() * (kFree + kMostOfByte * static_cast<double>(bytes));
    totals.unpacked_vertices += vertices;
    if (static_cast<double>(totals.unpacked_vertices) > most)
        model.refuse(pointer, fmt::format("{} bytes unpack to {} vertices and more", bytes, totals.unpacked_vertices),
                     fmt::format("at most {:.0f} of so few; --budget-factor 2 doubles it", most));
}

}  // namespace

std::optional<MeshData> convert_primitive(const GltfModel& model, const PrimitiveId& id, ImportTotals& totals)
{
    const PrimitiveReader source(model, id);
    if (!source.is_surface()) ++totals.skipped_primitives;
    if (!source.is_surface() || source.find("POSITION") == kNone) return {};
    if (source.has_targets()) ++totals.bent_primitives;

    MeshData mesh;
    mesh.indices = source.corners(totals.budget);
    if (mesh.indices.empty()) return {};
    const std::vector<std::uint32_t> used = drop_unused_vertices(mesh.indices);
    const bool is_unshared = source.find("NORMAL") == kNone;
    totals.budget.spend(Cost::triangles, mesh.triangle_count(), model.file, source.pointer());
    const std::uint64_t vertices = is_unshared ? mesh.indices.size() : used.size();
    totals.budget.spend(Cost::vertices, vertices, model.file, source.pointer());
    count_unpacked(model, vertices, source.pointer(), totals);
    read_streams(model, source, used, mesh);
    if (is_unshared) add_flat_normals(mesh);
    return mesh;
}

}  // namespace hw
