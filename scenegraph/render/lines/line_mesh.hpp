#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/line_crowding.hpp"
#include "hatchway/geometry/lines/seams.hpp"
#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/gl/gpu_buffer.hpp"
#include "hatchway/render/lines/line_strokes.hpp"
#include "hatchway/style/line_look.hpp"

namespace hw {

/// One corner of a line's quad: four make a line, its two ends twice (shaders/line_quad.vert).
struct LineVertex {
    glm::vec3 position;
    glm::vec3 other;   ///< The other end.
    float line_class;  ///< LineClass
    /// Unit normals of the faces beside the line, equal at a border: a line whose faces are all culled is not drawn.
    /// Zero: drawn whatever the faces do.
    glm::vec3 normal_a;
    glm::vec3 normal_b;
    glm::vec4 stroke;  ///< Length along the stroke at this end and at the other, LineStroke's length and seed.
    float fold_rad;
    glm::vec4 crowding;  ///< LineCrowding at this end.
};

/// The normals beside a line; zero by default.
struct LineSides {
    glm::vec3 normal_a{0.0f};
    glm::vec3 normal_b{0.0f};
};

/// Index buffers that all lines share: quads, and the same vertices as GL_LINES and GL_POINTS. They grow on demand,
/// their ids stay.
class LineIndices {
 public:
    LineIndices();
    void reserve(std::uint32_t line_count);
    const GpuBuffer& quads() const { return quads_; }
    const GpuBuffer& ends() const { return ends_; }

 private:
    GpuBuffer quads_;
    GpuBuffer ends_;
    std::uint32_t capacity_ = 0;
};

/// Lines on the device, in runs of one class.
struct LineBuffer {
    GpuBuffer vertices;
    GpuVertexArray as_quads;
    GpuVertexArray as_ends;
};

LineBuffer make_line_buffer(const LineIndices& indices);

/// A line with nothing but its place and class.
void append_line(std::vector<LineVertex>& vertices, const std::array<glm::vec3, 2>& ends, LineClass line_class,
                 const LineSides& sides = {}, float fold_rad = 0.0f);

/// Writes the crowding at both ends of the last line.
void set_crowding(std::vector<LineVertex>& vertices, const glm::vec4& at_a, const glm::vec4& at_b);

/// The lines of one surface that are drawn from every viewpoint. Ridges and valleys stand by falling fold, so that a
/// larger crease angle draws the beginning of their runs.
struct LineMesh {
    struct Run {
        LineClass line_class;
        std::uint32_t first_line;
        std::uint32_t count;
        EdgeGroup group;
        std::vector<std::uint32_t> edge_ids;  ///< Rising; of runs that the crease angle cuts alone.
    };
    LineBuffer buffer;
    std::vector<Run> runs;
    float crease_rad = 0.0f;          ///< The smallest angle that it serves.
    float crowding_window = 1.0f;     ///< LineCrowding::window()
    std::vector<glm::vec4> crowding;  ///< LineCrowding at each position of the surface, when silhouettes may need it.
};

/// What an object's neighbours change of its lines.
struct LineExtras {
    const Seams* seams = nullptr;  ///< Its hidden edges are left out and its kept pieces become borders; or null.
    std::span<const std::array<glm::vec3, 2>> intersections;  ///< Object space.

    bool is_empty() const
    {
        return intersections.empty() && (seams == nullptr || (seams->hidden.empty() && seams->partly_hidden.empty()));
    }
};

/// `is_culled`: faces that look away are not drawn.
LineMesh build_line_mesh(const Surface& surface, float crease_rad, const LineExtras& extras, bool is_culled,
                         LineIndices& indices);

/// How many lines of a run a crease angle draws.
std::uint32_t run_length_at(const LineMesh::Run& run, const Surface& surface, float crease_rad);

}  // namespace hw
