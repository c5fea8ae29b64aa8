#pragma once

#include <glm/geometric.hpp>

#include "hatchway/world/collision/collision.hpp"

namespace hw::test {

/// Builds collision worlds from a few solids.
class Solids {
 public:
    Solids& quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
    {
        MeshData& mesh = scene_.meshes.front();
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::dvec3& p : {a, b, c, d}) mesh.positions.emplace_back(p);
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
        return *this;
    }

    Solids& box(const glm::dvec3& low, const glm::dvec3& high)
    {
        const auto at = [&](int x, int y, int z) {
            return glm::dvec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
        };
        quad(at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0))
            .quad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
        quad(at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1))
            .quad(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
        quad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1))
            .quad(at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1));
        return *this;
    }

    /// A floor of 200 m at y = 0.
    Solids& floor() { return quad({-100, 0, -100}, {100, 0, -100}, {100, 0, 100}, {-100, 0, 100}); }

    /// A ramp that rises towards -z from z = 0, y = 0, `run` long, 10 m wide.
    Solids& ramp(double angle_deg, double run)
    {
        const double rise = run * std::tan(glm::radians(angle_deg));
        return quad({-5, 0, 0}, {5, 0, 0}, {5, rise, -run}, {-5, rise, -run});
    }

    /// Steps that rise towards -z from z = 0.
    Solids& stairs(int count, double rise, double tread)
    {
        for (int i = 0; i < count; ++i) box({-2, 0, -(i + 1) * tread}, {2, (i + 1) * rise, -i * tread});
        return *this;
    }

    CollisionWorld world() const { return build_collision_world(scene_, {}); }

 private:
    static Scene empty_scene()
    {
        Scene scene;
        scene.nodes.resize(1);
        scene.meshes.resize(1);
        scene.materials.resize(1);
        scene.objects = {{.node = 0, .mesh = 0, .material = 0}};
        return scene;
    }

    Scene scene_ = empty_scene();
};

}  // namespace hw::test
