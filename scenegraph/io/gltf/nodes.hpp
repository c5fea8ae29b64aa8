#pragma once

#include <vector>

#include "hatchway/core/budget.hpp"
#include "hatchway/io/gltf/model.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The nodes of the default scene, in the order of the tree: parents stand before their children. Private to io.
struct NodeOrder {
    std::vector<int> model_nodes;  ///< For each node of the scene, its index in the model.
    std::vector<int> parents;      ///< For each node of the scene, the index of its parent in the scene, or kNone.
};
NodeOrder order_nodes(const GltfModel& model);

/// Fills Scene::nodes in this order: names, paths, transforms, extras, animation flags. Throws hw::Error when a world
/// transform is not finite, or nodes or the text of their paths are over the budget.
void add_nodes(const GltfModel& model, const NodeOrder& order, Budget& budget, Scene& scene);

/// EXT_mesh_gpu_instancing: the transforms of a node's instances, node from instance; empty when it has none. Throws
/// hw::Error for attributes of wrong types or unequal counts.
std::vector<glm::dmat4> instance_transforms(const GltfModel& model, int model_node);

}  // namespace hw
