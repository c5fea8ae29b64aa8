#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/world/scene.hpp"

namespace hw {

/// Where the judge looks from: a pinhole, +y up before it is turned.
struct JudgeCamera {
    glm::dvec3 eye_world{0.0};
    glm::dvec3 target_world{0.0, 0.0, -1.0};
    double fov_rad = 1.0;  ///< Vertical.
    glm::ivec2 size_px{1280, 720};
    double near_m = 0.01;
    double roll_rad = 0.0;  ///< Counter-clockwise as it looks.
};

/// A judge's camera as a projection. Ways go from the eye.
struct Pinhole {
    explicit Pinhole(const JudgeCamera& camera);

    double depth(const glm::dvec3& way) const;
    glm::dvec2 project(const glm::dvec3& way) const;
    glm::dvec3 ray(const glm::dvec2& at_px) const;  ///< Of unit length.
    bool holds(const glm::dvec2& at_px) const;      ///< Whether it lies in the picture.

    glm::dvec3 forward, right, up;
    double focal_px;
    glm::ivec2 size_px;
    double near_m;
};

/// A triangle in world space that hides what lies behind it, or, where it is culled, does so from its front alone.
struct HidingTriangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0};
    bool is_culled = false;
};

/// All triangles of a scene but those of blended materials.
std::vector<HidingTriangle> hiding_triangles(const Scene& scene);

struct Hit {
    double share = 1.0;  ///< Of the ray's given length.
    glm::dvec3 normal{0.0};
};

/// Rays from one eye to the triangles around it, by Embree.
class EyeRays {
 public:
    EyeRays(std::span<const HidingTriangle> triangles, const glm::dvec3& eye);
    ~EyeRays();

    /// The first triangle on the way from the eye, not beyond `most` of it.
    std::optional<Hit> first(const glm::dvec3& way, double most) const;
    std::uint64_t count() const { return count_; }

 private:
    struct Device;
    std::unique_ptr<Device> device_;
    mutable std::uint64_t count_ = 0;
};

}  // namespace hw
