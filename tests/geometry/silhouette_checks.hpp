#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/exact_oracle.hpp"
#include "geometry/silhouettes.hpp"

namespace hw::test {

/// 26 eyes: 14 around the surface and far from it, 6 exactly in the plane of a face (where its floats allow), 2 on
/// vertices, 1 on an edge, 1 on a face, 1 in the planes of both faces of an edge, 1 in the middle of the bounding box.
std::vector<glm::dvec3> eyes_around(const Surface& surface);

/// False positives plus false negatives against the oracle.
std::size_t wrong_edges(const Surface& surface, const Viewpoint& viewpoint, const ExactOracle& oracle,
                        SilhouetteScratch& scratch, FacingPrecision precision = FacingPrecision::exact);

/// The same, over eyes_around() and, on a closed surface, plus vertices with an odd number of silhouette edges.
std::size_t wrong_edges_in_all_views(const Surface& surface, bool every_sign_rational = false);

/// Vertices of closed components at which an odd number of silhouettes meets.
std::size_t odd_vertices(const Surface& surface, std::span<const std::uint32_t> silhouettes);

}  // namespace hw::test
