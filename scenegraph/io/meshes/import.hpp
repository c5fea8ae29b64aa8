#pragma once

#include <filesystem>
#include <string>

#include "hatchway/io/meshes/raw_mesh.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Reads a mesh file: OBJ, PLY (text, binary of either byte order), STL (text or binary), OFF (text; also COFF, NOFF,
/// CNOFF). Units and axes are those of the file, y is up as everywhere. `bytes` are the file's; files that it names
/// must lie in `project_root`.
///
/// The file may come from a stranger: its counts, indices, numbers and names are checked before OpenMesh's reader sees
/// what is left of it, and that reader opens no file. What breaks the shape throws hw::Error with the line, byte,
/// vertex or face; what only loses a detail is logged: lines and points, faces without area, materials that are
/// missing.
///
/// Every face is kept, at complex edges and flipped neighbours too; polygons become triangles. Each group of an OBJ
/// file and each solid of an STL file is a node, named "object/group"; a file without such names gives one node with
/// the name of the file. Each material of a node is an object. Colours of vertices, or of faces where vertices have
/// none, and normals are kept; without normals, smooth ones that break at folds of over 40 degrees are made.
Scene import_mesh(MeshFormat format, std::string bytes, const std::filesystem::path& file,
                  const std::filesystem::path& project_root);

}  // namespace hw
