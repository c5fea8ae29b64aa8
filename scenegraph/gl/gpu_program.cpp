#include "hatchway/gl/gpu_program.hpp"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/gl/gl_api.hpp"
#include "hatchway/gl/gpu_buffer.hpp"

namespace hw {
namespace {

constexpr std::array<const char*, kVertexInputCount> kInputNames = {
    "hw_in_position",      "hw_in_normal",        "hw_in_tangent",     "hw_in_uv0",       "hw_in_uv1",
    "hw_in_colour",        "hw_in_lightmap_uv",   "hw_in_hatch",       "hw_in_direction", "hw_in_line_other",
    "hw_in_line_normal_a", "hw_in_line_normal_b", "hw_in_line_stroke", "hw_in_line_fold", "hw_in_line_crowding"};

class Shader {
 public:
    Shader(GLenum stage, const ShaderText& shader, bool is_es) : id_(glCreateShader(stage))
    {
        const std::string text = shader_header(is_es) + shader.text;
        const char* pointer = text.c_str();
        glShaderSource(id_, 1, &pointer, nullptr);
        glCompileShader(id_);
        GLint is_good = 0;
        glGetShaderiv(id_, GL_COMPILE_STATUS, &is_good);
        if (is_good) return;
        std::array<char, 4096> log{};
        glGetShaderInfoLog(id_, log.size(), nullptr, log.data());
        glDeleteShader(id_);
        throw Error({.what = located_message(log.data(), shader)});
    }
    ~Shader() { glDeleteShader(id_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint id() const { return id_; }

 private:
    GLuint id_;
};

bool is_sampler(GLenum type)
{
    return type == GL_SAMPLER_2D || type == GL_SAMPLER_2D_SHADOW || type == GL_UNSIGNED_INT_SAMPLER_2D;
}

}  // namespace

GpuProgram::GpuProgram(const ShaderText& vertex, const ShaderText& fragment, bool is_es)
{
    link(vertex, fragment, is_es);
    list_uniforms();
}

void GpuProgram::link(const ShaderText& vertex, const ShaderText& fragment, bool is_es)
{
    const Shader vertex_shader(GL_VERTEX_SHADER, vertex, is_es);
    const Shader fragment_shader(GL_FRAGMENT_SHADER, fragment, is_es);
    id_ = glCreateProgram();
    glAttachShader(id_, vertex_shader.id());
    glAttachShader(id_, fragment_shader.id());
    for (int i = 0; i < kVertexInputCount; ++i) glBindAttribLocation(id_, static_cast<GLuint>(i), kInputNames[i]);
    glLinkProgram(id_);
    GLint is_good = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &is_good);
    if (is_good) return;
    std::array<char, 4096> log{};
    glGetProgramInfoLog(id_, log.size(), nullptr, log.data());
    glDeleteProgram(std::exchange(id_, 0));
    throw Error({.what = located_message(log.data(), fragment)});
}

void GpuProgram::list_uniforms()
{
    const GLuint block = glGetUniformBlockIndex(id_, "HwFrame");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(id_, block, kFrameBlockIndex);
    GLint previous = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &previous);
    glUseProgram(id_);
    GLint count = 0;
    glGetProgramiv(id_, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(id_, static_cast<GLuint>(i), name.size(), nullptr, &size, &type, name.data());
        const GLint place = glGetUniformLocation(id_, name.data());
        if (place < 0) continue;  // a member of the uniform block
        locations_[name.data()] = place;
        if (!is_sampler(type)) continue;
        const int unit = static_cast<int>(units_.size());
        units_[name.data()] = unit;
        glUniform1i(place, unit);
    }
    glUseProgram(static_cast<GLuint>(previous));
}

GpuProgram::~GpuProgram()
{
    if (id_ != 0) glDeleteProgram(id_);
}

GpuProgram::GpuProgram(GpuProgram&& other) noexcept
{
    *this = std::move(other);
}

GpuProgram& GpuProgram::operator=(GpuProgram&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(locations_, other.locations_);
    std::swap(units_, other.units_);
    return *this;
}

int GpuProgram::location(std::string_view name) const
{
    const auto found = locations_.find(std::string(name));
    return found == locations_.end() ? -1 : found->second;
}

int GpuProgram::unit(std::string_view sampler) const
{
    const auto found = units_.find(std::string(sampler));
    return found == units_.end() ? -1 : found->second;
}

// A uniform that the program does not use has no location; GL takes -1, but
// only while a program is in use.
void GpuProgram::set(int location, float value)
{
    if (location >= 0) glUniform1f(location, value);
}
void GpuProgram::set(int location, int value)
{
    if (location >= 0) glUniform1i(location, value);
}
void GpuProgram::set(int location, const glm::vec2& value)
{
    if (location >= 0) glUniform2fv(location, 1, &value[0]);
}
void GpuProgram::set(int location, const glm::vec3& value)
{
    if (location >= 0) glUniform3fv(location, 1, &value[0]);
}
void GpuProgram::set(int location, const glm::vec4& value)
{
    if (location >= 0) glUniform4fv(location, 1, &value[0]);
}
void GpuProgram::set(int location, const glm::mat3& value)
{
    if (location >= 0) glUniformMatrix3fv(location, 1, GL_FALSE, glm::value_ptr(value));
}
void GpuProgram::set(int location, const glm::mat4& value)
{
    if (location >= 0) glUniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(value));
}
void GpuProgram::set(int location, std::span<const float> values)
{
    if (location >= 0) glUniform1fv(location, static_cast<GLsizei>(values.size()), values.data());
}
void GpuProgram::set(int location, std::span<const glm::vec3> values)
{
    if (location >= 0) glUniform3fv(location, static_cast<GLsizei>(values.size()), &values[0].x);
}

}  // namespace hw
