#include "hatchway/geometry/surface/inherited_planes.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <queue>

#include "hatchway/geometry/exact/predicates.hpp"

namespace hw {
namespace {

constexpr double kThinShare = 1e-3;
constexpr double kOpenSine = 0.05;
constexpr double kRounding = 0x1p-24;  // half a step of a float, relative

/// A way from a face with a plane over a side to one without.
struct Way {
    double length;  ///< Of the side, squared.
    std::uint32_t face;
    std::uint32_t source;
    int side;  ///< Of `face`.

    /// The longest first, then by number.
    bool operator<(const Way& other) const
    {
        if (length != other.length) return length < other.length;
        return face != other.face ? face > other.face : source > other.source;
    }
};

class PlaneInheritance {
 public:
    explicit PlaneInheritance(Surface& surface) : surface_(surface) {}

    /// Whether a face was turned over.
    bool run()
    {
        for (std::uint32_t face = 0; face < surface_.faces.size(); ++face)
            if (lacks_plane(face)) inherited().push_back({face, kNoFace});
        if (inherited().empty()) return false;
        const std::vector<DirectedEdge> uses = sorted_directed_edges(surface_.faces);
        neighbours_ = face_neighbours(surface_.faces.size(), uses);
        is_open_.assign(surface_.faces.size(), false);
        for (const auto& entry : inherited()) is_open_[entry.face] = true;
        for (const auto& entry : inherited()) add_ways_to(entry.face);
        while (!ways_.empty()) {
            const Way way = ways_.top();
            ways_.pop();
            if (is_open_[way.face]) settle(way);
        }
        return has_turned_;
    }

 private:
    std::vector<FacingFilter::Inherited>& inherited() { return surface_.filter.inherited; }

    bool lacks_plane(std::uint32_t face)
    {
        const auto& [a, b, c] = surface_.faces[face];
        const glm::vec3 &p = surface_.positions[a], &q = surface_.positions[b], &r = surface_.positions[c];
        if (surface_.face_triangle[face] == kNoFace) return true;
        const bool is_thin = is_needle(p, q, r);
        if (is_thin) ++(are_collinear(p, q, r) ? surface_.report.collinear_faces : surface_.report.needle_faces);
        return is_thin;
    }

    double side_length(std::uint32_t face, int side) const
    {
        const auto& corners = surface_.faces[face];
        const glm::dvec3 along =
            glm::dvec3(surface_.positions[corners[(side + 1) % 3]]) - glm::dvec3(surface_.positions[corners[side]]);
        return glm::dot(along, along);
    }

    void add_ways_to(std::uint32_t face)
    {
        for (int side = 0; side < 3; ++side) {
            const std::uint32_t source = neighbours_[face][side];
            if (source != kNoFace && !is_open_[source]) ways_.push({side_length(face, side), face, source, side});
        }
    }

    void settle(const Way& way)
    {
        is_open_[way.face] = false;
        const auto at = std::lower_bound(inherited().begin(), inherited().end(), way.face,
                                         [](const auto& entry, std::uint32_t face) { return entry.face < face; });
        at->source = way.source;
        wind_with_neighbour(way.face, way.side);
        for (int side = 0; side < 3; ++side) {
            const std::uint32_t next = neighbours_[way.face][side];
            if (next == kNoFace || !is_open_[next]) continue;
            const auto& beyond = neighbours_[next];
            const auto back = static_cast<int>(std::find(beyond.begin(), beyond.end(), way.face) - beyond.begin());
            ways_.push({side_length(way.face, side), next, way.source, back});
        }
    }

    /// What has no plane of its own has no front of its own.
    void wind_with_neighbour(std::uint32_t face, int side)
    {
        FaceCorners& corners = surface_.faces[face];
        const FaceCorners& other = surface_.faces[neighbours_[face][side]];
        bool is_against = false;
        for (int i = 0; i < 3; ++i)
            is_against |= other[i] == corners[side] && other[(i + 1) % 3] == corners[(side + 1) % 3];
        if (!is_against) return;
        std::swap(corners[1], corners[2]);
        std::swap(neighbours_[face][0], neighbours_[face][2]);
        has_turned_ = true;
    }

    Surface& surface_;
    std::vector<FaceCorners> neighbours_;
    std::vector<bool> is_open_;  ///< Has no plane yet.
    std::priority_queue<Way> ways_;
    bool has_turned_ = false;
};

}  // namespace

bool is_needle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 o(a), p = glm::dvec3(b) - o, q = glm::dvec3(c) - o, r = q - p;
    const glm::dvec3 normal = glm::cross(p, q);
    const double area = glm::length(normal);
    const double longest = std::max({glm::dot(p, p), glm::dot(q, q), glm::dot(r, r)});
    if (area > kThinShare * longest) return false;
    // How far each difference of corners may be off, and what that does to the normal.
    const glm::dvec3 off = 2.0 * kRounding * glm::dvec3(glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c))));
    const glm::dvec3 reach = glm::abs(p) + glm::abs(q);
    const glm::dvec3 open(off.y * reach.z + off.z * reach.y, off.z * reach.x + off.x * reach.z,
                          off.x * reach.y + off.y * reach.x);
    return glm::length(open) >= kOpenSine * area;
}

bool inherit_planes(Surface& surface)
{
    return PlaneInheritance(surface).run();
}

}  // namespace hw
