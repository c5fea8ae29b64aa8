#pragma once

#include <span>

#include "hatchway/world/light/lightmap.hpp"

namespace hw {

/// Luxels of the longest side of one chart: larger charts get larger luxels.
inline constexpr int kMaxChartLuxels = 1000;

/// Lays the planar charts of a mesh into one rectangle of luxels. The sides of each chart's box are a whole number of
/// luxels, about `luxels_per_unit` to the unit of object space, and a border of one luxel stands around it; (0, 0) is a
/// corner of a luxel, not its middle. Where borders and roundings would take several times what the surface itself
/// needs, its vertices stand closer than luxels: the mesh is lit per vertex then. An empty mesh gives an empty layout.
LightmapLayout lay_out(const MeshData& mesh, double luxels_per_unit);

/// The lightmap of a scene with layouts, places and a size, its luxels all dark.
/// At most `budget` luxels and 4096 a side: the density is lowered until they suffice. Throws hw::Error when not even
/// coarse ones do. `receivers`: the objects that get a place; empty: all that take part in light. `lights` and
/// `eyes_world`: as of LightScene.
Lightmap plan_lightmap(const Scene& scene, double luxels_per_m, std::uint64_t budget,
                       std::span<const ObjectId> receivers = {}, std::span<const Light> lights = {},
                       std::span<const glm::dvec3> eyes_world = {});

}  // namespace hw
