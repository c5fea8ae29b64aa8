#include "hatchway/render/device/target_pool.hpp"

namespace hw {
namespace {

constexpr int kIdleFramesKept = 30;

bool is_same_kind(const GpuTargetDesc& a, const GpuTargetDesc& b)
{
    return a.size_px == b.size_px && a.colours == b.colours && a.has_depth == b.has_depth &&
           a.is_shadow_map == b.is_shadow_map && a.samples == b.samples && a.has_depth_texture == b.has_depth_texture;
}

}  // namespace

GpuTarget& TargetPool::take(const GpuTargetDesc& desc)
{
    for (const std::unique_ptr<Entry>& entry : entries_) {
        if (entry->is_taken || !is_same_kind(entry->target.desc(), desc)) continue;
        entry->is_taken = true;
        entry->idle_frames = 0;
        taken_.push_back(entry.get());
        return entry->target;
    }
    auto entry = std::make_unique<Entry>();
    entry->target = GpuTarget(desc);
    entry->is_taken = true;
    entries_.push_back(std::move(entry));
    taken_.push_back(entries_.back().get());
    return entries_.back()->target;
}

void TargetPool::free_since(std::size_t taken_count)
{
    while (taken_.size() > taken_count) {
        taken_.back()->is_taken = false;
        taken_.pop_back();
    }
}

void TargetPool::end_frame()
{
    free_since(0);
    std::erase_if(entries_, [](const std::unique_ptr<Entry>& entry) { return ++entry->idle_frames > kIdleFramesKept; });
}

}  // namespace hw
