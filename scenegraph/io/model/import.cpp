#include "hatchway/io/model/import.hpp"

#include <algorithm>
#include <optional>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/io/gltf/import.hpp"
#include "hatchway/io/meshes/import.hpp"
#include "hatchway/io/model/settle_meshes.hpp"

namespace hw {
namespace {

struct Extension {
    const char* name;
    std::optional<MeshFormat> mesh;  ///< None: glTF.
};
constexpr Extension kExtensions[] = {{".glb", {}},
                                     {".gltf", {}},
                                     {".obj", MeshFormat::obj},
                                     {".ply", MeshFormat::ply},
                                     {".stl", MeshFormat::stl},
                                     {".off", MeshFormat::off}};

const Extension* extension_of(const std::filesystem::path& file)
{
    std::string name = file.extension().string();
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto* found =
        std::ranges::find(kExtensions, name, [](const Extension& known) { return std::string(known.name); });
    return found == std::end(kExtensions) ? nullptr : found;
}

/// As the first bytes say, where a format has such.
MeshFormat format_of(std::string_view bytes, MeshFormat stated)
{
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return MeshFormat::ply;
    for (const std::string_view begin : {"OFF", "COFF", "NOFF", "CNOFF"})
        if (bytes.starts_with(begin)) return MeshFormat::off;
    return stated;
}

Scene import_as_stated(const std::filesystem::path& file, const std::filesystem::path& project_root)
{
    const Extension* extension = extension_of(file);
    if (!extension || !extension->mesh) return import_gltf(file, project_root);
    std::string bytes = read_text_file(file, limits::kMaxFileBytes);
    if (bytes.starts_with("glTF")) return import_gltf(file, project_root);
    const MeshFormat format = format_of(bytes, *extension->mesh);
    return import_mesh(format, std::move(bytes), file, project_root);
}

}  // namespace

bool is_model_file(const std::filesystem::path& file)
{
    return extension_of(file) != nullptr;
}

Scene import_model(const std::filesystem::path& file, const std::filesystem::path& project_root)
{
    Scene scene = import_as_stated(file, project_root);
    settle_meshes(scene);
    return scene;
}

}  // namespace hw
