#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "hatchway/geometry/mesh_chunks.hpp"
#include "hatchway/world/scene.hpp"

namespace hw::measure {

/// A drawn triangle in world space, counter-clockwise seen from where it is drawn.
struct SightTriangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0};
    std::uint32_t slot = 0;  ///< Objects in order, then their chunks.
    bool is_double_sided = false;
    bool blocks = false;  ///< Opaque and static; others are seen but do not hide.
};

/// The drawn triangles of a scene as the model states them, not snapped; triangles without area are left out.
std::vector<SightTriangle> sight_triangles(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh);

/// What a ray meets: every triangle that it enters from a drawn side until the first that blocks, in no order.
/// Rays are traced by Embree in float: it may miss at an edge, so a claim is confirmed by is_seen_exactly().
class SightRays {
 public:
    explicit SightRays(std::span<const SightTriangle> triangles);
    ~SightRays();
    SightRays(const SightRays&) = delete;
    SightRays& operator=(const SightRays&) = delete;

    /// Numbers of the triangles. Thread safe.
    void trace(const glm::dvec3& origin, const glm::dvec3& direction, std::vector<std::uint32_t>& met) const;

 private:
    struct Embree;
    std::span<const SightTriangle> triangles_;
    Embree* embree_;
};

/// Whether the ray from `origin` along `direction` enters triangle `target` strictly inside, from a drawn side, before
/// it touches any triangle that blocks from the side it comes from. Rational arithmetic: no rounding anywhere.
bool is_seen_exactly(std::span<const SightTriangle> triangles, const glm::dvec3& origin, const glm::dvec3& direction,
                     std::uint32_t target);

}  // namespace hw::measure
