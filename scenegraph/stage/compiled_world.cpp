#include "hatchway/stage/compiled_world.hpp"

#include <algorithm>
#include <mutex>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/recent_files.hpp"
#include "hatchway/core/files/user_folders.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/core/progress.hpp"
#include "hatchway/io/compiled/key.hpp"
#include "hatchway/io/compiled/write.hpp"
#include "hatchway/stage/level_world.hpp"

namespace hw {
namespace {

constexpr unsigned kPrivate = 0700;
constexpr std::uint64_t kMostCacheBytes = 2ull << 30;  // of the user's own cache folder

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

/// Where it is kept; nothing when it cannot be, which a message says.
std::optional<FolderHandle> opened(const CompiledCache& cache)
{
    try {
        return opened_cache(cache);
    } catch (const Error& error) {
        log_info(std::string(error.what()) + ": the compiled level is not kept; --cache FOLDER keeps it elsewhere");
        return std::nullopt;
    }
}

std::optional<CompiledLevel> found_in(const FolderHandle& cache, const Level& level, const LevelWorld& world,
                                      const VisibilityOptions& options)
{
    const std::uint64_t key = compiled_level_key(world.geometry_key, world.scene, level, options);
    const std::string name = compiled_level_name(level);
    auto found = find_compiled_level(cache, name, key, options.effort, world.scene, world.chunks);
    if (found) note_use(cache, name);
    return found;
}

void keep(const CompiledCache& cache, const FolderHandle& folder, const Level& level, const CompiledLevel& compiled,
          const LevelWorld& world)
{
    try {
        folder.write(compiled_level_name(level), compiled_level_bytes(compiled, world.chunks));
        if (cache.folder.empty()) keep_recent(folder, kMostCacheBytes);  // what others named is theirs
    } catch (const Error& error) {
        log_info(std::string(error.what()) + ": the compiled level is not kept; --cache FOLDER keeps it elsewhere");
    }
}

/// One message for all, and what can be done.
void tell_shortfalls(const Level& level, const std::vector<Shortfall>& shortfalls)
{
    if (shortfalls.empty()) return;
    std::string text = level.file.string() +
                       ": too fine for the compiler's budget: the picture is right, but more is drawn than need be";
    for (const Shortfall& shortfall : shortfalls) text += "; " + shortfall_text(shortfall);
    log_info(text + (level.structure ? ". Fewer nodes in the level's \"structure\", large walls and floors alone, help"
                                     : ". A level whose \"structure\" names large walls and floors alone helps"));
}

}  // namespace

FolderHandle opened_cache(const CompiledCache& cache)
{
    if (cache.folder.empty()) return user_cache_folder();
    const std::filesystem::path folder = cache.folder.has_filename() ? cache.folder : cache.folder.parent_path();
    const std::string name = folder.filename().string();
    if (name == "." || name == "..") return FolderHandle(folder);
    return FolderHandle(folder.parent_path()).made_folder(name, kPrivate);
}

CompiledLevel compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options)
{
    VisibilityOptions told = options;
    std::optional<CompileProgress> bar;
    if (!told.progress) told.progress = [&bar = bar.emplace()](double share) { bar.tell(share); };
    CompiledLevel compiled;
    compiled.key = compiled_level_key(world.geometry_key, world.scene, level, options);
    compiled.effort = options.effort;
    compiled.visibility = build_visibility(world.scene, level, world.chunks, told);
    tell_shortfalls(level, compiled.visibility.stats.shortfalls);
    return compiled;
}

std::optional<CompiledLevel> find_compiled_world(const Level& level, const LevelWorld& world,
                                                 const VisibilityOptions& options, const CompiledCache& cache)
{
    const std::optional<FolderHandle> folder = opened(cache);
    std::optional<CompiledLevel> found = folder ? found_in(*folder, level, world, options) : std::nullopt;
    if (found) found->is_from_cache = true;
    return found;
}

CompiledLevel find_or_compile_world(const Level& level, const LevelWorld& world, const VisibilityOptions& options,
                                    const CompiledCache* cache)
{
    const std::optional<FolderHandle> folder = cache != nullptr ? opened(*cache) : std::nullopt;
    if (folder)
        if (auto found = find_compiled_world(level, world, options, *cache)) return std::move(*found);
    CompiledLevel compiled = compile_world(level, world, options);
    if (folder) keep(*cache, *folder, level, compiled, world);
    return compiled;
}

}  // namespace hw
