#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

namespace hw {

/// Positions by cells as large as a tolerance, so that everything near lies in 27 cells. Where very many lie near each
/// other its steps run out: then nothing is near any more.
class PositionGrid {
 public:
    PositionGrid(std::span<const glm::vec3> positions, float tolerance)
        : positions_(positions),
          tolerance_(tolerance),
          steps_left_(kSteps + static_cast<std::int64_t>(kStepsOfPosition * positions.size()))
    {
    }

    /// Takes from the steps; returns whether some are left.
    bool spend(std::size_t steps)
    {
        steps_left_ -= static_cast<std::int64_t>(steps);
        return has_steps();
    }
    bool has_steps() const { return steps_left_ >= 0; }

    void add(std::uint32_t id) { cells_[key(cell_of(positions_[id]))].push_back(id); }

    template <typename Visit>
    void for_each_near(std::uint32_t id, Visit&& visit)
    {
        const glm::dvec3 centre = cell_of(positions_[id]);
        for (int i = 0; i < 27; ++i) {
            const auto found = cells_.find(key(centre + glm::dvec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
            if (found == cells_.end() || !spend(found->second.size())) continue;
            for (const std::uint32_t other : found->second) {
                if (distance(id, other) <= tolerance_) visit(other);
            }
        }
    }
    double distance(std::uint32_t a, std::uint32_t b) const
    {
        return glm::distance(glm::dvec3(positions_[a]), glm::dvec3(positions_[b]));
    }

 private:
    static constexpr std::int64_t kSteps = 20'000'000;
    static constexpr std::size_t kStepsOfPosition = 100;

    glm::dvec3 cell_of(const glm::vec3& p) const { return glm::floor(glm::dvec3(p) / tolerance_); }
    static std::uint64_t key(const glm::dvec3& cell)
    {
        const auto part = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) & 0x1fffff; };
        return part(cell.x) << 42 | part(cell.y) << 21 | part(cell.z);  // cells that share a key only cost a comparison
    }

    std::span<const glm::vec3> positions_;
    double tolerance_;
    std::int64_t steps_left_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace hw
