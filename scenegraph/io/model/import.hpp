#pragma once

#include <filesystem>

#include "hatchway/world/scene.hpp"

namespace hw {

/// For messages and help.
inline constexpr const char* kModelFormats = ".glb, .gltf, .obj, .ply, .stl, .off";

/// Whether the extension is one of kModelFormats, in any case of letters.
bool is_model_file(const std::filesystem::path& file);

/// Reads a model of any format: as its first bytes say (glTF binary, PLY, OFF), else as its extension says. Files that
/// it names must lie in `project_root`. Safe on files of strangers: see import_gltf() and import_mesh(). Throws
/// hw::Error for what is broken, or no model.
Scene import_model(const std::filesystem::path& file, const std::filesystem::path& project_root);

}  // namespace hw
