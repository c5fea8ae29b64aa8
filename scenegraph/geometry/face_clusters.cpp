// A cluster is front-facing as a whole when v . axis cos(cone) - h > sin(cone) |v - (v . axis) axis|, where v goes from
// the cluster's centre to the eye, the cone around the axis holds all normals, and h is how far the centre is from the
// plane of any face: with f the angle of v above the plane across the axis, each normal n has n . v >= |v| sin(f -
// cone), and the eye's distance from the plane of n is at least h less. Both sides squared need no root. The same with
// the sign turned is back-facing. The planes of a smooth piece of surface pass much closer to its centre than its
// corners are, so that h is far smaller than the ball that other cone tests take. The test has no singularity at the
// centre.
#include "geometry/face_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/box.hpp"
#include "geometry/surface_faces.hpp"

namespace hw {
namespace {

constexpr double kSineSlack = 8e-6;   // normals known to 1e-6, axis and products rounded to floats: under 4e-6 together
constexpr float kPlaceSlack = 1e-5f;  // the eye, the centre and the sums rounded to floats, in sizes of the mesh
constexpr float kSquareSlack = 2e-5f;  // the same for the difference of squares
constexpr double kSharpest = 1e-9;     // sine of a corner below which doubles do not tell a normal to 1e-6
constexpr float kNeverUniform = 1e9f;  // a squared sine that no cluster reaches

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
        double cosine = is_sure ? 1.0 : 0.0, height = 0.0;
        for (auto face = static_cast<std::uint32_t>(begin); is_sure && face < end; ++face) {
            const glm::dvec3 normal = sure_normal(surface, face);
            const glm::dvec3 corner = (glm::dvec3(surface.positions[surface.faces[face][0]]) - centre_) * scale_;
            cosine = std::min(cosine, glm::dot(axis, normal));
            height = std::max(height, std::abs(glm::dot(normal, corner - box.centre())));
        }
        const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) + kSineSlack;
        for (int i = 0; i < 3; ++i) {
            bounds[i].push_back(static_cast<float>(box.centre()[i]));
            bounds[4 + i].push_back(static_cast<float>(axis[i] * std::max(cosine - kSineSlack, 0.0)));
        }
        bounds[3].push_back(static_cast<float>(height) + kPlaceSlack);
        bounds[7].push_back(cosine > 0.0 ? static_cast<float>(sine * sine) : kNeverUniform);
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
    first_link_.assign(group_count() + 1, 0);
    for (const Placed& p : placed) {
        const auto at = static_cast<std::uint32_t>(edges_.size());
        const bool continues = at > 0 && placed[at - 1].from == p.from && placed[at - 1].to == p.to;
        if (!continues) {
            links_.push_back({{p.from, p.to}, at});
            ++first_link_[p.from / kGroup + 1];
        }
        const auto [a, b] = surface.edges.faces[p.edge];
        edges_.push_back(p.edge);
        edge_faces_.push_back(
            {static_cast<std::uint8_t>(std::min(a, b) % kFaces), static_cast<std::uint8_t>(std::max(a, b) % kFaces)});
    }
    links_.push_back({{0, 0}, static_cast<std::uint32_t>(edges_.size())});
    edge_faces_.resize(edge_faces_.size() + 8);
    for (std::size_t i = 1; i < first_link_.size(); ++i) first_link_[i] += first_link_[i - 1];
}

void FaceClusters::link_groups()
{
    first_group_link_.assign(1, 0);
    std::vector<std::uint32_t> others;
    for (std::uint32_t group = 0; group < group_count(); ++group) {
        others.clear();
        for (std::uint32_t i = first_link_[group]; i < first_link_[group + 1]; ++i) {
            others.push_back(links_[i].clusters[1] / kGroup);
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
    float weight;  ///< Of places; 0 for orthographic views.
    float slack;
};

namespace {

/// Cones against the eye (w: weight of places): 1 front, 0 back, 2 not decided. Without branches, so that
/// eight are decided at a time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("avx2", "default")))
#endif
void decide_each(const std::array<const float*, 8>& bounds, const glm::vec4& eye, float slack, std::uint32_t count,
                 std::uint8_t* __restrict facing)
{
    for (std::uint32_t i = 0; i < count; ++i) {
        const float x = eye.x - eye.w * bounds[0][i], y = eye.y - eye.w * bounds[1][i],
                    z = eye.z - eye.w * bounds[2][i];
        const float along = x * bounds[4][i] + y * bounds[5][i] + z * bounds[6][i];
        const float above = std::abs(along) - (eye.w * bounds[3][i] + slack);
        const float aside = bounds[7][i] * (x * x + y * y + z * z - along * along + kSquareSlack);
        const bool is_uniform = (above > 0.0f) & (above * above > aside);
        facing[i] = is_uniform ? static_cast<std::uint8_t>(along > 0.0f) : std::uint8_t{2};
    }
}

}  // namespace

void FaceClusters::decide_run(const Bounds& bounds, const Query& query, std::uint32_t begin, std::uint32_t end,
                              Facing* facing)
{
    std::array<const float*, 8> streams;
    for (int i = 0; i < 8; ++i) streams[i] = bounds[i].data() + begin;
    static_assert(static_cast<int>(Facing::front) == 1 && static_cast<int>(Facing::mixed) == 2);
    decide_each(streams, glm::vec4(query.eye, query.weight), query.slack, end - begin,
                reinterpret_cast<std::uint8_t*>(facing));
}

std::uint32_t FaceClusters::decide(const Viewpoint& viewpoint_object, std::span<Facing> groups,
                                   std::span<std::uint32_t> masks, std::span<std::uint32_t> mixed) const
{
    const bool is_direction = viewpoint_object.is_orthographic;
    const glm::dvec3 eye = is_direction ? viewpoint_object.eye : (viewpoint_object.eye - centre_) * scale_;
    // A far eye is drawn in to where its rounding to floats is within the slack; all lengths shrink alike.
    const double distance = glm::length(eye);
    const double shrink = (is_direction || distance > 4.0) && distance > 0.0 ? 1.0 / distance : 1.0;
    const Query query{glm::vec3(eye * shrink), is_direction ? 0.0f : static_cast<float>(shrink),
                      is_direction ? 0.0f : kPlaceSlack};
    decide_run(group_bounds_, query, 0, group_count(), groups.data());
    std::uint32_t mixed_count = 0;
    for (std::uint32_t group = 0; group < group_count(); ++group) {
        const std::uint32_t begin = group * kGroup, size = std::min(count_ - begin, kGroup);
        std::array<Facing, kGroup> facing;
        facing.fill(groups[group]);
        if (groups[group] == Facing::mixed) decide_run(cluster_bounds_, query, begin, begin + size, facing.data());
        for (std::uint32_t i = 0; i < size; ++i) {
            masks[begin + i] = facing[i] == Facing::front ? ~0u : 0u;
            mixed[mixed_count] = begin + i;
            mixed_count += facing[i] == Facing::mixed;
        }
    }
    return mixed_count;
}

}  // namespace hw
