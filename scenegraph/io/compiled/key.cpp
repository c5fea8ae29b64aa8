#include "hatchway/io/compiled/key.hpp"

#include <glm/mat4x4.hpp>

#include "hatchway/core/hash.hpp"

namespace hw {
namespace {

/// A hash that values are added to, one after the other.
class Key {
 public:
    template <typename Value>
    void add(const Value& value)
    {
        static_assert(std::is_arithmetic_v<Value> || std::is_same_v<Value, glm::dmat4>);
        hash_ = hash_bytes(std::as_bytes(std::span(&value, 1)), hash_);
    }
    template <typename Value>
    void add_all(const std::vector<Value>& values)
    {
        add(static_cast<std::uint64_t>(values.size()));
        hash_ = hash_bytes(std::as_bytes(std::span(values)), hash_);
    }
    void add_text(const std::string& text)
    {
        add(static_cast<std::uint64_t>(text.size()));
        hash_ = hash_bytes(std::as_bytes(std::span(text)), hash_);
    }
    std::uint64_t value() const { return hash_; }

 private:
    std::uint64_t hash_ = hash_bytes({});
};

}  // namespace

std::uint64_t geometry_key(const Scene& scene)
{
    Key key;
    for (const MeshData& mesh : scene.meshes) {
        key.add_all(mesh.positions);
        key.add_all(mesh.indices);
    }
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        const Material& material = scene.materials[static_cast<std::size_t>(object.material)];
        const Node& node = scene.nodes[static_cast<std::size_t>(object.node)];
        key.add(object.mesh);
        key.add(object.node);
        key.add(scene.world_from_object(id));
        key.add(node.is_animated);
        key.add(static_cast<std::uint8_t>(material.alpha_mode));
        key.add(material.is_double_sided);
    }
    return key.value();
}

std::uint64_t compiled_level_key(std::uint64_t geometry_key, const Scene& scene, const Level& level,
                                 const VisibilityOptions& options)
{
    Key key;
    key.add(kCompiledLevelVersion);
    key.add(geometry_key);
    for (const auto& [id, object] : scene.hidden) key.add(id);
    key.add(level.structure.has_value());
    if (level.structure) {
        for (const std::string& glob : *level.structure) key.add_text(glob);
        for (const Node& node : scene.nodes) key.add_text(node.path);
        for (const Node& node : scene.nodes) key.add(node.parent);
    }
    key.add(options.max_structure_polygons);
    key.add(options.max_detail_polygons);
    key.add(options.least_area_share);
    key.add(options.max_clusters);
    key.add(options.max_cells);
    return key.value();
}

}  // namespace hw
