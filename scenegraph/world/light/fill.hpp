#pragma once

#include <span>

#include "hatchway/world/light/points.hpp"

namespace hw {

/// What a bake has gathered, each of a lightmap's luxels in the order of LuxelPoints::luxels().
struct GatheredLight {
    const LuxelPoints& points;
    std::span<const LuxelPlace> places;
    std::span<const glm::vec3> illuminance;
};

/// The pairs of neighbouring luxels of a chart between which something stands, both ways. They depend on no light.
std::vector<std::pair<std::uint32_t, std::uint32_t>> parted_luxels(const LuxelPoints& points,
                                                                   std::span<const LuxelPlace> places,
                                                                   const Lightmap& lightmap);

/// Gives every luxel the value that blending with its neighbours may show. A luxel outside of its chart holds the light
/// of the chart's edge; it goes on the line from the inside through the edge, so that the blend at the edge is right. A
/// picture's point right at a wall blends
/// luxels of both sides, so of two luxels that something parts the lighter takes the darker one's value: a shadow at
/// the foot of a wall is never noticed, light that comes through it is. Luxels inside of solids take the darkest
/// neighbour's value for the same reason; vertices there the mean of those they share a triangle with.
std::vector<glm::vec3> filled_light(const GatheredLight& gathered, const Scene& scene, const Lightmap& lightmap,
                                    std::span<const std::pair<std::uint32_t, std::uint32_t>> parted);

}  // namespace hw
