#pragma once

#include <memory>
#include <vector>

#include "hatchway/gl/gpu_target.hpp"

namespace hw {

/// Targets that live for one frame and whose memory serves the next.
class TargetPool {
 public:
    /// A target of this kind that nobody uses in this frame; content undefined. Throws hw::Error, Fault::device.
    GpuTarget& take(const GpuTargetDesc& desc);
    /// How many targets are taken, for free_since().
    std::size_t taken_count() const { return taken_.size(); }
    /// Frees the targets that were taken when so many were: a part of the frame is over.
    void free_since(std::size_t taken_count);
    /// Ends the frame: all targets are free again; those unused for some frames go.
    void end_frame();

 private:
    struct Entry {
        GpuTarget target;
        bool is_taken = false;
        int idle_frames = 0;
    };
    std::vector<std::unique_ptr<Entry>> entries_;
    std::vector<Entry*> taken_;  ///< In the order of take().
};

}  // namespace hw
