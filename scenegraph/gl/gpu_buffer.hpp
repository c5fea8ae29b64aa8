#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hw {

/// Memory of the device: vertices, indices or a uniform block. Move-only.
class GpuBuffer {
 public:
    GpuBuffer() = default;
    /// Copies `bytes`. Throws hw::Error when the device has no memory left.
    explicit GpuBuffer(std::span<const std::byte> bytes);
    template <typename Value>
    explicit GpuBuffer(const std::vector<Value>& values) : GpuBuffer(std::as_bytes(std::span(values)))
    {
    }
    ~GpuBuffer();
    GpuBuffer(GpuBuffer&& other) noexcept;
    GpuBuffer& operator=(GpuBuffer&& other) noexcept;

    /// Replaces the whole content; the device may still be drawing from the old one.
    void stream(std::span<const std::byte> bytes);
    /// Makes it the uniform block of binding point `index`.
    void bind_uniform_block(int index) const;

    std::uint32_t id() const { return id_; }
    std::size_t size_bytes() const { return size_bytes_; }

 private:
    std::uint32_t id_ = 0;
    std::size_t size_bytes_ = 0;
};

/// Where the vertex shader's inputs stand, in every program: those of faces (surface.vert), then those of lines
/// (lines/line.glsl), which have positions in common.
enum class VertexInput : std::uint8_t {
    position,
    normal,
    tangent,
    uv0,
    uv1,
    colour,
    lightmap_uv,
    hatch,
    direction,
    line_other,
    line_normal_a,
    line_normal_b,
    line_stroke,
    line_fold,
    line_crowding
};
inline constexpr int kVertexInputCount = 15;

/// One input's place in a buffer of floats.
struct VertexStream {
    VertexInput input = VertexInput::position;
    const GpuBuffer* buffer = nullptr;
    int components = 3;
    int stride_bytes = 0;
    std::size_t offset_bytes = 0;
};

/// Which buffers feed the vertex stage. Move-only; the buffers must outlive it.
class GpuVertexArray {
 public:
    GpuVertexArray() = default;
    GpuVertexArray(std::span<const VertexStream> streams, const GpuBuffer* indices);
    ~GpuVertexArray();
    GpuVertexArray(GpuVertexArray&& other) noexcept;
    GpuVertexArray& operator=(GpuVertexArray&& other) noexcept;

    std::uint32_t id() const { return id_; }

 private:
    std::uint32_t id_ = 0;
};

}  // namespace hw
