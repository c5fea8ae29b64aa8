#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <set>
#include <span>
#include <vector>

namespace hw::test {

/// Silhouettes by rational arithmetic from nothing but positions and oriented faces. Shares no code with the engine.
class ExactOracle {
 public:
    using Edge = std::array<std::uint32_t, 2>;  // lower position id first

    /// `every_sign_rational` computes each sign with GMP; otherwise only those that long doubles leave open.
    ExactOracle(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> faces,
                bool every_sign_rational);

    /// Edges of exactly two faces that differ in facing, sorted. `w` is 1 for an eye, 0 for a direction to the viewer.
    std::vector<Edge> silhouettes(const glm::dvec3& eye, double w = 1.0) const;

    std::size_t edge_count() const { return edge_count_; }
    std::size_t collinear_count() const { return inherits_.size(); }

 private:
    int sign(std::uint32_t face, const glm::dvec3& eye, double w) const;

    std::span<const glm::vec3> positions_;
    std::span<const std::array<std::uint32_t, 3>> faces_;
    bool every_sign_rational_;
    std::size_t edge_count_ = 0;
    struct Pair {
        Edge edge;
        std::uint32_t a, b;
    };
    std::vector<Pair> pairs_;
    std::vector<std::array<std::uint32_t, 2>> inherits_;  // collinear face, source or itself
};

}  // namespace hw::test
