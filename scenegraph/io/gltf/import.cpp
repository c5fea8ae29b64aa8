#include "hatchway/io/gltf/import.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <nlohmann/json.hpp>

#include "hatchway/core/limits.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/gltf/edges.hpp"
#include "hatchway/io/gltf/lights.hpp"
#include "hatchway/io/gltf/materials.hpp"
#include "hatchway/io/gltf/mesh.hpp"
#include "hatchway/io/gltf/nodes.hpp"
#include "hatchway/io/gltf/tangents.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

/// A converted primitive, not yet used by any object.
struct ReadyPrimitive {
    MeshData mesh;
    int material = kNone;    ///< Of the model.
    int scene_mesh = kNone;  ///< Once an object uses it.
    int scene_material = kNone;
};
using ReadyMesh = std::vector<ReadyPrimitive>;

/// Every mesh is converted, used or not: what is broken in a file is reported wherever it is.
std::vector<ReadyMesh> convert_meshes(const GltfModel& model, ImportTotals& totals)
{
    std::vector<ReadyMesh> meshes(model.data.meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i)
        for (std::size_t k = 0; k < model.data.meshes[i].primitives.size(); ++k) {
            const PrimitiveId id{.mesh = i, .primitive = k};
            std::optional<MeshData> mesh = convert_primitive(model, id, totals);
            if (!mesh) continue;
            mesh->artist_edges = artist_edges(model, id, *mesh);
            meshes[i].push_back({.mesh = std::move(*mesh), .material = model.data.meshes[i].primitives[k].material});
        }
    return meshes;
}

Box box_of(const MeshData& mesh)
{
    Box box;
    for (const glm::vec3& position : mesh.positions) box.add(glm::dvec3(position));
    return box;
}

/// Turns nodes x primitives into objects, and moves what they use into the scene.
class ObjectBuilder {
 public:
    ObjectBuilder(GltfModel& model, std::vector<ReadyMesh> meshes, Budget& budget, Scene& scene)
        : model_(model), meshes_(std::move(meshes)), materials_(model, scene), budget_(budget), scene_(scene)
    {
    }

    void add_objects(std::size_t node, int model_node)
    {
        const int mesh = model_.data.nodes[model_node].mesh;
        if (mesh < 0) return;
        const std::string pointer = pointer_to("/nodes", static_cast<std::size_t>(model_node));
        for (ReadyPrimitive& primitive : meshes_[mesh]) {
            use(primitive);
            budget_.spend(Cost::objects, 1, model_.file, pointer);
            budget_.spend(Cost::drawn_triangles, scene_.meshes[primitive.scene_mesh].triangle_count(), model_.file,
                          pointer);
            Object object{
                .node = static_cast<int>(node),
                .mesh = primitive.scene_mesh,
                .material = primitive.scene_material,
                .bounds_world = transformed(boxes_[primitive.scene_mesh], scene_.nodes[node].world_from_node)};
            check_bounds(object, model_node);
            scene_.bounds_world.add(object.bounds_world);
            scene_.objects.push_back(object);
        }
    }

 private:
    void use(ReadyPrimitive& primitive)
    {
        if (primitive.scene_mesh != kNone) return;
        primitive.scene_material = materials_.import_material(primitive.material);
        const TextureUse& normal_map = scene_.materials[primitive.scene_material].normal_texture;
        if (normal_map.texture != kNone) add_tangents(primitive.mesh, normal_map);
        primitive.scene_mesh = static_cast<int>(scene_.meshes.size());
        boxes_.push_back(box_of(primitive.mesh));
        scene_.meshes.push_back(std::move(primitive.mesh));
    }

    void check_bounds(const Object& object, int model_node) const
    {
        const double limit = limits::kMaxCoordinate;
        for (const glm::dvec3& corner : {object.bounds_world.min, object.bounds_world.max})
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(corner[axis]) <= limit))
                    model_.refuse(pointer_to("/nodes", static_cast<std::size_t>(model_node)),
                                  fmt::format("the node reaches the world coordinate {}", corner[axis]),
                                  fmt::format("finite ones up to {:g}", limit));
    }

    GltfModel& model_;
    std::vector<ReadyMesh> meshes_;
    MaterialImporter materials_;
    Budget& budget_;
    Scene& scene_;
    std::vector<Box> boxes_;  ///< Of Scene::meshes, object space.
};

/// Appends a child node for each instance of a node that EXT_mesh_gpu_instancing repeats. Children stand at the end of
/// the list, so that the other nodes keep their indices.
void add_instances(const GltfModel& model, const NodeOrder& order, Budget& budget, Scene& scene, ObjectBuilder& objects)
{
    for (std::size_t i = 0; i < order.model_nodes.size(); ++i) {
        const std::vector<glm::dmat4> transforms = instance_transforms(model, order.model_nodes[i]);
        const std::string pointer = pointer_to("/nodes", static_cast<std::size_t>(order.model_nodes[i]));
        constexpr std::size_t kNameBytes = 16;
        budget.spend(Cost::nodes, transforms.size(), model.file, pointer);
        budget.spend(Cost::path_bytes, transforms.size() * (scene.nodes[i].path.size() + kNameBytes), model.file,
                     pointer);
        for (std::size_t k = 0; k < transforms.size(); ++k) {
            Node node;
            node.parent = static_cast<int>(i);
            node.name = fmt::format("instance_{}", k);
            node.path = scene.nodes[i].path + '/' + node.name;
            node.local = transforms[k];
            node.world_from_node = scene.nodes[i].world_from_node * node.local;
            node.is_animated = scene.nodes[i].is_animated;
            scene.nodes.push_back(std::move(node));
            objects.add_objects(scene.nodes.size() - 1, order.model_nodes[i]);
        }
    }
}

bool is_instanced(const GltfModel& model, int model_node)
{
    const nlohmann::json& node = model.json.at("nodes")[static_cast<std::size_t>(model_node)];
    return GltfModel::extension(node, "EXT_mesh_gpu_instancing") != nullptr;
}

void report_losses(const GltfModel& model, const ImportTotals& totals)
{
    if (totals.skipped_primitives > 0)
        log_warning(
            fmt::format("{}: {} primitives of lines or points are left out", model.file, totals.skipped_primitives));
    if (totals.bent_primitives > 0)
        log_warning(fmt::format("{}: {} primitives with morph targets keep their base shape", model.file,
                                totals.bent_primitives));
    if (model.json.contains("skins") && !model.json.at("skins").empty())
        log_warning(fmt::format("{}: skinned meshes keep their bind pose", model.file));
}

}  // namespace

Scene import_gltf(const std::filesystem::path& file, const std::filesystem::path& project_root)
{
    GltfModel model = load_gltf(file, project_root);
    Scene scene;
    scene.file = model.file;
    Budget budget;
    ImportTotals totals{budget};
    ObjectBuilder objects(model, convert_meshes(model, totals), budget, scene);

    const NodeOrder order = order_nodes(model);
    add_nodes(model, order, budget, scene);
    for (std::size_t i = 0; i < order.model_nodes.size(); ++i)
        if (!is_instanced(model, order.model_nodes[i])) objects.add_objects(i, order.model_nodes[i]);
    add_instances(model, order, budget, scene, objects);
    add_lights(model, order, scene);
    add_cameras(model, order, scene);
    report_losses(model, totals);
    return scene;
}

}  // namespace hw
