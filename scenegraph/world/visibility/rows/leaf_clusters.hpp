#pragma once

#include <span>
#include <vector>

#include "hatchway/world/visibility/rows/pvs.hpp"
#include "hatchway/world/visibility/tree/bsp.hpp"
#include "hatchway/world/visibility/tree/portals.hpp"

namespace hw {

/// How far clusters are merged.
struct LeafClusterOptions {
    int most = 600;                 ///< Small clusters that are open to each other are merged until there are so many.
    double least_open_share = 0.6;  ///< Of their contact, for two clusters to be merged.
    int most_at_all = 10'000;       ///< Where more are left the smallest are merged, whatever is between them.
};

/// Makes clusters of what is really one place, and renumbers them. Parts of a cluster that no opening joins are
/// clusters of their own. Those without an open leaf become one, number 0 (it needs no row of its own). Of the others,
/// pairs whose contact is mostly open are merged, smallest first, and any where still very many are left, such as the
/// pockets between faces that are strewn at random; what stood between them no longer blocks: more is visible, never
/// less. Returns where that was done, a place for each merge, in metres from the grid's origin.
std::vector<glm::dvec3> merge_clusters(BspTree& tree, std::span<const LeafContact> contacts,
                                       const LeafClusterOptions& options);

/// Parts the merged clusters anew into cells, for which rows are made: BspBuild::part_of_leaf within each cluster,
/// small ones of a cluster merged as the options say. Clusters of the tree are the cells then, and number 0 stays the
/// one of leaves that are not open. Returns each cell's cluster as it was.
std::vector<int> split_into_cells(BspBuild& build, std::span<const LeafContact> contacts,
                                  const LeafClusterOptions& options);

/// The openings between the clusters. Those of one passage in one plane become their hull where that adds little, or
/// where they are too many.
PortalGraph cluster_portals(const BspBuild& build, std::span<const LeafContact> contacts);

/// A box around each leaf, metres from the grid's origin.
std::vector<Box> leaf_boxes(const BspTree& tree, std::span<const LeafContact> contacts);

/// A box around each cluster, world space.
std::vector<Box> cluster_boxes(const BspTree& tree, std::span<const Box> boxes_of_leaves);

}  // namespace hw
