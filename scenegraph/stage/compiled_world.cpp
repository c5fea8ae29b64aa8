#include "hatchway/stage/compiled_world.hpp"

#include <algorithm>
#include <mutex>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/io/compiled/key.hpp"
#include "hatchway/stage/level_world.hpp"

namespace hw {
namespace {

/// A bar that only grows: rounds of the portal flow each begin anew.
class CompileProgress {
 public:
    void tell(double share)
    {
        const std::lock_guard lock(mutex_);
        const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
        if (percent <= told_percent_) return;
        bar_.advance(static_cast<std::uint64_t>(percent - told_percent_));
        told_percent_ = percent;
    }

 private:
    std::mutex mutex_;
    int told_percent_ = 0;
    Progress bar_{"Compiling", 100};
};

void keep(const std::filesystem::path& file, const CompiledLevel& compiled, const LevelWorld& world)
{
    try {
        keep_compiled_level(file, compiled, world.chunks);
    } catch (const Error& error) {
        log_info(std::string(error.what()) +
                 ": the compiled level is not kept there; --cache FOLDER keeps it elsewhere");
    }
}

std::filesystem::path place_of(const Level& level, const CompiledCache& cache)
{
    try {
        return compiled_level_path(level, cache.folder);
    } catch (const Error& error) {
        log_warning(std::string(error.what()) + ": the compiled level is not kept");
        return {};
    }
}

}  // namespace

CompiledLevel compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options)
{
    CompileProgress progress;
    VisibilityOptions told = options;
    told.progress = [&](double share) { progress.tell(share); };
    CompiledLevel compiled;
    compiled.key = compiled_level_key(world.scene, level, options);
    compiled.effort = options.effort;
    compiled.visibility = build_visibility(world.scene, level, world.chunks, told);
    for (const Shortfall& shortfall : compiled.visibility.stats.shortfalls)
        log_info("Too fine for the compiler's budget, more is drawn than need be: " + shortfall_text(shortfall));
    return compiled;
}

CompiledLevel find_or_compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options,
                                    const CompiledCache& cache)
{
    const std::filesystem::path file = place_of(level, cache);
    if (file.empty()) return compile_world(level, world, options);
    const std::uint64_t key = compiled_level_key(world.scene, level, options);
    if (auto found = find_compiled_level(file, key, options.effort, world.scene, world.chunks))
        return std::move(*found);
    CompiledLevel compiled = compile_world(level, world, options);
    keep(file, compiled, world);
    return compiled;
}

}  // namespace hw
