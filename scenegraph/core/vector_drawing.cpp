#include "hatchway/core/vector_drawing.hpp"

#include <cmath>

namespace hw {

std::vector<glm::dvec2> rounded_points(const VectorLine& line)
{
    constexpr double kStep = 0.01;
    std::vector<glm::dvec2> points;
    for (const glm::dvec2& point : line.points_px) {
        const glm::dvec2 rounded(std::round(point.x / kStep) * kStep, std::round(point.y / kStep) * kStep);
        if (points.empty() || points.back() != rounded) points.push_back(rounded);
    }
    if (line.is_closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
    return points;
}

}  // namespace hw
