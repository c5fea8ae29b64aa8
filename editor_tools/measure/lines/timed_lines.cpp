#include "measure/lines/timed_lines.hpp"

#include <algorithm>
#include <chrono>

namespace hw {

std::vector<VisibleLine> timed_visible_lines(std::span<const LineObject> objects, const LineCamera& camera,
                                             const VisibleLineOptions& options, int runs, double& seconds)
{
    std::vector<VisibleLine> lines;
    std::vector<double> times_s;
    for (int run = 0; run < std::max(runs, 1); ++run) {
        const auto start = std::chrono::steady_clock::now();
        lines = find_visible_lines(objects, camera, options);
        times_s.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    const auto middle = times_s.begin() + static_cast<std::ptrdiff_t>(times_s.size() / 2);
    std::nth_element(times_s.begin(), middle, times_s.end());
    seconds = *middle;
    return lines;
}

}  // namespace hw
