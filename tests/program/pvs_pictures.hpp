#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hatchway/style/needs.hpp"

namespace hw::test {

/// How two pictures of the same view differ.
struct PvsDifference {
    int eyes = 0;
    int unlike_pictures = 0;     ///< Eyes whose picture differs at all.
    int unlike_pixels = 0;       ///< In all pictures.
    int most_unlike_pixels = 0;  ///< In the picture of worst_view.
    int inked_pixels = 0;        ///< In all pictures: what is not paper.
    double drawn_share = 0.0;    ///< Triangles drawn with the PVS over those without.
    std::string worst_view;
};

/// Draws a level from random eyes, with the PVS and without; an image of the frame in place of the picture, when given.
PvsDifference compare_with_pvs(const std::filesystem::path& level, const std::string& style, int eyes,
                               const std::optional<ImageKey>& shown = {});

/// The scenes beside the project and the hall; those that exist.
std::vector<std::filesystem::path> pvs_scenes();

}  // namespace hw::test
