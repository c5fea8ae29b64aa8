#include "hatchway/render/lines/line_mesh.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr std::uint32_t kFirstCapacity = 4096;

bool is_among(std::span<const std::uint32_t> rising, std::uint32_t id)
{
    return std::binary_search(rising.begin(), rising.end(), id);
}

/// The artist's edges and borders are drawn at every crease angle.
bool is_cut_by_angle(EdgeGroup group)
{
    return group == EdgeGroup::convex || group == EdgeGroup::reflex || group == EdgeGroup::reflex_silent;
}

/// Writes into each line where it lies on its stroke.
void set_strokes(std::vector<LineVertex>& vertices)
{
    std::vector<StrokeSegment> segments;
    for (std::size_t i = 0; i < vertices.size(); i += 4)
        segments.push_back({{vertices[i].position, vertices[i].other}, static_cast<LineClass>(vertices[i].line_class)});
    const std::vector<LineStroke> strokes = find_strokes(segments);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const LineStroke& stroke = strokes[i / 4];
        const glm::vec2 arc = i % 4 < 2 ? glm::vec2(stroke.from, stroke.to) : glm::vec2(stroke.to, stroke.from);
        vertices[i].stroke = {arc, stroke.length, stroke.seed};
    }
}

/// Writes into each line how crowded it is at its ends, and into `lines` what silhouettes need.
void add_crowding(const Surface& surface, const LineExtras& extras, std::vector<LineVertex>& vertices, LineMesh& lines)
{
    const LineCrowding crowding(crowding_lines(surface, lines.crease_rad, extras.seams, extras.intersections));
    lines.crowding_window = crowding.window();
    std::vector<glm::vec3> places;  // of each line both ends and the middle
    for (std::size_t i = 0; i < vertices.size(); i += 4) {
        const glm::vec3 &a = vertices[i].position, &b = vertices[i].other;
        places.insert(places.end(), {a, b, 0.5f * (a + b)});
    }
    const std::vector<glm::vec4> crowds = crowding.at(places);
    for (std::size_t i = 0; i < vertices.size(); i += 4) {
        const glm::vec4* const crowd = &crowds[i / 4 * 3];
        const auto ends = crowding_of_line(crowd[0], crowd[1], crowd[2]);
        for (std::size_t k = 0; k < 4; ++k) vertices[i + k].crowding = ends[k / 2];
    }
    if (classes_at(surface, lines.crease_rad).candidate_count() > 0) lines.crowding = crowding.at(surface.positions);
}

/// Gathers runs of lines in the order in which they are drawn.
class RunBuilder {
 public:
    RunBuilder(const Surface& surface, const Seams* seams, bool is_culled)
        : surface_(surface), seams_(seams), has_sides_(is_culled && surface.report.flipped_faces == 0)
    {
    }

    void add(EdgeRange range, LineClass line_class, EdgeGroup group)
    {
        LineMesh::Run run{line_class, line_count(), 0, group, {}};
        for (std::uint32_t id = range.begin; id < range.end; ++id) {
            if (is_hidden(id)) continue;
            const auto ends = edge_vertices(surface_, id);
            add_line(surface_.positions[ends[0]], surface_.positions[ends[1]], line_class, sides_of(id),
                     is_crease(line_class) ? fold_rad(surface_, id) : 0.0f);
            if (is_cut_by_angle(group)) run.edge_ids.push_back(id);
        }
        finish(std::move(run));
    }
    void add_pieces(std::span<const std::array<glm::vec3, 2>> pieces, LineClass line_class)
    {
        LineMesh::Run run{line_class, line_count(), 0, EdgeGroup::border, {}};
        for (const auto& piece : pieces) add_line(piece[0], piece[1], line_class, {}, 0.0f);
        finish(std::move(run));
    }

    std::vector<LineVertex> vertices;
    std::vector<LineMesh::Run> runs;

    std::uint32_t line_count() const { return static_cast<std::uint32_t>(vertices.size() / 4); }

