#pragma once

#include <string>
#include <vector>

#include "hatchway/render/view/camera_view.hpp"
#include "hatchway/world/scene.hpp"
#include "measure/edges/wanted_edges.hpp"

namespace hw {

/// A small scene that edge maps are known to fail on, with the lines that a draughtsman would draw.
struct EdgeCase {
    std::string name;
    Scene scene;
    CameraPlace camera;
    struct Line {
        glm::dvec3 from, to;
        EdgeKind kind;
    };
    std::vector<Line> lines;

    std::vector<WantedEdge> wanted(glm::ivec2 size_px) const;
};

/// Paper on a desk, folded paper, a far wall seen flat-on, floors of one and of many triangles from 1 to 5 degrees.
std::vector<EdgeCase> edge_cases();

/// So many walls, each of two triangles, that stand around one upright edge, seen from above at an angle: the edge's
/// triangles are neighbours of each other. Wants no lines. Figure 2 of Diktas, Sahiner 2011.
EdgeCase cylinder_fan(int sides);

}  // namespace hw
