#pragma once

#include <exception>
#include <string>
#include <utility>

#include "hatchway/core/error.hpp"
#include "hatchway/plugin_host/trial/crash_watch.hpp"

namespace hw {

/// Calls into a plugin: what it throws arrives as hw::Error, in which `doing` says what was asked of it. Of a plugin
/// that is watched a crash is noted, too.
template <typename Call>
auto call_plugin(const std::string& plugin, const char* doing, const std::string& file, const std::string& pointer,
                 Call&& call)
{
    const auto failure = [&](const std::string& why) {
        return Error({.what = "the plugin \"" + plugin + "\" failed in " + doing + ": " + why,
                      .file = file,
                      .pointer = pointer});
    };
    const PluginCall noted(plugin, doing);
    try {
        return std::forward<Call>(call)();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw failure(error.what());
    } catch (...) {
        throw failure("it threw something that is no exception");
    }
}

}  // namespace hw
