#include "hatchway/plugin_host/plugin_registry.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/lower_snake.hpp"
#include "hatchway/plugin_host/library_file.hpp"
#include "hatchway/plugin_host/trial/crash_watch.hpp"

namespace hw {
namespace {

namespace fs = std::filesystem;

/// Libraries of the installation, relative to its prefix.
constexpr const char* kInstalledLibraries = HATCHWAY_PLUGIN_FOLDER;
constexpr const char* kInstalledShaders = "share/hatchway/plugins";
constexpr const char* kNotAName = "its name is not made of a-z, 0-9 and _";

std::vector<fs::path> libraries_in(const fs::path& folder)
{
    std::vector<fs::path> libraries;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
        if (entry.path().extension() == ".so") libraries.push_back(entry.path());
    std::sort(libraries.begin(), libraries.end());
    return libraries;
}

/// Opens a library and asks for its entry; `why` is set instead when there is none.
const PluginEntry* entry_of(const fs::path& library, Trial trial, std::string& why)
{
    const std::string name = library.stem().string();
    why = library_refusal(library);
    if (why.empty() && !is_plugin_name(name)) why = kNotAName;
    if (why.empty() && trial != Trial::none) why = trial_refusal(library, trial);
    if (!why.empty()) return nullptr;
    const PluginCall loading(name, "loading");
    void* handle = ::dlopen(fs::absolute(library).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle) {
        why = fmt::format("it does not load: {}", ::dlerror());
        return nullptr;
    }
    void* symbol = ::dlsym(handle, "hw_plugin");
    if (!symbol) {
        why = "it has no function hw_plugin(): a plugin says HW_STYLE or HW_IMAGE_PASS once";
        return nullptr;
    }
    try {
        const PluginEntry* entry = reinterpret_cast<PluginFunction>(symbol)();
        why = plugin_refusal(entry, name);
        return entry;
    } catch (...) {
        why = "its function hw_plugin() throws";
        return nullptr;
    }
}

Plugin described(const PluginEntry& entry, fs::path library, fs::path shader_folder)
{
    return {.name = entry.name,
            .kind = entry.kind,
            .summary = entry.summary ? entry.summary : "",
            .library = std::move(library),
            .shader_folder = std::move(shader_folder),
            .entry = &entry};
}

}  // namespace

bool is_plugin_name(std::string_view name)
{
    return is_lower_snake(name);
}

std::string plugin_refusal(const PluginEntry* entry, std::string_view file_name)
{
    if (!entry) return "its function hw_plugin() returns nothing";
    if (entry->api_version != kStyleApiVersion)
        return fmt::format(
            "it was written for version {} of the plugin interface, this program has version {}: change its source for "
            "that and build it anew",
            entry->api_version, kStyleApiVersion);
    if (!entry->build || std::string_view(entry->build) != HW_PLUGIN_BUILD)
        return fmt::format(
            "it was built by \"{}\", this program by \"{}\": build it with the same compiler, GLM, build type and "
            "headers of the interface",
            entry->build ? entry->build : "", HW_PLUGIN_BUILD);
    if (!entry->name || !is_plugin_name(entry->name)) return kNotAName;
    if (!file_name.empty() && file_name != entry->name)
        return fmt::format("it calls itself \"{}\": the library must have the same name", entry->name);
    const bool has_maker = (entry->kind == PluginKind::style && entry->make_style) ||
                           (entry->kind == PluginKind::image_pass && entry->make_image_pass);
    return has_maker ? "" : "it makes neither a style nor an image pass";
}

PluginRegistry::PluginRegistry(const PluginPlaces& places)
{
    const fs::path prefix = installation_prefix();
    for (const PluginFunction function : places.compiled_in) {
        const PluginEntry* entry = function();
        if (const std::string why = plugin_refusal(entry, ""); !why.empty()) {
            refused_.push_back({"compiled in", "", why});
            continue;
        }
        add(described(*entry, {}, prefix / kInstalledShaders / entry->name));
    }
    if (places.has_installed) load_folder(prefix / kInstalledLibraries, prefix / kInstalledShaders, Trial::none);
    for (const fs::path& folder : places.folders) {
        std::error_code failed;
        if (!fs::is_directory(folder, failed))
            throw Error({.what = "there is no such folder of plugins", .file = folder.string()});
        const bool is_installed = fs::equivalent(folder, prefix / kInstalledLibraries, failed);
        load_folder(folder, folder, is_installed ? Trial::none : places.trial);
    }
    if (!places.under_trial.empty()) load(places.under_trial, places.under_trial.parent_path(), Trial::none);
    for (const RefusedPlugin& refused : refused_)
        log_warning(fmt::format("{}: the plugin is left out: {}", refused.library.string(), refused.why));
}

void PluginRegistry::load_folder(const fs::path& libraries, const fs::path& shaders, Trial trial)
{
    for (const fs::path& library : libraries_in(libraries)) load(library, shaders, trial);
}

void PluginRegistry::load(const fs::path& library, const fs::path& shaders, Trial trial)
{
    const std::string name = library.stem().string();
    std::string why;
    const PluginEntry* entry = entry_of(library, trial, why);
    if (why.empty())
        add(described(*entry, library, shaders / name));
    else
        refused_.push_back({name, library, why});
}

void PluginRegistry::add(Plugin plugin)
{
    const auto before = [](const Plugin& a, const std::string& name) { return a.name < name; };
    const auto place = std::lower_bound(plugins_.begin(), plugins_.end(), plugin.name, before);
    if (place != plugins_.end() && place->name == plugin.name)
        *place = std::move(plugin);
    else
        plugins_.insert(place, std::move(plugin));
}

const Plugin* PluginRegistry::find(std::string_view name, PluginKind kind) const
{
    for (const Plugin& plugin : plugins_)
        if (plugin.kind == kind && plugin.name == name) return &plugin;
    return nullptr;
}

std::vector<std::string> PluginRegistry::names(PluginKind kind) const
{
    std::vector<std::string> result;
    for (const Plugin& plugin : plugins_)
        if (plugin.kind == kind) result.push_back(plugin.name);
    return result;
}

}  // namespace hw
