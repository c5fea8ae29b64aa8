#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hw {

/// Questions to the device whether draws left anything in the depth test. Move-only; kept from frame to frame.
class GpuQueries {
 public:
    GpuQueries() = default;
    ~GpuQueries();
    GpuQueries(GpuQueries&&) = delete;

    /// Question number `index` is about the draws from here to end().
    void begin(std::size_t index);
    void end();
    /// Whether a sample passed. Waits until the device has drawn.
    bool has_passed(std::size_t index) const;

 private:
    std::vector<std::uint32_t> ids_;
};

}  // namespace hw
