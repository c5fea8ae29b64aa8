#pragma once

#include <sys/types.h>

#include <array>
#include <string>
#include <string_view>

namespace hw {

/// A plugin whose crash is to be noted, so that the next start can leave it out.
struct WatchedPlugin {
    std::string name;
    int folder = -1;  ///< Of verdicts; -1: the note goes to stderr alone.
    std::string key;  ///< Of its library: the name of the verdict.
};

/// From now on a crash or an abort in a PluginCall of this plugin writes the plugin, the call and what was being drawn
/// to stderr and as a verdict (library_verdicts.hpp), then goes the way that it went before. An exit() in a call does
/// the same and ends with code 2. Until the first plugin is watched, no handler is installed.
void watch_plugin(WatchedPlugin plugin);

/// What a plugin is being asked for, while this lives. From one thread, whose crashes alone are noted: others may work
/// for the host. Calls nest, and of one within a call of the same plugin the outer is noted. Costs a comparison unless
/// some plugin is watched.
class PluginCall {
 public:
    /// `drawn` names the objects that the call is about; empty: none.
    PluginCall(std::string_view plugin, std::string_view doing, std::string_view drawn = {});
    ~PluginCall();
    PluginCall(const PluginCall&) = delete;
    PluginCall& operator=(const PluginCall&) = delete;

    /// Whether anybody would read `drawn`.
    static bool is_watching();

 private:
    friend struct CrashNote;

    const WatchedPlugin* plugin_ = nullptr;  ///< Null: nobody watches it.
    const PluginCall* outer_ = nullptr;
    pid_t thread_ = 0;
    std::array<char, 480> text_;  ///< Complete when the crash comes: nothing may be allocated then.
};

}  // namespace hw
