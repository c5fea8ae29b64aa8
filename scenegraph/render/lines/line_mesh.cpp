#include "hatchway/render/lines/line_mesh.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr std::uint32_t kFirstCapacity = 4096;

}  // namespace

LineIndices::LineIndices()
{
    reserve(kFirstCapacity);
}

void LineIndices::reserve(std::uint32_t line_count)
{
    if (line_count <= capacity_) return;
    capacity_ = std::max(line_count, capacity_ * 2);
    std::vector<std::uint32_t> quads;
    std::vector<std::uint32_t> ends;
    quads.reserve(std::size_t(capacity_) * 6);
    ends.reserve(std::size_t(capacity_) * 2);
    for (std::uint32_t line = 0; line < capacity_; ++line) {
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) quads.push_back(line * 4 + corner);
        for (const std::uint32_t corner : {0u, 2u}) ends.push_back(line * 4 + corner);
    }
    quads_.stream(std::as_bytes(std::span(quads)));
    ends_.stream(std::as_bytes(std::span(ends)));
}

LineBuffer make_line_buffer(const LineIndices& indices)
{
    LineBuffer buffer;
    buffer.vertices.stream({});
    const auto stream = [&](VertexInput input, int components, std::size_t offset) {
        return VertexStream{.input = input,
                            .buffer = &buffer.vertices,
                            .components = components,
                            .stride_bytes = sizeof(LineVertex),
                            .offset_bytes = offset};
    };
    const std::array streams = {stream(VertexInput::position, 3, offsetof(LineVertex, position)),
                                stream(VertexInput::line_other, 4, offsetof(LineVertex, other)),
                                stream(VertexInput::line_normal_a, 3, offsetof(LineVertex, normal_a)),
                                stream(VertexInput::line_normal_b, 3, offsetof(LineVertex, normal_b)),
                                stream(VertexInput::line_stroke, 4, offsetof(LineVertex, stroke)),
                                stream(VertexInput::line_fold, 1, offsetof(LineVertex, fold_rad)),
                                stream(VertexInput::line_crowding, 4, offsetof(LineVertex, crowding))};
    buffer.as_quads = GpuVertexArray(streams, &indices.quads());
    buffer.as_ends = GpuVertexArray(streams, &indices.ends());
    return buffer;
}

void append_line(std::vector<LineVertex>& vertices, const ObjectLine& line)
{
    const LineStroke& stroke = line.stroke;
    LineVertex corner{
        .position = line.ends[0],
        .other = line.ends[1],
        .line_class = static_cast<float>(static_cast<int>(line.line_class) + (line.sides.are_culled ? 8 : 0)),
        .normal_a = line.sides.normal_a,
        .normal_b = line.sides.normal_b,
        .stroke = {stroke.from, stroke.to, stroke.length, stroke.seed},
        .fold_rad = line.fold_rad,
        .crowding = line.crowding[0]};
    vertices.insert(vertices.end(), {corner, corner});
    std::swap(corner.position, corner.other);
    std::swap(corner.stroke.x, corner.stroke.y);
    corner.crowding = line.crowding[1];
    vertices.insert(vertices.end(), {corner, corner});
}

LineMeshData line_mesh_data(const ObjectEdges& edges)
{
    ObjectLines lines = object_lines(edges);
    const bool has_silhouettes = classes_at(edges.surface, edges.crease_rad).candidate_count() > 0;
    std::vector<glm::vec3> places = crowding_places(lines);
    if (has_silhouettes) places.insert(places.end(), edges.surface.positions.begin(), edges.surface.positions.end());
    const LineCrowding crowding = crowding_of(edges, places);
    set_crowding(lines, crowding);
    LineMeshData mesh;
    mesh.vertices.reserve(4 * lines.lines.size());
    for (const ObjectLine& line : lines.lines) {
        const auto number = static_cast<std::uint32_t>(mesh.vertices.size() / 4);
        append_line(mesh.vertices, line);
        mesh.length += glm::distance(line.ends[0], line.ends[1]);
        if (mesh.runs.empty() || mesh.runs.back().line_class != line.line_class)
            mesh.runs.push_back({line.line_class, number, 0});
        ++mesh.runs.back().count;
    }
    mesh.crowding_window = crowding.window();
    if (has_silhouettes) mesh.crowding = crowding.at(edges.surface.positions);
    return mesh;
}

LineMesh upload(LineMeshData data, LineIndices& indices)
{
    indices.reserve(static_cast<std::uint32_t>(data.vertices.size() / 4));
    LineMesh mesh{.buffer = make_line_buffer(indices),
                  .runs = std::move(data.runs),
                  .crowding_window = data.crowding_window,
                  .crowding = std::move(data.crowding),
                  .length = data.length};
    mesh.buffer.vertices.stream(std::as_bytes(std::span(data.vertices)));
    return mesh;
}

}  // namespace hw
