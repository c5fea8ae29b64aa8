#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace hw {

/// Tells which files changed since it last looked, by time stamp and size, and in which folders names came or went; no
/// folder is read. A file that is gone for a moment, as when an editor saves by renaming, counts as changed once it is
/// back.
class FileWatch {
 public:
    /// Looks at most once in this time.
    explicit FileWatch(std::chrono::milliseconds period = std::chrono::milliseconds(250)) : period_(period) {}

    /// Watches these and no others. What was watched before keeps its known state.
    void watch(const std::vector<std::filesystem::path>& paths);

    /// The watched paths that changed.
    std::vector<std::filesystem::path> changed();

 private:
    std::chrono::milliseconds period_;
    std::chrono::steady_clock::time_point last_look_{};
    std::map<std::filesystem::path, std::uint64_t> state_;  ///< Path -> stamp_of(path).
};

}  // namespace hw
