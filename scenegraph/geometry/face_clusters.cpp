// A cluster is front-facing as a whole when v . axis > sin(cone) |v| + r, where v goes from the middle of its ball to
// the eye, r is the ball's radius and the cone holds all normals: with f the angle of v above the plane across the
// axis, each normal makes sin(f - cone) >= sin f - sin(cone) with it, and each corner is at most r nearer. The same
// with the sign turned is back-facing. Unlike a test by angles this has no singularity at the middle of the ball; the
// form is that of meshoptimizer's documentation.
#include "geometry/face_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/box.hpp"
#include "geometry/surface_faces.hpp"

namespace hw {
namespace {

constexpr double kSineSlack = 8e-6;  // normals known to 1e-6, axis and products rounded to floats: under 4e-6 together
constexpr float kBallSlack = 4e-6f;  // the eye and the middle rounded to floats, in sizes of the mesh
constexpr double kSharpest = 1e-9;   // sine of a corner below which doubles do not tell a normal to 1e-6
constexpr float kNeverUniform = 4.0f;  // a sine that no cluster reaches

std::uint64_t spread(std::uint64_t x)
{
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

/// The unit normal, or zero where it is not known well enough.
glm::dvec3 sure_normal(const Surface& surface, std::uint32_t face)
{
    const auto& corners = surface.faces[face];
    const glm::dvec3 a = surface.positions[corners[0]];
    const glm::dvec3 p = glm::dvec3(surface.positions[corners[1]]) - a,
                     q = glm::dvec3(surface.positions[corners[2]]) - a;
    const glm::dvec3 normal = glm::cross(p, q);
    const double length = glm::length(normal);
    const bool is_sure = length > kSharpest * glm::length(p) * glm::length(q) && length > 1e-280;
    return is_sure ? normal / length : glm::dvec3(0.0);
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const glm::vec3> positions,
                                         std::span<const std::array<std::uint32_t, 3>> faces)
{
    Box box;
    for (const glm::vec3& p : positions) box.add(glm::dvec3(p));
    const glm::dvec3 size = box.size();
    const double largest = positions.empty() ? 1.0 : std::max({size.x, size.y, size.z, 1e-300});
    struct Place {
        std::uint64_t key;
        std::uint32_t face;
    };
    std::vector<Place> places(faces.size());
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
        const auto& [a, b, c] = faces[face];
        const glm::dvec3 centre =
            (glm::dvec3(positions[a]) + glm::dvec3(positions[b]) + glm::dvec3(positions[c])) / 3.0;
        const glm::dvec3 cell = (centre - box.min) / largest * 2097151.0;
        places[face] = {spread(static_cast<std::uint64_t>(cell.x)) | spread(static_cast<std::uint64_t>(cell.y)) << 1 |
                            spread(static_cast<std::uint64_t>(cell.z)) << 2,
                        face};
    }
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return a.key != b.key ? a.key < b.key : a.face < b.face; });
    std::vector<std::uint32_t> order(faces.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = places[i].face;
    return order;
}

void FaceClusters::prepare(const Surface& surface)
{
    count_ = static_cast<std::uint32_t>((surface.faces.size() + kFaces - 1) / kFaces);
    Box box;
    for (const glm::vec3& p : surface.positions) box.add(glm::dvec3(p));
    centre_ = box.centre();
    scale_ = 1.0 / std::max({box.size().x, box.size().y, box.size().z, 1e-300});
    bound_faces(surface, kFaces, cluster_bounds_);
    bound_faces(surface, kFaces * kGroup, group_bounds_);
    sort_edges(surface);
    link_groups();
}

void FaceClusters::bound_faces(const Surface& surface, std::uint32_t faces_each, Bounds& bounds) const
{
    const std::size_t face_count = surface.faces.size();
    for (auto& stream : bounds) stream.reserve(face_count / faces_each + 1);
    for (std::size_t begin = 0; begin < face_count; begin += faces_each) {
        const auto end = static_cast<std::uint32_t>(std::min(face_count, begin + faces_each));
        Box box;
        glm::dvec3 sum(0.0);
        bool is_sure = true;
        for (auto face = static_cast<std::uint32_t>(begin); face < end; ++face) {
            for (const std::uint32_t corner : surface.faces[face]) {
                box.add((glm::dvec3(surface.positions[corner]) - centre_) * scale_);
            }
            const glm::dvec3 normal = sure_normal(surface, face);
            is_sure = is_sure && normal != glm::dvec3(0.0);
            sum += normal;
        }
        is_sure = is_sure && glm::length(sum) > 1e-3;
        const glm::dvec3 axis = is_sure ? glm::normalize(sum) : glm::dvec3(0.0);
        double cosine = is_sure ? 1.0 : 0.0;
        for (auto face = static_cast<std::uint32_t>(begin); is_sure && face < end; ++face) {
            cosine = std::min(cosine, glm::dot(axis, sure_normal(surface, face)));
        }
        for (int i = 0; i < 3; ++i) {
            bounds[i].push_back(static_cast<float>(box.centre()[i]));
            bounds[4 + i].push_back(static_cast<float>(axis[i]));
        }
        bounds[3].push_back(static_cast<float>(0.5 * glm::length(box.size())) + kBallSlack);
        const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) + kSineSlack;
        bounds[7].push_back(cosine > 0.0 ? static_cast<float>(sine) : kNeverUniform);
    }
}