 private:
    bool is_hidden(std::uint32_t id) const
    {
        return seams_ != nullptr && (is_among(seams_->hidden, id) || is_among(seams_->partly_hidden, id));
    }
    glm::vec3 normal_of(std::uint32_t face) const
    {
        const auto& corners = surface_.faces[face];
        const glm::vec3& p = surface_.positions[corners[0]];
        const glm::vec3 area = glm::cross(surface_.positions[corners[1]] - p, surface_.positions[corners[2]] - p);
        const float size = glm::length(area);
        return size > 0.0f ? area / size : glm::vec3(0.0f);
    }
    /// None where a repair turned faces: the drawn ones wind as the model says. None for complex edges: they have more.
    LineSides sides_of(std::uint32_t id) const
    {
        const auto faces = surface_.edges[id].faces();
        const bool is_border = id < surface_.edges.two_faced().begin;
        if (!has_sides_ || faces[0] >= surface_.faces.size()) return {};
        const LineSides alone{normal_of(faces[0]), normal_of(faces[0])};
        if (faces[1] == kNoFace) return alone;
        if (is_border || faces[1] >= surface_.faces.size()) return {};
        const LineSides both{alone.normal_a, normal_of(faces[1])};
        const bool has_both = both.normal_a != glm::vec3(0.0f) && both.normal_b != glm::vec3(0.0f);
        return has_both ? both : LineSides{};
    }
    void add_line(const glm::vec3& a, const glm::vec3& b, LineClass line_class, const LineSides& sides, float fold)
    {
        append_line(vertices, {a, b}, line_class, sides, fold);
    }
    void finish(LineMesh::Run run)
    {
        run.count = line_count() - run.first_line;
        if (run.count > 0) runs.push_back(std::move(run));
    }

    const Surface& surface_;
    const Seams* seams_;
    bool has_sides_;
};

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

void append_line(std::vector<LineVertex>& vertices, const std::array<glm::vec3, 2>& ends, LineClass line_class,
                 const LineSides& sides, float fold_rad)
{
    const auto& [a, b] = ends;
    const LineVertex from{a, b, static_cast<float>(line_class), sides.normal_a, sides.normal_b, {}, fold_rad, {}};
    const LineVertex to{b, a, static_cast<float>(line_class), sides.normal_a, sides.normal_b, {}, fold_rad, {}};
    vertices.insert(vertices.end(), {from, from, to, to});
}

void set_crowding(std::vector<LineVertex>& vertices, const glm::vec4& at_a, const glm::vec4& at_b)
{
    LineVertex* const line = &vertices[vertices.size() - 4];
    line[0].crowding = line[1].crowding = at_a;
    line[2].crowding = line[3].crowding = at_b;
}

LineMesh build_line_mesh(const Surface& surface, float crease_rad, const LineExtras& extras, bool is_culled,
                         LineIndices& indices)
{
    const EdgeClasses classes = classes_at(surface, crease_rad);
    RunBuilder builder(surface, extras.seams, is_culled);
    builder.add(classes.borders, LineClass::border, EdgeGroup::border);
    if (extras.seams != nullptr) builder.add_pieces(extras.seams->kept, LineClass::border);
    builder.add_pieces(extras.intersections, LineClass::intersection);
    builder.add(classes.artist[0], LineClass::artist, EdgeGroup::artist_convex);
    builder.add(classes.artist[1], LineClass::artist, EdgeGroup::artist_reflex);
    builder.add(classes.ridges[0], LineClass::ridge, EdgeGroup::artist_convex);
    builder.add(classes.ridges[1], LineClass::ridge, EdgeGroup::convex);
    builder.add(classes.valleys[0], LineClass::valley, EdgeGroup::artist_reflex);
    builder.add(classes.valleys[1], LineClass::valley, EdgeGroup::reflex);
    builder.add(classes.valleys[2], LineClass::valley, EdgeGroup::reflex_silent);

    set_strokes(builder.vertices);
    LineMesh mesh;
    mesh.crease_rad = crease_rad;
    add_crowding(surface, extras, builder.vertices, mesh);
    indices.reserve(builder.line_count());
    mesh.buffer = make_line_buffer(indices);
    mesh.buffer.vertices.stream(std::as_bytes(std::span(builder.vertices)));
    mesh.runs = std::move(builder.runs);
    return mesh;
}

std::uint32_t run_length_at(const LineMesh::Run& run, const Surface& surface, float crease_rad)
{
    if (run.edge_ids.empty()) return run.count;
    const EdgeClasses classes = classes_at(surface, crease_rad);
    const EdgeRange drawn = run.group == EdgeGroup::convex   ? classes.ridges[1]
                            : run.group == EdgeGroup::reflex ? classes.valleys[1]
                                                             : classes.valleys[2];
    const auto end = std::lower_bound(run.edge_ids.begin(), run.edge_ids.end(), drawn.end);
    return static_cast<std::uint32_t>(end - run.edge_ids.begin());
}

}  // namespace hw
