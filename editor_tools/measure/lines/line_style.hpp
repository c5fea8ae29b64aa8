#pragma once

#include <memory>
#include <string>

#include "hatchway/plugin_host/plugin_registry.hpp"
#include "hatchway/style/style.hpp"

namespace hw {

/// The crease angle of the style pen_and_ink, which lines are measured with.
inline constexpr double kMeasuredCreaseDeg = 40.0;

/// Pen and ink without hatching, in black on white, with the widths that the style has by itself. Not prepared.
std::unique_ptr<Style> line_style(const PluginRegistry& plugins, const std::string& asked_by);

}  // namespace hw