void FaceClusters::sort_edges(const Surface& surface)
{
    struct Placed {
        std::uint32_t from, to, edge;
    };
    std::vector<Placed> placed;
    const EdgeRange range = surface.edges.two_faced();
    for (std::uint32_t edge = range.begin; edge < range.end; ++edge) {
        const auto [a, b] = surface.edges.faces[edge];
        if (b >= surface.faces.size()) {
            loose_edges_.push_back(edge);
            continue;
        }
        placed.push_back({std::min(a, b) / kFaces, std::max(a, b) / kFaces, edge});
    }
    std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
        return a.from != b.from ? a.from < b.from : a.to != b.to ? a.to < b.to : a.edge < b.edge;
    });
    first_link_.assign(count_ + 1, 0);
    for (const Placed& p : placed) {
        const auto at = static_cast<std::uint32_t>(edges_.size());
        const bool continues = at > 0 && placed[at - 1].from == p.from && placed[at - 1].to == p.to;
        if (!continues) {
            links_.push_back({p.to, at, at});
            ++first_link_[p.from + 1];
        }
        const auto [a, b] = surface.edges.faces[p.edge];
        edges_.push_back(p.edge);
        edge_faces_.push_back(
            {static_cast<std::uint8_t>(std::min(a, b) % kFaces), static_cast<std::uint8_t>(std::max(a, b) % kFaces)});
        links_.back().end = at + 1;
    }
    for (std::size_t i = 1; i < first_link_.size(); ++i) first_link_[i] += first_link_[i - 1];
}

void FaceClusters::link_groups()
{
    first_group_link_.assign(1, 0);
    std::vector<std::uint32_t> others;
    for (std::uint32_t group = 0; group < group_count(); ++group) {
        others.clear();
        for (std::uint32_t cluster = group * kGroup; cluster < std::min(count_, (group + 1) * kGroup); ++cluster) {
            for (const Link& link : links(cluster)) others.push_back(link.other / kGroup);
        }
        std::sort(others.begin(), others.end());
        others.erase(std::unique(others.begin(), others.end()), others.end());
        std::erase(others, group);
        group_links_.insert(group_links_.end(), others.begin(), others.end());
        first_group_link_.push_back(static_cast<std::uint32_t>(group_links_.size()));
    }
}

std::size_t FaceClusters::bytes() const
{
    return 8 * (cluster_bounds_[0].size() + group_bounds_[0].size()) * sizeof(float) + links_.size() * sizeof(Link) +
           edge_faces_.size() * sizeof(edge_faces_[0]) +
           (edges_.size() + first_link_.size() + loose_edges_.size() + group_links_.size() + first_group_link_.size()) *
               sizeof(std::uint32_t);
}

/// The eye in the space of the bounds.
struct FaceClusters::Query {
    glm::vec3 eye;
    float weight;  ///< Of the balls; 0 for orthographic views.
    float slack;
};

void FaceClusters::decide_run(const Bounds& bounds, const Query& query, std::uint32_t begin, std::uint32_t end,
                              std::span<Facing> facing)
{
    for (std::uint32_t i = begin; i < end; ++i) {
        const float x = query.eye.x - query.weight * bounds[0][i], y = query.eye.y - query.weight * bounds[1][i],
                    z = query.eye.z - query.weight * bounds[2][i];
        const float along = x * bounds[4][i] + y * bounds[5][i] + z * bounds[6][i];
        const float beyond_ball = std::abs(along) - (query.weight * bounds[3][i] + query.slack);
        const float squared = bounds[7][i] * bounds[7][i] * (x * x + y * y + z * z);
        const bool is_uniform = beyond_ball > 0.0f && beyond_ball * beyond_ball > squared;
        facing[i] = !is_uniform ? Facing::mixed : along > 0.0f ? Facing::front : Facing::back;
    }
}

void FaceClusters::decide(const Viewpoint& viewpoint_object, std::span<Facing> groups, std::span<Facing> clusters) const
{
    const bool is_direction = viewpoint_object.is_orthographic;
    const glm::dvec3 eye = is_direction ? viewpoint_object.eye : (viewpoint_object.eye - centre_) * scale_;
    // A far eye is drawn in to where its rounding to floats is within the slack; all lengths shrink alike.
    const double distance = glm::length(eye);
    const double shrink = (is_direction || distance > 4.0) && distance > 0.0 ? 1.0 / distance : 1.0;
    const Query query{glm::vec3(eye * shrink), is_direction ? 0.0f : static_cast<float>(shrink),
                      is_direction ? 0.0f : kBallSlack};
    decide_run(group_bounds_, query, 0, group_count(), groups);
    for (std::uint32_t group = 0; group < group_count(); ++group) {
        const std::uint32_t begin = group * kGroup, end = std::min(count_, begin + kGroup);
        if (groups[group] == Facing::mixed) {
            decide_run(cluster_bounds_, query, begin, end, clusters);
        } else {
            std::fill(clusters.begin() + begin, clusters.begin() + end, groups[group]);
        }
    }
}

}  // namespace hw
