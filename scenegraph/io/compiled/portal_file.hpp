#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hatchway/world/visibility/rows/pvs.hpp"

namespace hw {

/// A Quake portal file as read: text, PRT1 (leaves) or PRT2 (leaves in clusters).
struct PortalFile {
    PortalGraph graph;                 ///< Of clusters; both directions of each portal of the file.
    std::vector<int> cluster_of_leaf;  ///< PRT1: each leaf its own.
    int portals_in_file = 0;
    int portals_without_area = 0;  ///< Left out: nothing passes them.
};

/// Reads a portal file. The winding of a portal runs counter-clockwise seen from its second leaf. Throws hw::Error with
/// the line for a count, number or leaf that is out of range, a portal from a leaf to itself or of one point, and for
/// text that ends early or goes on.
PortalFile read_portal_file(const std::filesystem::path& file);

/// The same from text, as if it stood in `file`.
PortalFile parse_portals(std::string_view text, const std::string& file);

/// The portals as PRT1 text, each pair of openings that are open both ways once. One-way openings are written as if
/// they were open both ways: the format knows no other, and a tool that reads it then sees too much, never too little.
std::string portals_text(const PortalGraph& graph);

}  // namespace hw
