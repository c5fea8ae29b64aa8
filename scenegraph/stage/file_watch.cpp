#include "hatchway/stage/file_watch.hpp"

#include <array>
#include <span>

#include "hatchway/core/hash.hpp"

namespace hw {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kMissing = 0;

/// Nothing below a folder is looked at: a tree that a stranger made may have no end.
std::uint64_t stamp_of(const fs::path& path)
{
    std::error_code failed;
    const auto time = fs::last_write_time(path, failed);
    if (failed) return kMissing;
    const std::uint64_t size = fs::is_directory(path, failed) ? 0 : fs::file_size(path, failed);
    if (failed) return kMissing;
    const std::array<std::uint64_t, 2> facts{static_cast<std::uint64_t>(time.time_since_epoch().count()), size};
    return hash_bytes(std::as_bytes(std::span(facts)));
}

}  // namespace

void FileWatch::watch(const std::vector<fs::path>& paths)
{
    std::map<fs::path, std::uint64_t> state;
    for (const fs::path& path : paths) {
        const auto known = state_.find(path);
        state[path] = known != state_.end() ? known->second : stamp_of(path);
    }
    state_ = std::move(state);
}

std::vector<fs::path> FileWatch::changed()
{
    std::vector<fs::path> result;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_look_ < period_) return result;
    last_look_ = now;
    for (auto& [path, known] : state_) {
        const std::uint64_t stamp = stamp_of(path);
        if (stamp == known || stamp == kMissing) continue;
        known = stamp;
        result.push_back(path);
    }
    return result;
}

}  // namespace hw
