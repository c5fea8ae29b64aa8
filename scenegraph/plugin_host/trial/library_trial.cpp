#include "hatchway/plugin_host/trial/library_trial.hpp"

#include <fmt/format.h>

#include <optional>

#include "hatchway/core/log.hpp"
#include "hatchway/plugin_host/trial/crash_watch.hpp"
#include "hatchway/plugin_host/trial/library_verdicts.hpp"
#include "hatchway/plugin_host/trial/trial_process.hpp"

namespace hw {
namespace {

/// Why not; nothing when it could not be tried.
std::optional<std::string> tried(const std::filesystem::path& library)
{
    log_info(fmt::format("{}: the plugin is new here: it is tried in a process of its own", library.string()));
    const TrialResult result = try_in_process(library);
    if (!result.is_started) {
        log_warning(fmt::format("{}: the plugin could not be tried, and is loaded as it is", library.string()));
        return std::nullopt;
    }
    if (!result.is_drawn)
        log_info(fmt::format("{}: the plugin was prepared, but not drawn with: there is no graphics device",
                             library.string()));
    return result.why;
}

}  // namespace

std::string trial_refusal(const std::filesystem::path& library, Trial trial)
{
    const LibraryVerdicts verdicts;
    const std::string key = verdict_key(library);
    std::optional<std::string> why;
    if (trial != Trial::anew) why = verdicts.of(key);
    if (!why) {
        why = tried(library);
        if (why) verdicts.keep(key, *why);
    }
    if (why && !why->empty()) return *why + "; --retry-plugins tries it again";
    watch_plugin({library.stem().string(), verdicts.folder(), key});
    return "";
}

}  // namespace hw
