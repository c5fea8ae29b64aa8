#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace hw {

struct Segment {
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
    std::uint32_t key = 0;  ///< Segments of different keys are never grouped.
};

/// Groups the segments that overlap or meet and lie on one line, within `tolerance`. Returns lists of
/// segment numbers, only those of two and more, in the order of their first member. Segments shorter than the tolerance
/// are left out. Past a fixed amount of work nothing more is grouped.
std::vector<std::vector<std::uint32_t>> group_by_line(std::span<const Segment> segments, double tolerance);

}  // namespace hw
