#pragma once

#include <cstdint>
#include <filesystem>

namespace hw {

/// What an export of edges wrote.
struct EdgeExport {
    std::uint64_t primitives = 0;
    std::uint64_t drawn_edges = 0;       ///< Borders, creases and the artist's: value 2, repeated as 3.
    std::uint64_t silhouette_edges = 0;  ///< Smooth edges that are a contour from somewhere: value 1.
    std::uint64_t skipped_primitives = 0;
};

/// The model with EXT_mesh_primitive_edge_visibility on every list of triangles, as a .glb with one buffer: which edges
/// are drawn from every viewpoint (folded by more than `crease_rad`, borders, the artist's), which may be silhouettes,
/// and which never show. Everything else of the model stays. An extension that is there is replaced; what it marks is
/// kept as the artist's. Strips and fans are skipped: the extension does not cover them. Throws hw::Error for a model
/// that cannot be read, and for one whose images lie beside it when `out` is in another folder. `project_root` is the
/// folder that no file of the model may lie outside of.
EdgeExport export_edges(const std::filesystem::path& model, const std::filesystem::path& project_root,
                        const std::filesystem::path& out, float crease_rad);

}  // namespace hw
