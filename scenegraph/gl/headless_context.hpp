#pragma once

#include <memory>

#include "hatchway/gl/context.hpp"

namespace hw {

struct HeadlessOptions {
    bool is_es =
        false;  ///< OpenGL ES 3.0 instead of desktop OpenGL 3.3 core; without it, ES where that is all there is.
    bool is_debug = true;  ///< Ask the driver for debug messages, where it has them.
};

/// A context without a window or a display (EGL surfaceless). Throws hw::Error, Fault::device, when there is none.
std::unique_ptr<Context> make_headless_context(const HeadlessOptions& options = {});

}  // namespace hw
