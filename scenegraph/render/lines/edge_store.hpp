#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "hatchway/drawing/line_extras.hpp"
#include "hatchway/geometry/silhouettes/silhouettes.hpp"
#include "hatchway/render/lines/line_mesh.hpp"

namespace hw {

/// Surfaces and lines of the objects whose styles draw edges; nothing for others. Surfaces belong to meshes and are
/// kept while the scene is.
class EdgeStore {
 public:
    /// Both must outlive the store.
    EdgeStore(const Scene& scene, LineIndices& indices);

    /// Builds what `demands` (one for each object) asks for and is not there yet. When it throws, all stays as it was.
    void prepare(std::span<const EdgeDemand> demands);

    /// Null where prepare() was not asked for the object.
    const Surface* surface(ObjectId object) const { return objects_[object].surface; }
    /// The lines at a crease angle; null where prepare() was not asked for it.
    const LineMesh* lines(ObjectId object, float crease_rad) const;
    /// Of an object's lines, object space; 0 where there are none. Of several crease angles that with the longest
    /// lines.
    double line_length(ObjectId object) const;
    const glm::dmat4& world_from_object(ObjectId object) const { return scene_.world_from_object(object); }

    int surfaces_built() const { return static_cast<int>(surfaces_.all().size()); }
    int line_meshes_built() const { return line_meshes_built_; }

 private:
    struct Key {
        SceneSurfaces::Key surface;
        bool is_culled;
        float crease_rad;
        auto operator<=>(const Key&) const = default;
    };
    struct ObjectMeshes {
        const Surface* surface = nullptr;
        std::vector<std::pair<float, const LineMesh*>> lines;  ///< By crease angle.
        std::vector<std::unique_ptr<LineMesh>> own;            ///< Of an object with seams or intersections.
    };

    /// A line mesh that is not there yet.
    struct Job {
        ObjectId object = 0;
        float crease_rad = 0.0f;
        const ObjectExtras& extras;
        std::unique_ptr<LineMesh> mesh;
    };

    Key key_of(ObjectId object, float crease_rad) const;
    std::vector<Job> jobs_of(std::span<const EdgeDemand> demands, const LineExtras& extras) const;
    void run(std::span<Job> jobs);
    std::vector<ObjectMeshes> meshes_of(std::span<const EdgeDemand> demands, const LineExtras& extras,
                                        std::span<Job> done);

    const Scene& scene_;
    LineIndices& indices_;
    SceneSurfaces surfaces_;
    std::map<Key, std::unique_ptr<LineMesh>> shared_lines_;
    std::vector<ObjectMeshes> objects_;
    int line_meshes_built_ = 0;
};

}  // namespace hw
