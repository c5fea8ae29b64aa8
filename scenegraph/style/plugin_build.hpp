#pragma once

#include <cstddef>
#include <glm/detail/setup.hpp>

#include "hatchway/header_hash.hpp"

#define HW_TEXT_OF_(x) #x
#define HW_TEXT_OF(x) HW_TEXT_OF_(x)

#ifdef NDEBUG
#define HW_ASSERTIONS "release"
#else
#define HW_ASSERTIONS "debug"
#endif

/// Describes everything that decides the layout of what crosses the plugin boundary: the compiler, and the text of
/// every header that a style sees.
#define HW_PLUGIN_BUILD                                                                                      \
    "abi " HW_TEXT_OF(__GXX_ABI_VERSION) ", stdlib " HW_TEXT_OF(_GLIBCXX_USE_CXX11_ABI) ", glm " HW_TEXT_OF( \
        GLM_VERSION) ", c++ " HW_TEXT_OF(__cplusplus) ", " HW_ASSERTIONS ", headers " HW_HEADER_HASH

#define HW_PLUGIN_EXPORT __attribute__((visibility("default")))

#ifndef HW_PLUGIN_SYMBOL
#define HW_PLUGIN_SYMBOL hw_plugin
#endif
