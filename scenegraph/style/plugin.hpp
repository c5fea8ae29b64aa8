#pragma once

#include <cstdint>

namespace hw {

class Style;
class ImagePass;

/// Rises with every change of the interface that makes the sources of older plugins wrong. HW_PLUGIN_BUILD tells what
/// only has to be built anew.
inline constexpr std::uint32_t kStyleApiVersion = 2;

enum class PluginKind : std::uint32_t { style, image_pass };

/// What a plugin library exports, by the C function `hw_plugin`. The host reads `api_version` first and nothing else
/// when it differs; then it refuses another compiler, GLM, build type or other headers, since those change the layout
/// of what is passed.
struct PluginEntry {
    std::uint32_t api_version;
    PluginKind kind;
    const char* name;     ///< [a-z0-9_]+, the name in level files.
    const char* summary;  ///< One sentence for lists and the manual.
    const char* build;    ///< HW_PLUGIN_BUILD: compiler, C++ ABI, GLM version, assertions, headers.
    Style* (*make_style)();
    ImagePass* (*make_image_pass)();
};

using PluginFunction = const PluginEntry* (*)();

}  // namespace hw

#include "hatchway/style/plugin_build.hpp"

/// Defines a plugin: HW_STYLE(pen_and_ink, "Paper, ink lines and hatching", PenAndInk). Once in a library, outside of
/// any namespace. add_npr_plugin() gives HW_PLUGIN_SYMBOL.
#define HW_STYLE(plugin_name, plugin_summary, Type)                                     \
    extern "C" HW_PLUGIN_EXPORT const ::hw::PluginEntry* HW_PLUGIN_SYMBOL()             \
    {                                                                                   \
        static const ::hw::PluginEntry entry{::hw::kStyleApiVersion,                    \
                                             ::hw::PluginKind::style,                   \
                                             #plugin_name,                              \
                                             plugin_summary,                            \
                                             HW_PLUGIN_BUILD,                           \
                                             []() -> ::hw::Style* { return new Type; }, \
                                             nullptr};                                  \
        return &entry;                                                                  \
    }

#define HW_IMAGE_PASS(plugin_name, plugin_summary, Type)                                     \
    extern "C" HW_PLUGIN_EXPORT const ::hw::PluginEntry* HW_PLUGIN_SYMBOL()                  \
    {                                                                                        \
        static const ::hw::PluginEntry entry{::hw::kStyleApiVersion,                         \
                                             ::hw::PluginKind::image_pass,                   \
                                             #plugin_name,                                   \
                                             plugin_summary,                                 \
                                             HW_PLUGIN_BUILD,                                \
                                             nullptr,                                        \
                                             []() -> ::hw::ImagePass* { return new Type; }}; \
        return &entry;                                                                       \
    }
