#include "hatchway/gl/gpu_buffer.hpp"

#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/gl_api.hpp"

namespace hw {
namespace {

// Every upload uses this binding point: the others belong to the vertex array that happens to be bound.
constexpr GLenum kUploadPoint = GL_COPY_WRITE_BUFFER;

}  // namespace

GpuBuffer::GpuBuffer(std::span<const std::byte> bytes) : size_bytes_(bytes.size())
{
    while (glGetError() == GL_OUT_OF_MEMORY) {
    }
    glGenBuffers(1, &id_);
    glBindBuffer(kUploadPoint, id_);
    glBufferData(kUploadPoint, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        glDeleteBuffers(1, &id_);
        throw Error({.what = "no device memory for " + std::to_string(bytes.size()) + " bytes of a mesh",
                     .fault = Fault::device});
    }
}

GpuBuffer::~GpuBuffer()
{
    if (id_ != 0) glDeleteBuffers(1, &id_);
}

GpuBuffer::GpuBuffer(GpuBuffer&& other) noexcept
    : id_(std::exchange(other.id_, 0)), size_bytes_(std::exchange(other.size_bytes_, 0))
{
}

GpuBuffer& GpuBuffer::operator=(GpuBuffer&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(size_bytes_, other.size_bytes_);
    return *this;
}

void GpuBuffer::stream(std::span<const std::byte> bytes)
{
    if (id_ == 0) glGenBuffers(1, &id_);
    glBindBuffer(kUploadPoint, id_);
    glBufferData(kUploadPoint, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
    size_bytes_ = bytes.size();
}

void GpuBuffer::bind_uniform_block(int index) const
{
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(index), id_);
}

GpuVertexArray::GpuVertexArray(std::span<const VertexStream> streams, const GpuBuffer* indices)
{
    glGenVertexArrays(1, &id_);
    glBindVertexArray(id_);
    for (const VertexStream& stream : streams) {
        const auto input = static_cast<GLuint>(stream.input);
        glBindBuffer(GL_ARRAY_BUFFER, stream.buffer->id());
        glEnableVertexAttribArray(input);
        glVertexAttribPointer(input, stream.components, GL_FLOAT, GL_FALSE, stream.stride_bytes,
                              reinterpret_cast<const void*>(stream.offset_bytes));
    }
    if (indices != nullptr) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices->id());
    glBindVertexArray(0);
}

GpuVertexArray::~GpuVertexArray()
{
    if (id_ != 0) glDeleteVertexArrays(1, &id_);
}

GpuVertexArray::GpuVertexArray(GpuVertexArray&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

GpuVertexArray& GpuVertexArray::operator=(GpuVertexArray&& other) noexcept
{
    std::swap(id_, other.id_);
    return *this;
}

}  // namespace hw
