#include "hatchway/io/meshes/import.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "hatchway/core/error.hpp"
#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/meshes/materials.hpp"
#include "hatchway/io/meshes/mesh_build.hpp"
#include "hatchway/io/meshes/obj_check.hpp"
#include "hatchway/io/meshes/off_check.hpp"
#include "hatchway/io/meshes/ply_check.hpp"
#include "hatchway/io/meshes/stl_check.hpp"

namespace hw {
namespace {

CheckedMesh check(MeshFormat format, std::string bytes, const std::string& name)
{
    switch (format) {
        case MeshFormat::obj:
            return check_obj(std::move(bytes), name);
        case MeshFormat::ply:
            return check_ply(std::move(bytes), name);
        case MeshFormat::stl:
            return check_stl(std::move(bytes), name);
        case MeshFormat::off:
            break;
    }
    return check_off(std::move(bytes), name);
}

void report_losses(const CheckedMesh& mesh, const std::string& name)
{
    if (mesh.lines_and_points > 0)
        log_warning(fmt::format("{}: {} elements that are no faces are left out", name, mesh.lines_and_points));
    if (mesh.faces_without_area > 0)
        log_warning(fmt::format("{}: {} faces of fewer than three different corners are left out", name,
                                mesh.faces_without_area));
}

/// Makes nodes as parts need them.
class NodeMaker {
 public:
    NodeMaker(Scene& scene, std::string fallback_name) : scene_(scene), fallback_name_(std::move(fallback_name)) {}

    int node_of(const MeshPart& part)
    {
        if (part.object.empty() && part.group.empty()) return node(fallback_name_, kNone);
        const int object = part.object.empty() ? kNone : node(part.object, kNone);
        return part.group.empty() ? object : node(part.group, object);
    }

 private:
    int node(const std::string& name, int parent)
    {
        const auto [found, is_new] = nodes_.try_emplace({parent, name}, static_cast<int>(scene_.nodes.size()));
        if (!is_new) return found->second;
        Node node;
        node.name = name;
        node.path = parent == kNone ? name : scene_.nodes[static_cast<std::size_t>(parent)].path + '/' + name;
        node.parent = parent;
        scene_.nodes.push_back(std::move(node));
        return found->second;
    }

    Scene& scene_;
    std::string fallback_name_;
    std::map<std::pair<int, std::string>, int> nodes_;
};

void add_object(MeshData mesh, int node, int material, Scene& scene)
{
    Object object{.node = node, .mesh = static_cast<int>(scene.meshes.size()), .material = material};
    for (const glm::vec3& position : mesh.positions) object.bounds_world.add(glm::dvec3(position));
    scene.bounds_world.add(object.bounds_world);
    scene.meshes.push_back(std::move(mesh));
    scene.objects.push_back(object);
}

}  // namespace

Scene import_mesh(MeshFormat format, std::string bytes, const std::filesystem::path& file,
                  const std::filesystem::path& project_root)
{
    Scene scene;
    scene.file = file.string();
    CheckedMesh checked = check(format, std::move(bytes), scene.file);
    if (checked.faces == 0)
        throw Error(
            {.what = "there are no faces", .file = scene.file, .expected = "a mesh; points alone are not drawn"});
    std::vector<MeshData> meshes;
    {
        const RawMesh raw = read_raw_mesh(format, checked, scene.file);
        checked.text = {};
        meshes = build_meshes(raw, checked);
    }
    NodeMaker nodes(scene, file.stem().string());
    ObjMaterials materials(file, project_root, checked.material_files);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const MeshPart& part = checked.parts[i];
        const int material = materials.import_material(part.material, !meshes[i].colours.empty(), scene);
        add_object(std::move(meshes[i]), nodes.node_of(part), material, scene);
    }
    report_losses(checked, scene.file);
    return scene;
}

}  // namespace hw
