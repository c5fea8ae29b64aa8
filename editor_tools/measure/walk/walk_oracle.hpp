#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/core/box.hpp"
#include "hatchway/world/level.hpp"
#include "hatchway/world/looks.hpp"

namespace hw::measure {

/// A walker's body as its judge knows it: a ball of `radius_m`, swept upright from the foot to the crown.
struct JudgedBody {
    double radius_m = 0.3;
    double height_m = 1.8;
    double step_m = 0.35;  ///< What the body may be lifted over in one go.
};

/// Says what a walker's body must not do: reach into drawn triangles, or pass through one. In double, on the triangles
/// as the model states them, and without any code of the walker: the distance from an upright segment to a triangle is
/// the minimum of convex pieces, not a sweep.
class WalkOracle {
 public:
    /// Takes static triangles of the objects whose look says that they collide (all, where `looks` is empty), without
    /// those that have no area.
    WalkOracle(const Scene& scene, std::span<const ObjectLook> looks);

    /// How deep the body with its foot at `foot` reaches into a triangle, metres; not above 0 where it reaches into
    /// none. The whole radius where the body's axis meets a triangle.
    double depth(const glm::dvec3& foot, const JudgedBody& body) const;

    /// The unit normal of a triangle that the body's axis, above a step's height, passes on the straight way between
    /// two places of the foot. A body that cannot pass through things never does on a way shorter than its diameter:
    /// all along it the axis would have to be a radius away. None while the axis already stands in a triangle: a fall
    /// through a floor is one crossing, however many looks it takes.
    std::optional<glm::dvec3> crossed(const glm::dvec3& from, const glm::dvec3& to, const JudgedBody& body) const;

    /// Whether a triangle lies on the open segment between the two points.
    bool is_parted(const glm::dvec3& from, const glm::dvec3& to) const;

    /// Whether anything lies straight below.
    bool has_ground_below(const glm::dvec3& point) const;

    /// Up to `count` places of the foot, all over the model, where a visitor could be: on a face that is drawn from
    /// above and not too steep, free for the body, not within a solid, and with a clear view for 1.5 m to half of all
    /// sides. The same ones for the same seed.
    std::vector<glm::dvec3> standing_places(const JudgedBody& body, std::size_t count, std::uint32_t seed) const;

    const Box& bounds() const { return bounds_; }

 private:
    struct Triangle {
        glm::dvec3 a{0.0}, b{0.0}, c{0.0};
        bool is_double_sided = false;
    };
    struct Node {
        Box bounds;
        std::uint32_t first = 0, last = 0;  ///< Triangles.
        std::uint32_t second_child = 0;     ///< 0: a leaf. The first child is next.
    };
    struct Hit {
        double share = 1.0;  ///< Of the segment.
        double normal_y = 0.0;
        bool is_back = false;
    };

    void add_object(const Scene& scene, ObjectId id);
    void build(std::uint32_t first, std::uint32_t last);
    template <typename Visit>
    void visit(const Box& box, Visit&& visit) const;
    std::vector<Hit> hits(const glm::dvec3& from, const glm::dvec3& to) const;
    bool is_open_place(const glm::dvec3& foot, const JudgedBody& body) const;

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
    Box bounds_;
};

}  // namespace hw::measure
