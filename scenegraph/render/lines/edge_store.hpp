#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "hatchway/render/lines/line_mesh.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// What an object's styles ask of its edges.
struct EdgeUse {
    bool is_used = false;
    float crease_rad = 0.0f;  ///< The smallest that they ask for.
    std::uint32_t style = 0;  ///< Objects of one style hide each other's seams.
    bool with_intersections = false;
};

/// Surfaces and lines of the objects whose styles draw edges; nothing for others. Surfaces belong to meshes and are
/// kept while the scene is.
class EdgeStore {
 public:
    /// Both must outlive the store.
    EdgeStore(const Scene& scene, LineIndices& indices);

    /// Builds what `uses` (one for each object) asks for and is not there yet. When it throws, all stays as it was.
    void prepare(std::span<const EdgeUse> uses);

    /// Null where prepare() was not asked for the object.
    const Surface* surface(ObjectId object) const;
    const LineMesh* lines(ObjectId object) const;
    const glm::dmat4& world_from_object(ObjectId object) const { return scene_.world_from_object(object); }

    int surfaces_built() const { return surfaces_built_; }
    int line_meshes_built() const { return line_meshes_built_; }

 private:
    struct MeshKey {
        int mesh;
        bool is_solid;
        auto operator<=>(const MeshKey&) const = default;
    };
    struct LineKey {
        MeshKey mesh;
        float crease_rad;
        auto operator<=>(const LineKey&) const = default;
    };
    struct ObjectEdges {
        const Surface* surface = nullptr;
        const LineMesh* lines = nullptr;
        std::unique_ptr<LineMesh> own_lines;  ///< Of an object with seams or intersections.
    };
    /// For each object, ends of its lines in object space.
    using Intersections = std::vector<std::vector<std::array<glm::vec3, 2>>>;

    MeshKey key_of(ObjectId object) const;
    const Surface& surface_of(const MeshKey& key);
    void find_edges(std::span<const EdgeUse> uses);
    void find_lines(std::span<const EdgeUse> uses);
    Intersections find_object_intersections(std::span<const EdgeUse> uses, std::span<const ObjectId> ids) const;
    void assign_lines(ObjectId object, const EdgeUse& use, const LineExtras& extras);

    const Scene& scene_;
    LineIndices& indices_;
    std::map<MeshKey, Surface> surfaces_;
    std::map<LineKey, LineMesh> shared_lines_;
    std::vector<ObjectEdges> objects_;
    int surfaces_built_ = 0;
    int line_meshes_built_ = 0;
};

}  // namespace hw
