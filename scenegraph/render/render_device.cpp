#include "hatchway/render/render_device.hpp"

#include "hatchway/core/files/files.hpp"
#include "hatchway/core/log.hpp"

namespace hw {

RenderDevice::RenderDevice(Context& own_context, ImageReader read_image)
    : context(own_context),
      programs(installation_prefix() / "share/hatchway/shaders", installation_prefix() / "share/hatchway/kit",
               own_context.device().is_es, std::move(read_image)),
      lines(own_context.device(), programs, state, line_indices),
      overlay(programs, state),
      no_vertices({}, nullptr)
{
}

void RenderDevice::tell_once(const std::string& text)
{
    if (told.insert(text).second && !is_rehearsal) log_error(text);
}

void RenderDevice::warn_once(const std::string& text)
{
    if (told.insert(text).second && !is_rehearsal) log_warning(text);
}

void draw_full_screen(RenderDevice& device, const GpuProgram& program, const Uniforms& uniforms, Blending blending)
{
    device.state.use(program);
    set_uniforms(program, uniforms, device.state);
    device.state.apply(
        {.depth_test = DepthTest::off, .writes_depth = false, .blending = blending, .culling = Culling::off});
    device.state.bind(device.no_vertices);
    device.state.draw(Primitive::triangles, 0, 3);
}

}  // namespace hw
