#include "hatchway/stage/visibility_job.hpp"

#include <sys/resource.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace hw {
namespace {

constexpr int kNice = 10;

/// Ends the compiler from inside of its progress.
struct Stopped {};

}  // namespace

VisibilityJob::VisibilityJob(Level level, std::shared_ptr<const LevelWorld> world, VisibilityOptions options,
                             std::optional<CompiledCache> cache)
{
    // One processor is left to the drawing.
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
    options.progress = [this](double share) {
        if (is_stopped_) throw Stopped();
        share_ = share;
    };
    const auto compile = [level = std::move(level), world = std::move(world), options = std::move(options),
                          cache = std::move(cache)]() -> std::shared_ptr<const Visibility> {
        setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);  // of this thread alone
        tbb::task_arena arena(options.threads);
        CompiledLevel compiled =
            arena.execute([&] { return find_or_compile_world(level, *world, options, cache ? &*cache : nullptr); });
        return std::make_shared<Visibility>(std::move(compiled.visibility));
    };
    result_ = std::async(std::launch::async, compile);
}

VisibilityJob::~VisibilityJob()
{
    is_stopped_ = true;
}

bool VisibilityJob::is_done() const
{
    return result_.valid() && result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace hw
