#pragma once

#include <filesystem>

#include "hatchway/render/device/texture_store.hpp"

namespace hw {

/// What the process of a trial does (trial/trial_process.hpp): loads the library, makes its style or image pass with
/// the parameters' defaults, prepares it, and draws a small frame of two objects, one of them blended. Without a device
/// it is prepared with a cache that compiles nothing, and not drawn. What throws is no failure here: the host guards
/// against that wherever the plugin is used.
void try_library(const std::filesystem::path& library, const ImageReader& read_image);

}  // namespace hw
