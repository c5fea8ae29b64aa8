#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "measure/silhouettes/file_triangles.hpp"
#include "measure/silhouettes/half_edge_mesh.hpp"
#include "measure/silhouettes/silhouette_oracle.hpp"

namespace hw {

/// Where a model stands: its vertices are scaled and perhaps moved, in floats; or a node in doubles turns and moves it,
/// as levels do.
struct SilhouettePlacement {
    double offset = 0.0;  ///< Along every axis.
    double scale = 1.0;
    bool is_by_node = false;
};

/// From where a model is looked at.
struct SilhouetteViews {
    int around = 26;
    int random = 0;
    std::uint32_t seed = 20011;  ///< Of the random ones.
    bool is_orthographic = false;
};

/// One model placed for measuring, with the views that all methods get and what they are to find.
struct SilhouetteSubject {
    Surface surface;
    std::unique_ptr<HalfEdgeMesh> half_edges;
    std::unique_ptr<FileTriangles> file;
    std::unique_ptr<SilhouetteOracle> file_oracle;     ///< Of the file's triangles.
    std::unique_ptr<SilhouetteOracle> surface_oracle;  ///< Of the welded and repaired surface.
    std::vector<Viewpoint> views;                      ///< In object space, as a frame gets them.
    std::vector<std::vector<OracleEdge>> of_file;      ///< For each view, of the file's positions.
    std::vector<std::vector<OracleEdge>> edge_on;      ///< For each view, the file's edges that are open from there.
    std::vector<OracleEdge> changed;                   ///< Of the file's positions: edges that repair changed.
    std::vector<std::vector<OracleEdge>> of_surface;   ///< For each view, of the surface's positions.
    double preprocess_s = 0.0;                         ///< Without clusters.
    double cluster_s = 0.0;
};

/// The number of faces that a model has before it is placed.
std::size_t whole_faces_of(const MeshData& mesh);

/// Nothing, with a warning, where less than nine tenths of `whole_faces` are left: such a mesh is another one, and an
/// empty one cannot be wrong.
std::optional<SilhouetteSubject> silhouette_subject(MeshData mesh, const SilhouettePlacement& placement,
                                                    std::size_t whole_faces, const SilhouetteViews& views);

}  // namespace hw
