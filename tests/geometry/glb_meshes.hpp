#pragma once

#include <filesystem>
#include <vector>

#include "hatchway/geometry/mesh_data.hpp"

namespace hw::test {

/// The triangles of every primitive of a well-formed .glb, object space. For measuring data only: checks nothing.
std::vector<MeshData> read_glb_meshes(const std::filesystem::path& file);

/// All .glb files of a folder of the shared measuring data, sorted; empty where it is absent.
std::vector<std::filesystem::path> shared_glb_files(const char* folder);

}  // namespace hw::test
