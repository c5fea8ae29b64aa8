#include "hatchway/world/light/lamp_choice.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "hatchway/core/box.hpp"
#include "hatchway/world/light/material.hpp"

namespace hw {
namespace {

constexpr float kNearest_m2 = 1e-4f;  // as near as light grows by its square: unshadowed_illuminance()
constexpr float kSlack = 1e-5f;       // of cosines: rounding darkens no place

bool is_sun(const Light& light)
{
    return light.type == LightType::sun;
}

/// What each light counts for: a weak lamp may be the only one that a place sees, so half of it looks at no power.
std::vector<double> powers_of(std::span<const Light> lights, double reach_m)
{
    std::vector<double> powers;
    for (const Light& light : lights)
        powers.push_back(luminance_of(light.colour * light.intensity) * (is_sun(light) ? reach_m * reach_m : 1.0));
    const double total = std::accumulate(powers.begin(), powers.end(), 0.0);
    const double even = 1.0 / static_cast<double>(lights.size());
    for (double& power : powers) power = total > 0.0 ? 0.5 * power / total + 0.5 * even : even;
    return powers;
}

/// Cosine of a cone around all that is off an axis by so much; less than any if that is everything.
float cos_of_cone(double angle_rad)
{
    constexpr double kAll_rad = 3.14159;
    return angle_rad < kAll_rad ? static_cast<float>(std::cos(angle_rad)) : -2.0f;
}

/// Most that a direction can have over all places of a box, relative to its centre.
float reach_of(const glm::vec3& direction, const glm::vec3& half_m)
{
    return glm::dot(glm::abs(direction), half_m);
}

}  // namespace

LampChoice::LampChoice(Lights lights, const glm::dvec3& origin_world, double reach_m)
    : origin_world_(origin_world), per_squared_reach_(static_cast<float>(1.0 / (reach_m * reach_m)))
{
    if (lights.size() <= kMostAsked) return;
    std::vector<std::uint32_t> all(lights.size());
    std::iota(all.begin(), all.end(), 0u);
    nodes_.reserve(2 * all.size());
    add(lights, all, powers_of(lights, reach_m));
}

LampChoice::Node LampChoice::bounds_of(Lights lights, std::span<const std::uint32_t> some,
                                       const std::vector<double>& powers) const
{
    Node node{.is_sunny = std::ranges::all_of(some, [&](std::uint32_t i) { return is_sun(lights[i]); }),
              .is_leaf = some.size() == 1,
              .next = some.front()};
    Box box;
    glm::dvec3 axis(0.0);
    double power = 0.0;
    for (const std::uint32_t i : some) {
        power += powers[i];
        axis += glm::normalize(lights[i].direction_world);
        if (!is_sun(lights[i])) box.add(lights[i].position_world - origin_world_);
        const float range_m = lights[i].range_m;
        node.range_m = std::max(node.range_m, range_m > 0.0f ? range_m : std::numeric_limits<float>::infinity());
    }
    node.power = static_cast<float>(power);
    if (!box.is_empty()) {
        node.centre = box.centre();
        node.half_m = 0.5 * box.size();
    }
    if (!(glm::length(axis) > 0.0)) return node;
    axis = glm::normalize(axis);
    double outer_rad = 0.0, inner_rad = 0.0;
    for (const std::uint32_t i : some) {
        constexpr double kAll = std::numeric_limits<double>::infinity();
        const double turn = std::acos(std::clamp(glm::dot(axis, glm::normalize(lights[i].direction_world)), -1.0, 1.0));
        const bool is_spot = lights[i].type == LightType::spot;
        outer_rad = std::max(outer_rad, turn + (is_spot ? lights[i].outer_cone_rad : kAll));
        inner_rad = std::max(inner_rad, turn + (is_spot ? lights[i].inner_cone_rad : kAll));
    }
    node.axis = axis;
    node.cos_outer = cos_of_cone(outer_rad);
    node.cos_inner = cos_of_cone(inner_rad);
    return node;
}

/// Halves them: suns from lamps, else by place, suns by their number.
void LampChoice::add(Lights lights, std::span<std::uint32_t> some, const std::vector<double>& powers)
{
    const std::size_t at = nodes_.size();
    nodes_.push_back(bounds_of(lights, some, powers));
    if (some.size() == 1) return;
    const auto is_lamp = [&](std::uint32_t i) { return !is_sun(lights[i]); };
    auto middle = std::stable_partition(some.begin(), some.end(), is_lamp);
    if (middle == some.end()) {
        Box box;
        for (const std::uint32_t i : some) box.add(lights[i].position_world);
        const glm::dvec3 size = box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
        std::nth_element(some.begin(), middle, some.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(lights[a].position_world[axis], a) < std::pair(lights[b].position_world[axis], b);
        });
    } else if (middle == some.begin()) {
        middle += static_cast<std::ptrdiff_t>(some.size() / 2);
    }
    add(lights, {some.begin(), middle}, powers);
    nodes_[at].next = static_cast<std::uint32_t>(nodes_.size());
    add(lights, {middle, some.end()}, powers);
}

/// At least 0, and more than that wherever one of the lamps may give light.
float LampChoice::importance(const Node& node, const glm::vec3& place, const glm::vec3& face_normal) const
{
    if (node.is_sunny) {
        const bool is_behind = node.is_leaf && glm::dot(face_normal, node.axis) >= 0.0f;
        return is_behind ? 0.0f : node.power * per_squared_reach_;
    }
    const glm::vec3 way = node.centre - place;
    const glm::vec3 outside = glm::max(glm::abs(way) - node.half_m, 0.0f);
    const float nearest = std::sqrt(std::max(glm::dot(outside, outside), kNearest_m2));
    const float cos_face = (glm::dot(face_normal, way) + reach_of(face_normal, node.half_m)) / nearest;  // at most
    const float cos_axis = (reach_of(node.axis, node.half_m) - glm::dot(node.axis, way)) / nearest;      // at most
    if (cos_face <= -kSlack || cos_axis < node.cos_outer - kSlack || nearest > node.range_m) return 0.0f;
    const float cone = (cos_axis - node.cos_outer) / std::max(0.001f, node.cos_inner - node.cos_outer);
    const float falloff = std::clamp(cone * cone, kSlack, 1.0f) * std::clamp(cos_face, kSlack, 1.0f);
    const float squared = std::max(glm::dot(way, way), glm::dot(node.half_m, node.half_m));
    return node.power * falloff / std::max(squared, kNearest_m2);
}

std::optional<LampChoice::Chosen> LampChoice::chosen(const glm::vec3& place, const glm::vec3& face_normal,
                                                     double share) const
{
    std::uint32_t at = 0;
    double chance = 1.0;
    while (!nodes_[at].is_leaf) {
        const double first = importance(nodes_[at + 1], place, face_normal);
        const double second = importance(nodes_[nodes_[at].next], place, face_normal);
        if (!(first + second > 0.0)) return std::nullopt;
        const double split = first / (first + second);
        const bool is_first = share < split || second == 0.0;
        const double own = is_first ? split : 1.0 - split;
        share = std::clamp((is_first ? share : share - split) / own, 0.0, 1.0);
        chance *= own;
        at = is_first ? at + 1 : nodes_[at].next;
    }
    return Chosen{nodes_[at].next, static_cast<float>(chance)};
}

}  // namespace hw
