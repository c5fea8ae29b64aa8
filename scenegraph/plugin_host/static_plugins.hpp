#pragma once

#include <span>

#include "hatchway/style/plugin.hpp"

namespace hw {

/// The project's own plugins, compiled into the program instead of loaded: for tests and single-file builds. Only in
/// programs that link the CMake target hatchway_static_plugins.
std::span<const PluginFunction> static_plugins();

}  // namespace hw
