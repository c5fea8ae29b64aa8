#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>

#include "hatchway/stage/compiled_world.hpp"
#include "hatchway/stage/level_world.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw {

/// Compiles a level's visibility on a thread of its own, at a lower priority than the drawing, and keeps it in the
/// cache. The end of this stops it.
class VisibilityJob {
 public:
    VisibilityJob(Level level, std::shared_ptr<const LevelWorld> world, VisibilityOptions options,
                  std::optional<CompiledCache> cache);
    ~VisibilityJob();
    VisibilityJob(const VisibilityJob&) = delete;
    VisibilityJob& operator=(const VisibilityJob&) = delete;

    /// Of the work, 0 to 1.
    double share() const { return share_; }
    bool is_done() const;
    /// Once, when it is done. Throws what the compiler threw.
    std::shared_ptr<const Visibility> take() { return result_.get(); }

 private:
    std::atomic<double> share_{0.0};
    std::atomic<bool> is_stopped_{false};
    std::future<std::shared_ptr<const Visibility>> result_;  // last: its end waits for the thread
};

}  // namespace hw
