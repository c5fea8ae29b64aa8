#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/world/light/lamp_choice.hpp"
#include "hatchway/world/scene.hpp"

namespace hw {

/// Where a ray meets a surface. Positions are relative to LightScene::origin_world(), metres.
struct LightHit {
    ObjectId object = 0;
    std::uint32_t triangle = 0;
    glm::vec3 barycentric{1.0f, 0.0f, 0.0f};
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< Unit, of the triangle, towards where the ray came from.
    bool is_back = false;                ///< Met from the side that is not drawn.
};

/// A triangle that shines.
struct Emitter {
    ObjectId object = 0;
    std::uint32_t triangle = 0;
    float power_so_far = 0.0f;  ///< Area times mean emission of this one and all before it.
};

/// The static surfaces of a scene that block and send back light: opaque or masked ones, neither animated nor unlit.
/// Rays are single precision around the middle of the scene; edges between triangles let nothing through. Thread safe.
/// The scene must outlive it.
class LightScene {
 public:
    /// `lights`: those of LightSources. What is closed around one, or around an eye, is a room (find_open_backs()).
    explicit LightScene(const Scene& scene, std::span<const Light> lights = {},
                        std::span<const glm::dvec3> eyes_world = {});
    ~LightScene();

    const glm::dvec3& origin_world() const { return origin_world_; }
    /// How far a ray starts off its surface.
    float clearance_m() const { return clearance_m_; }

    std::optional<LightHit> first_hit(const glm::vec3& from, const glm::vec3& direction) const;
    bool is_blocked(const glm::vec3& from, const glm::vec3& direction, float distance) const;

    /// Base colour with textures and vertex colours, linear, at most 0.98.
    glm::vec3 albedo(const LightHit& hit) const;
    /// Emission as the material states it, with its texture; zero behind a single-sided triangle.
    glm::vec3 emission(const LightHit& hit) const;

    /// Light reaches the backs of its faces (find_open_backs()).
    bool is_double_sided(ObjectId object) const;

    const LampChoice& lamps() const { return lamps_; }
    std::span<const Emitter> emitters() const { return emitters_; }
    /// Density over area with which a point of this object is chosen when emitters are chosen by power, 1/m^2.
    float emitter_density(ObjectId object) const;
    /// The point `share` (of area, in [0, 1)^2) of an emitter, seen from its front.
    LightHit point_of(const Emitter& emitter, const glm::vec2& share) const;

 private:
    struct Rays;  // Embree
    void add_emitters(ObjectId object);

    const Scene& scene_;
    std::vector<bool> open_backs_;  // of each object
    glm::dvec3 origin_world_{0.0};
    float clearance_m_ = 0.0f;
    LampChoice lamps_;
    std::vector<Emitter> emitters_;
    std::vector<float> mean_emission_;  // of each material, luminance
    std::unique_ptr<Rays> rays_;
};

/// Whether an object has baked light of its own: all but unlit ones. What moves gets that of the place where the model
/// has it.
bool receives_light(const Scene& scene, ObjectId object);

/// Whether light is blocked and sent back by an object that receives it: not by glass, nor by what moves.
bool blocks_light(const Scene& scene, ObjectId object);

}  // namespace hw
