#pragma once

#include <filesystem>

#include "hatchway/world/scene.hpp"

namespace hw {

/// Reads a glTF 2.0 model, .glb or .gltf, told apart by its first bytes. Files that it names (buffers, images) must lie
/// in `project_root`.
///
/// The file may come from a stranger: its nesting, references, counts, ranges, cycles and numbers are checked before
/// tinygltf sees it, and tinygltf opens no file by itself. What breaks the scene throws hw::Error with the JSON pointer
/// (or "byte N" where the container is broken); what only loses a detail is logged: lines and points are skipped, morph
/// targets and skins stay in their bind pose.
///
/// Read: the default scene (else the first, else all root nodes), with nodes reordered so that parents stand first;
/// instances share their meshes; metallic-roughness materials, KHR_lights_punctual, KHR_materials_unlit,
/// KHR_materials_emissive_strength, KHR_texture_transform, KHR_mesh_quantization, EXT_mesh_gpu_instancing,
/// EXT_mesh_primitive_edge_visibility, cameras, extras.hatchway. Another extension in extensionsRequired is refused by
/// name. Normals are made flat where the model has none, tangents where a normal map needs them.
Scene import_gltf(const std::filesystem::path& file, const std::filesystem::path& project_root);

}  // namespace hw
