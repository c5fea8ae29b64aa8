#include "hatchway/gl/gpu_state.hpp"

#include "hatchway/core/error.hpp"
#include "hatchway/gl/gl_api.hpp"

namespace hw {
namespace {

constexpr std::uint32_t kUnknownTexture = ~0u;

void enable(GLenum what, bool is_on)
{
    is_on ? glEnable(what) : glDisable(what);
}

GLenum depth_constant(DepthTest test)
{
    if (test == DepthTest::less) return GL_LESS;
    return test == DepthTest::equal ? GL_EQUAL : GL_LEQUAL;
}

GLenum primitive_constant(Primitive primitive)
{
    if (primitive == Primitive::triangles) return GL_TRIANGLES;
    return primitive == Primitive::lines ? GL_LINES : GL_POINTS;
}

void set_depth(const PipelineState& state)
{
    enable(GL_DEPTH_TEST, state.depth_test != DepthTest::off);
    glDepthFunc(depth_constant(state.depth_test));
    glDepthMask(state.writes_depth ? GL_TRUE : GL_FALSE);
}

void set_offset(const PipelineState& state)
{
    enable(GL_POLYGON_OFFSET_FILL, state.offset_factor != 0.0f || state.offset_units != 0.0f);
    glPolygonOffset(state.offset_factor, state.offset_units);
}

void set_blending(const PipelineState& state)
{
    enable(GL_BLEND, state.blending != Blending::off);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void set_stencil(const PipelineState& state)
{
    enable(GL_STENCIL_TEST, state.takes_once);
    glStencilFunc(GL_EQUAL, 0, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
}

}  // namespace

void GpuState::forget()
{
    is_known_ = false;
    program_ = 0;
    vertex_array_ = 0;
    textures_.fill(kUnknownTexture);  // what is bound stays so: none is bound anew, too
    glUseProgram(0);
    glBindVertexArray(0);
    if (epoxy_is_desktop_gl()) glEnable(GL_PROGRAM_POINT_SIZE);
    set_srgb_targets(true);
    set_scissor({});
    glDisable(GL_DITHER);
}

void GpuState::set_srgb_targets(bool is_on)
{
    // Targets in sRGB are drawn and blended in linear light; ES always does so.
    if (epoxy_is_desktop_gl()) enable(GL_FRAMEBUFFER_SRGB, is_on);
}

void GpuState::set_scissor(const std::optional<PixelRect>& rect)
{
    enable(GL_SCISSOR_TEST, rect.has_value());
    if (rect) glScissor(rect->min.x, rect->min.y, rect->size.x, rect->size.y);
}

void GpuState::apply(const PipelineState& state)
{
    if (is_known_ && state == state_) return;
    const PipelineState& old = state_;
    const bool all = !is_known_;
    ++counters_.state_changes;
    if (all || state.depth_test != old.depth_test || state.writes_depth != old.writes_depth) set_depth(state);
    if (all || state.writes_colour != old.writes_colour) {
        const GLboolean mask = state.writes_colour ? GL_TRUE : GL_FALSE;
        glColorMask(mask, mask, mask, mask);
    }
    if (all || state.blending != old.blending) set_blending(state);
    if (all || state.culling != old.culling) enable(GL_CULL_FACE, state.culling != Culling::off);
    if (all || state.is_front_clockwise != old.is_front_clockwise)
        glFrontFace(state.is_front_clockwise ? GL_CW : GL_CCW);
    if (all || state.offset_factor != old.offset_factor || state.offset_units != old.offset_units) set_offset(state);
    if (all || state.takes_once != old.takes_once) set_stencil(state);
    if (all || state.line_width_px != old.line_width_px) glLineWidth(state.line_width_px);
    if ((all || state.is_multisampled != old.is_multisampled) && epoxy_is_desktop_gl())
        enable(GL_MULTISAMPLE, state.is_multisampled);
    state_ = state;
    is_known_ = true;
}

void GpuState::use(const GpuProgram& program)
{
    if (program.id() == program_) return;
    program_ = program.id();
    glUseProgram(program_);
    ++counters_.program_switches;
}

void GpuState::bind(const GpuVertexArray& array)
{
    if (array.id() == vertex_array_) return;
    vertex_array_ = array.id();
    glBindVertexArray(vertex_array_);
}

void GpuState::bind_texture(int unit, std::uint32_t texture)
{
    if (unit < 0) return;
    HW_ASSERT(unit < static_cast<int>(textures_.size()));
    if (textures_[unit] == texture) return;
    textures_[unit] = texture;
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    ++counters_.texture_binds;
}

void GpuState::count(Primitive primitive, std::uint32_t vertices)
{
    ++counters_.draw_calls;
    if (primitive == Primitive::triangles) counters_.triangles += vertices / 3;
    if (primitive == Primitive::lines) counters_.lines += vertices / 2;
}

void GpuState::draw(Primitive primitive, std::uint32_t first, std::uint32_t count_of_vertices)
{
    if (count_of_vertices == 0) return;
    count(primitive, count_of_vertices);
    glDrawArrays(primitive_constant(primitive), static_cast<GLint>(first), static_cast<GLsizei>(count_of_vertices));
}

void GpuState::draw_indexed(Primitive primitive, std::uint32_t first, std::uint32_t count_of_indices)
{
    if (count_of_indices == 0) return;
    count(primitive, count_of_indices);
    const std::size_t offset = static_cast<std::size_t>(first) * sizeof(std::uint32_t);
    glDrawElements(primitive_constant(primitive), static_cast<GLsizei>(count_of_indices), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
}

void finish_device()
{
    glFinish();
}

}  // namespace hw
