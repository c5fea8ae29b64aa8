#include "hatchway/io/gltf/check/nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "hatchway/core/limits.hpp"
#include "hatchway/io/json/text.hpp"

namespace hw {
namespace {

using nlohmann::json;

constexpr std::size_t kNoParent = static_cast<std::size_t>(-1);

std::vector<std::size_t> parents_of(const GltfChecked& gltf)
{
    const json& nodes = gltf.list("nodes");
    std::vector<std::size_t> parents(nodes.size(), kNoParent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes[i].find("children");
        if (children == nodes[i].end()) continue;
        for (std::size_t k = 0; k < children->size(); ++k) {
            std::size_t& parent = parents[(*children)[k].get<std::size_t>()];
            const std::string pointer = pointer_to(pointer_to("/nodes", i) + "/children", k);
            if (parent != kNoParent)
                gltf.refuse(pointer,
                            fmt::format("node {} is a child of node {} already", (*children)[k].dump(), parent),
                            "one parent for each node");
            parent = i;
        }
    }
    return parents;
}

/// Each node has at most one parent, so a walk upwards either ends at a root or runs in a loop.
void check_loops(const GltfChecked& gltf, const std::vector<std::size_t>& parents)
{
    std::vector<int> depths(parents.size(), 0);  // 0: not known yet
    std::vector<std::size_t> chain;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        chain.clear();
        std::size_t node = i;
        while (node != kNoParent && depths[node] == 0) {
            if (chain.size() > parents.size()) gltf.refuse(pointer_to("/nodes", i), "the node is its own ancestor");
            chain.push_back(node);
            node = parents[node];
            if (node == i) gltf.refuse(pointer_to("/nodes", i), "the node is its own ancestor", "a tree without loops");
        }
        int depth = node == kNoParent ? 0 : depths[node];
        for (std::size_t k = chain.size(); k-- > 0;) depths[chain[k]] = ++depth;
        if (depth > limits::kMaxNodeDepth)
            gltf.refuse(pointer_to("/nodes", i), fmt::format("the node lies {} deep in the tree", depth),
                        fmt::format("at most {}", limits::kMaxNodeDepth));
    }
}

void check_scenes(const GltfChecked& gltf, const std::vector<std::size_t>& parents)
{
    const json& scenes = gltf.list("scenes");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto roots = scenes[i].find("nodes");
        if (roots == scenes[i].end()) continue;
        std::vector<bool> is_named(parents.size(), false);
        for (std::size_t k = 0; k < roots->size(); ++k) {
            const auto node = (*roots)[k].get<std::size_t>();
            const std::string pointer = pointer_to(pointer_to("/scenes", i) + "/nodes", k);
            if (parents[node] != kNoParent)
                gltf.refuse(pointer, fmt::format("node {} is a child of node {}", node, parents[node]), "a root");
            if (is_named[node]) gltf.refuse(pointer, fmt::format("node {} stands here twice", node), "each root once");
            is_named[node] = true;
        }
    }
}

void check_transform(const GltfChecked& gltf, const json& node, const std::string& pointer)
{
    if (const auto matrix = node.find("matrix"); matrix != node.end()) {
        const bool is_affine = (*matrix)[3] == 0 && (*matrix)[7] == 0 && (*matrix)[11] == 0 && (*matrix)[15] == 1;
        if (!is_affine) gltf.refuse(pointer + "/matrix", "the matrix's last row is not 0 0 0 1");
        for (const char* other : {"translation", "rotation", "scale"})
            if (node.contains(other)) gltf.refuse(pointer + "/matrix", fmt::format("a {} stands beside it", other));
    }
    if (const auto rotation = node.find("rotation"); rotation != node.end()) {
        double length = 0.0;
        for (const json& part : *rotation) length += part.get<double>() * part.get<double>();
        if (std::abs(length - 1.0) > 0.01)
            gltf.refuse(pointer + "/rotation", fmt::format("the quaternion's length is {:.6g}", std::sqrt(length)),
                        "1");
    }
}

}  // namespace

void check_nodes(const GltfChecked& gltf)
{
    const std::vector<std::size_t> parents = parents_of(gltf);
    check_loops(gltf, parents);
    check_scenes(gltf, parents);
    const json& nodes = gltf.list("nodes");
    for (std::size_t i = 0; i < nodes.size(); ++i) check_transform(gltf, nodes[i], pointer_to("/nodes", i));
}

}  // namespace hw
