#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "measure/silhouettes/silhouette_oracle.hpp"

namespace hw::test {

/// 26 eyes: 14 around the surface and far from it, 6 exactly in the plane of a face (where its floats allow), 2 on
/// vertices, 1 on an edge, 1 on a face, 1 in the planes of both faces of an edge, 1 in the middle of the bounding box.
std::vector<glm::dvec3> eyes_around(const Surface& surface);

/// The silhouettes of a surface as the oracle names edges.
std::vector<OracleEdge> found_edges(const Surface& surface, const Viewpoint& viewpoint, SilhouetteScratch& scratch,
                                    const SilhouetteOptions& options);

/// False positives plus false negatives plus odd vertices against the oracle, by brute force and, where the surface has
/// clusters and the precision is exact, by the hierarchy.
std::size_t wrong_edges(const Surface& surface, const Viewpoint& viewpoint, const SilhouetteOracle& oracle,
                        SilhouetteScratch& scratch, FacingPrecision precision = FacingPrecision::exact);

/// The same, over eyes_around().
std::size_t wrong_edges_in_all_views(const Surface& surface, bool every_sign_rational = false);

}  // namespace hw::test
