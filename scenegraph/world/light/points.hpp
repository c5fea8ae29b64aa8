#pragma once

#include <cstdint>
#include <vector>

#include "hatchway/world/light/lightmap.hpp"
#include "hatchway/world/light/transport.hpp"

namespace hw {

/// One luxel that receives light: of a chart, or of a vertex.
struct Luxel {
    ObjectId object = 0;
    std::uint32_t place = 0;  ///< Index into Lightmap::luxels.
    std::uint32_t chart = 0;  ///< Charts are numbered over the whole lightmap; vertices of one object share one.
    glm::ivec2 at{0};         ///< In the mesh's rectangle; per vertex: x is the vertex.
    bool is_back = false;
};

/// A luxel with the place of the surface that it stands for.
struct LuxelPlace {
    glm::ivec2 mirrored{0};  ///< From a luxel outside of its chart to the one as far inside, across the chart's edge.
    LightReceiver receiver;  ///< A point of the drawn surface near the luxel's middle.
    bool is_buried = true;   ///< No part of the luxel lies in the open: inside of a solid.
    bool is_near_wall = false;  ///< Something stands so near that parts of the luxel may lie behind it.
};

/// Finds where luxels lie on surfaces. Thread safe once made.
class LuxelPoints {
 public:
    LuxelPoints(const Scene& scene, const Lightmap& lightmap, const LightScene& light_scene);
    ~LuxelPoints();

    /// All luxels that lie on a surface or touch one, object after object.
    const std::vector<Luxel>& luxels() const { return luxels_; }
    /// For each object whether its luxels lie in charts.
    std::vector<bool> charted_objects() const;
    /// The place of a luxel: its middle, or another of its points where the middle lies in a solid.
    LuxelPlace place(const Luxel& luxel) const;
    /// Another point of the luxel, `share` in [0, 1)^2 of it, as far as it is in sight of `place`; else that itself.
    LightReceiver part(const Luxel& luxel, const LuxelPlace& place, const glm::vec2& share) const;
    /// Whether something stands between two luxels' places.
    bool are_parted(const LuxelPlace& a, const LuxelPlace& b) const;

 private:
    struct MeshLuxels;  // of one mesh, shared by its instances
    struct Instance;
    LightReceiver receiver(const Luxel& luxel, const glm::vec2& share) const;
    glm::vec2 nearest_on_chart(const Luxel& luxel, const glm::vec2& wanted, std::uint32_t& triangle) const;
    LightReceiver vertex_receiver(const Luxel& luxel, const glm::vec2& share) const;
    LightReceiver receiver_at(const Luxel& luxel, std::uint32_t triangle, const glm::vec3& barycentric) const;
    glm::vec3 lifted(const LightReceiver& receiver) const;
    bool has_wall_near(const LightReceiver& receiver) const;
    bool is_buried(const LightReceiver& receiver, std::uint32_t seed) const;

    void add_luxels(ObjectId object, bool is_back, std::uint32_t first_chart);

    const Scene& scene_;
    const Lightmap& lightmap_;
    const LightScene& light_scene_;
    float luxel_m_ = 0.0f;
    std::vector<Luxel> luxels_;
    std::vector<MeshLuxels> meshes_;
    std::vector<Instance> instances_;
};

}  // namespace hw
