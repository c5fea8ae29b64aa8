#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace hw {

/// What an opened level costs, by kind. A small file can ask for much of each.
enum class Cost : unsigned char {
    nodes,
    objects,          ///< Node x primitive pairs.
    triangles,        ///< As stored.
    vertices,         ///< As stored.
    drawn_triangles,  ///< Of all objects: instances count each time.
    path_bytes,       ///< Text of the nodes' paths.
    map_pixels,       ///< Of all levels of all maps.
    rule_steps,       ///< Of finding out which rule decides each object's look.
    line_bytes,       ///< What a line drawing holds of its objects.
    line_steps,       ///< Of finding out which parts of its lines are hidden.
    strokes,          ///< That a bitmap is read as.
    layers,           ///< Of faces and lines over a picture that a software renderer draws: render/frame_cost.hpp.
};
inline constexpr std::size_t kCostCount = 12;

/// What is left of the limits (limits.hpp) while a level is opened. Every limit is multiplied by one factor, which the
/// program's user can raise.
class Budget {
 public:
    /// Takes what the file asks for. Throws hw::Error, which says the limit and how to raise it, when less is left.
    void spend(Cost cost, std::uint64_t amount, const std::string& file, const std::string& pointer);
    /// The same check, without taking: before what is asked for is made.
    void require(Cost cost, std::uint64_t amount, const std::string& file, const std::string& pointer) const;
    std::uint64_t left(Cost cost) const;

    /// Of all budgets of this process, at least 1; to be set before any is asked.
    static double& factor();

 private:
    std::array<std::uint64_t, kCostCount> spent_{};
};

}  // namespace hw
