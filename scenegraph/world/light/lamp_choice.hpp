#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// Of suns, points and spots those that a place asks for light: all, or of many a few chosen by what they may give
/// there, so that light costs about the same however many shine. Source: Conty Estevez, Kulla. Importance Sampling of
/// Many Lights with Adaptive Tree Splitting. HPG 2018.
class LampChoice {
 public:
    static constexpr std::uint32_t kMostAsked = 16;

    LampChoice() = default;
    /// Places are relative to `origin_world`. `reach_m`: how far from a lamp a place is, about; suns are compared with
    /// lamps by it.
    LampChoice(std::span<const Light> lights, const glm::dvec3& origin_world, double reach_m);

    struct Chosen {
        std::uint32_t light = 0;
        float chance =
            1.0f;  ///< Of this light at this place. What it gives, divided by it, is on the mean what all do.
    };
    bool asks_all() const { return nodes_.empty(); }
    /// One lamp where not all are asked. `share` in [0, 1): as much of it leads to a lamp as that lamp has chance.
    /// Nothing if none shines on the front of a face with this unit normal.
    std::optional<Chosen> chosen(const glm::vec3& place, const glm::vec3& face_normal, double share) const;

 private:
    /// Some lamps, or some suns, in a box and with a cone in which all of them shine.
    struct Node {
        glm::vec3 centre{0.0f};
        glm::vec3 half_m{0.0f};  ///< Of the box.
        glm::vec3 axis{0.0f};    ///< Of the cone, away from the lamps.
        float cos_outer = -2.0f;
        float cos_inner = -1.0f;  ///< Off the axis by more, lamps grow darker.
        float range_m = 0.0f;     ///< Farther off none of them shines.
        float power = 0.0f;       ///< Candela of lamps, lux of suns; a share of all.
        bool is_sunny = false;
        bool is_leaf = false;
        std::uint32_t next = 0;  ///< A leaf's light; else the second child. The first one follows its parent.
    };
    using Lights = std::span<const Light>;

    void add(Lights lights, std::span<std::uint32_t> some, const std::vector<double>& powers);
    Node bounds_of(Lights lights, std::span<const std::uint32_t> some, const std::vector<double>& powers) const;
    float importance(const Node& node, const glm::vec3& place, const glm::vec3& face_normal) const;

    glm::dvec3 origin_world_{0.0};
    float per_squared_reach_ = 1.0f;
    std::vector<Node> nodes_;  // the root first; none: all are asked
};

}  // namespace hw
