#include "hatchway/render/render_device.hpp"

#include "hatchway/core/files/files.hpp"

namespace hw {

RenderDevice::RenderDevice(Context& own_context)
    : context(own_context),
      programs(installation_prefix() / "share/hatchway/shaders", installation_prefix() / "share/hatchway/kit",
               own_context.device().is_es),
      lines(own_context.device(), programs, state, line_indices),
      overlay(programs, state),
      no_vertices({}, nullptr)
{
}

}  // namespace hw
