#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "hatchway/drawing/object_lines.hpp"
#include "hatchway/gl/gpu_buffer.hpp"

namespace hw {

/// One corner of a line's quad: four make a line, its two ends twice (shaders/line_quad.vert).
struct LineVertex {
    glm::vec3 position;
    glm::vec3 other;     ///< The other end.
    float line_class;    ///< LineClass, 8 more where LineSides::are_culled
    glm::vec3 normal_a;  ///< LineSides
    glm::vec3 normal_b;
    glm::vec4 stroke;  ///< Length along the stroke at this end and at the other, LineStroke's length and seed.
    float fold_rad;
    glm::vec4 crowding;  ///< LineCrowding at this end.
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

void append_line(std::vector<LineVertex>& vertices, const ObjectLine& line);

/// An object's lines that are drawn from every viewpoint, at one crease angle.
struct LineMesh {
    struct Run {
        LineClass line_class = LineClass::border;
        std::uint32_t first_line = 0;
        std::uint32_t count = 0;
    };
    LineBuffer buffer;
    std::vector<Run> runs;            ///< Class after class.
    float crowding_window = 1.0f;     ///< LineCrowding::window()
    std::vector<glm::vec4> crowding;  ///< LineCrowding at each position of the surface, when silhouettes may need it.
    double length = 0.0;              ///< Of all lines, object space.
};

/// A LineMesh that is not on the device yet.
struct LineMeshData {
    std::vector<LineVertex> vertices;
    std::vector<LineMesh::Run> runs;
    float crowding_window = 1.0f;
    std::vector<glm::vec4> crowding;
    double length = 0.0;
};

/// Touches no device: for any thread.
LineMeshData line_mesh_data(const ObjectEdges& edges);

LineMesh upload(LineMeshData data, LineIndices& indices);

}  // namespace hw
