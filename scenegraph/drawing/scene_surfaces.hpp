#pragma once

#include <map>
#include <span>

#include "hatchway/geometry/surface/angle_change.hpp"
#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// The adjacency of a scene's meshes, made when it is asked for and kept. A mesh is solid where the object that shows
/// it is opaque and single-sided; a mesh that is shown both ways has two surfaces, and one more for each way in which
/// nodes scale it unevenly: folds are angles in the world.
class SceneSurfaces {
 public:
    struct Key {
        int mesh = 0;
        bool is_solid = true;
        AngleChange scaled;
        auto operator<=>(const Key&) const = default;
    };

    /// `scene` must outlive this. What `options` say about solid meshes and the world is ignored.
    explicit SceneSurfaces(const Scene& scene, const SurfaceOptions& options = {}) : scene_(scene), options_(options) {}

    Key key_of(ObjectId object) const;
    /// Stays where it is as long as this lives.
    const Surface& of(ObjectId object);
    /// Makes what of() would, on all threads and with a progress bar.
    void build(std::span<const ObjectId> objects);
    /// Null where neither was called for its mesh.
    const Surface* find(ObjectId object) const;
    /// Faces of the object that look away from the eye are not drawn.
    bool is_culled(ObjectId object) const;

    const std::map<Key, Surface>& all() const { return surfaces_; }

 private:
    Surface made(const Key& key, ObjectId object) const;
    const Material& material(ObjectId object) const { return scene_.materials[scene_.objects[object].material]; }

    const Scene& scene_;
    SurfaceOptions options_;
    std::map<Key, Surface> surfaces_;
};

}  // namespace hw
