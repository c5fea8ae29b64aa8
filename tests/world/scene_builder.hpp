#pragma once

#include <fmt/format.h>
#include <array>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/scene.hpp"
#include "hatchway/world/visibility/visibility.hpp"

namespace hw::test {

/// Makes scenes of quads and boxes. Each call is an object of its own, so that tests can ask for it by number.
class SceneBuilder {
 public:
    SceneBuilder()
    {
        scene_.materials.resize(4);
        scene_.materials[1].is_double_sided = true;
        scene_.materials[2].alpha_mode = AlphaMode::blend;
        scene_.materials[3].alpha_mode = AlphaMode::mask;
    }

    static constexpr int kSingle = 0, kDouble = 1, kBlend = 2, kMask = 3;

    /// Corners counter-clockwise seen from where it is drawn.
    ObjectId quad(const std::array<glm::dvec3, 4>& corners, int material = kSingle)
    {
        MeshData mesh;
        for (const glm::dvec3& corner : corners) mesh.positions.emplace_back(corner);
        mesh.indices = {0, 1, 2, 0, 2, 3};
        return add(std::move(mesh), material);
    }

    /// The six sides of a box, drawn from outside, or from inside: a room.
    ObjectId box(const glm::dvec3& min, const glm::dvec3& max, bool from_inside, int material = kSingle)
    {
        MeshData mesh;
        for (int i = 0; i < 8; ++i) {
            mesh.positions.emplace_back((i & 1) ? max.x : min.x, (i & 2) ? max.y : min.y, (i & 4) ? max.z : min.z);
        }
        mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                        2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
        if (from_inside) {
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
        }
        return add(std::move(mesh), material);
    }

    ObjectId add(MeshData mesh, int material)
    {
        Object object;
        object.node = static_cast<int>(scene_.nodes.size());
        object.mesh = static_cast<int>(scene_.meshes.size());
        object.material = material;
        for (const glm::vec3& position : mesh.positions) object.bounds_world.add(glm::dvec3(position));
        scene_.bounds_world.add(object.bounds_world);
        scene_.nodes.push_back({.name = "n", .path = fmt::format("n{}", object.node)});
        scene_.meshes.push_back(std::move(mesh));
        scene_.objects.push_back(object);
        return static_cast<ObjectId>(scene_.objects.size() - 1);
    }

    Scene& scene() { return scene_; }

 private:
    Scene scene_;
};

struct Compiled {
    std::vector<MeshChunks> chunks;
    Visibility visibility;

    bool sees(const glm::dvec3& eye, ObjectId object) const
    {
        std::vector<std::uint8_t> visible;
        visible_chunks(visibility, eye, 0.0, visible);
        for (std::uint32_t slot = visibility.first_slot_of_object[object];
             slot < visibility.first_slot_of_object[object + 1]; ++slot) {
            if (visible[slot]) return true;
        }
        return false;
    }
};

inline Compiled compile(Scene& scene, VisibilityOptions options = {}, const Level& level = {})
{
    Compiled result;
    for (MeshData& mesh : scene.meshes) result.chunks.push_back(split_into_chunks(mesh));
    result.visibility = build_visibility(scene, level, result.chunks, options);
    return result;
}

}  // namespace hw::test
