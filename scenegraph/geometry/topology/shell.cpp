#include "hatchway/geometry/topology/shell.hpp"

#include <algorithm>

#include "hatchway/geometry/topology/repaired_mesh.hpp"

namespace hw {

bool is_shell(const MeshData& mesh)
{
    const RepairedMesh repaired = repair_mesh(weld(mesh), kStitchShare);
    const auto& two_sided = repaired.two_sided_faces;
    bool is_closed = !repaired.uses.empty() && std::find(two_sided.begin(), two_sided.end(), true) == two_sided.end();
    for_each_edge(repaired.uses, [&](std::span<const DirectedEdge> edge) {
        is_closed &= edge.size() == 2 && edge[0].is_forward != edge[1].is_forward;
    });
    return is_closed;
}

}  // namespace hw
