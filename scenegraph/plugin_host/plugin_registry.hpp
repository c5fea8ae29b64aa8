#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hatchway/plugin_host/trial/library_trial.hpp"
#include "hatchway/style/plugin.hpp"

namespace hw {

/// A plugin that can be used: its library is loaded and was built for this host.
struct Plugin {
    std::string name;  ///< [a-z0-9_]+
    PluginKind kind = PluginKind::style;
    std::string summary;
    std::filesystem::path library;        ///< Empty for one that is compiled in.
    std::filesystem::path shader_folder;  ///< Where its prepare() finds its shaders.
    const PluginEntry* entry = nullptr;   ///< Valid to the end of the process: libraries are never unloaded.
};

/// A library that was found and cannot be used.
struct RefusedPlugin {
    std::string name;  ///< Of the library's file.
    std::filesystem::path library;
    std::string why;
};

/// Where plugins come from. Never from a folder that a level names: plugins are native code, levels come from
/// strangers.
struct PluginPlaces {
    bool has_installed = true;                    ///< PREFIX/lib/hatchway/plugins of the running program.
    std::vector<std::filesystem::path> folders;   ///< Of --plugin-dir: NAME.so with its shaders in NAME/.
    std::span<const PluginFunction> compiled_in;  ///< static_plugins(), or none.
    Trial trial = Trial::if_new;        ///< Of libraries in `folders`; those of the installation are not tried.
    std::filesystem::path under_trial;  ///< One more library, not tried: for the process that does so.
};

/// The plugins of this process. A later place wins over an earlier one: compiled in, installed, then `folders` in
/// order.
class PluginRegistry {
 public:
    /// Loads every library of the places. One that cannot be used is put aside with the reason, and logged as a
    /// warning. Throws hw::Error when a folder of `folders` does not exist.
    explicit PluginRegistry(const PluginPlaces& places = {});

    /// Sorted by name.
    const std::vector<Plugin>& plugins() const { return plugins_; }
    const std::vector<RefusedPlugin>& refused() const { return refused_; }

    /// Null when there is none. Never a refused one.
    const Plugin* find(std::string_view name, PluginKind kind) const;
    /// The plugins of one kind, sorted.
    std::vector<std::string> names(PluginKind kind) const;

 private:
    void add(Plugin plugin);
    void load_folder(const std::filesystem::path& libraries, const std::filesystem::path& shaders, Trial trial);
    void load(const std::filesystem::path& library, const std::filesystem::path& shaders, Trial trial);

    std::vector<Plugin> plugins_;
    std::vector<RefusedPlugin> refused_;
};

/// Why this host cannot use the entry of a plugin, in one sentence; empty when it can. Reads `api_version` first and
/// nothing else when that differs: another version may lay out the rest in another way.
std::string plugin_refusal(const PluginEntry* entry, std::string_view file_name);

/// Whether `name` consists of one or more of a-z, 0-9 and '_'.
bool is_plugin_name(std::string_view name);

}  // namespace hw
