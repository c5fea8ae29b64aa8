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
        return entry->target;
    }
    auto entry = std::make_unique<Entry>();
    entry->target = GpuTarget(desc);
    entry->is_taken = true;
    entries_.push_back(std::move(entry));
    return entries_.back()->target;
}

void TargetPool::end_frame()
{
    std::erase_if(entries_, [](const std::unique_ptr<Entry>& entry) {
        return !entry->is_taken && ++entry->idle_frames > kIdleFramesKept;
    });
    for (const std::unique_ptr<Entry>& entry : entries_) entry->is_taken = false;
}

}  // namespace hw
