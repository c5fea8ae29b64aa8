#include "hatchway/geometry/topology/doubled_patches.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

namespace hw {
namespace {

constexpr double kMostBent = 0.15;     // depth of a bent patch relative to the root of its area
constexpr double kLeastAligned = 0.7;  // cosine between a face of a bent patch and the whole
constexpr double kPlaceError = 1e-6;   // of floats, relative to the size of a patch
constexpr double kInPlane = 0.99;      // cosine between a face of a large patch and the whole
constexpr std::size_t kMostBentFaces = 16;
constexpr std::size_t kMostUses = 64;       // of an edge
constexpr std::size_t kMostFaces = 1024;    // of a patch
constexpr std::uint32_t kFewestShared = 2;  // edges of a bent patch where it hangs on others
constexpr std::uint32_t kNoPatch = kNoFace;

/// Beyond a side, over an edge of exactly two faces.
struct Neighbour {
    std::uint32_t face = kNoFace;
    bool is_against = false;  ///< Winds against this one.
};

struct Patch {
    std::vector<std::uint32_t> faces;
    std::vector<std::uint64_t> border;  ///< Its edges, rising.
    std::uint32_t first_triangle = kNoFace;
    std::uint32_t shared_edges = 0;  ///< Of the border, of three faces or more.
    glm::dvec3 area{0.0};            ///< Along the normal.
};

class PatchSearch {
 public:
    PatchSearch(std::span<const glm::vec3> positions, std::span<const FaceCorners> faces,
                std::span<const DirectedEdge> uses, std::span<const std::uint32_t> face_triangle, double tolerance)
        : positions_(positions), faces_(faces), uses_(uses), face_triangle_(face_triangle), tolerance_(tolerance)
    {
        for_each_edge(uses, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() > 2 && edge.size() <= kMostUses) add_seeds(edge);
        });
    }

    DoubledFaces run()
    {
        if (seeds_.empty()) return {};
        patch_of_.assign(faces_.size(), kNoPatch);
        is_turned_.assign(faces_.size(), false);
        for (const std::uint32_t seed : seeds_) {
            if (patch_of_[seed] != kNoPatch) continue;
            std::optional<Patch> patch = patch_from(seed);
            if (patch) with_border_[patch->border].push_back(std::move(*patch));
        }
        DoubledFaces doubled;
        for (auto& [border, patches] : with_border_) {
            if (patches.size() < 2) continue;
            const auto is_before = [](const Patch& a, const Patch& b) { return a.first_triangle < b.first_triangle; };
            std::sort(patches.begin(), patches.end(), is_before);
            for (std::size_t i = 1; i < patches.size(); ++i)
                if (is_one_sheet(patches[0], patches[i])) drop(doubled, patches[0], patches[i]);
        }
        return doubled;
    }

 private:
    glm::dvec3 place(std::uint32_t position) const { return glm::dvec3(positions_[position]); }
    /// Faces that lie nearly on another of the edge's.
    void add_seeds(std::span<const DirectedEdge> edge)
    {
        const glm::dvec3 from = place(edge[0].low), along = glm::normalize(place(edge[0].high) - from);
        std::vector<glm::dvec3> across;
        for (const DirectedEdge& use : edge) {
            const glm::dvec3 apex = place(faces_[use.face][(use.corner + 2) % 3]) - from;
            across.push_back(apex - glm::dot(apex, along) * along);
        }
        for (std::size_t i = 0; i < edge.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const double lengths = glm::length(across[i]) * glm::length(across[k]);
                if (glm::dot(across[i], across[k]) < kLeastAligned * lengths) continue;
                seeds_.push_back(edge[i].face);
                seeds_.push_back(edge[k].face);
            }
    }

    /// Along the normal that its winding gives.
    glm::dvec3 wound_area(std::uint32_t face) const
    {
        const auto& [a, b, c] = faces_[face];
        return 0.5 * glm::cross(place(b) - place(a), place(c) - place(a));
    }
    /// ... that the winding of its patch gives.
    glm::dvec3 area_of(std::uint32_t face) const { return is_turned_[face] ? -wound_area(face) : wound_area(face); }

    /// Whether the face beyond goes on where this one ends. Faces without area go on anywhere.
    bool goes_on(std::uint32_t face, const Neighbour& other) const
    {
        if (other.face == kNoFace) return false;
        const double along = glm::dot(wound_area(face), wound_area(other.face));
        return along == 0.0 || (along > 0.0) != other.is_against;
    }

    /// Looked up, since few faces are asked.
    std::span<const DirectedEdge> uses_of(std::uint32_t a, std::uint32_t b) const
    {
        const auto is_before = [](const DirectedEdge& x, const DirectedEdge& y) {
            return x.low != y.low ? x.low < y.low : x.high < y.high;
        };
        const DirectedEdge wanted{std::min(a, b), std::max(a, b), 0, 0, false};
        const auto [begin, end] = std::equal_range(uses_.begin(), uses_.end(), wanted, is_before);
        return {begin, end};
    }
    static Neighbour beyond(std::span<const DirectedEdge> edge, std::uint32_t face)
    {
        if (edge.size() != 2) return {};
        return {edge[edge[0].face == face ? 1 : 0].face, edge[0].is_forward == edge[1].is_forward};
    }

    /// Nothing where it is no sheet, or a large one.
    std::optional<Patch> patch_from(std::uint32_t seed)
    {
        Patch patch;
        patch_of_[seed] = seed;
        patch.faces.push_back(seed);
        for (std::size_t next = 0; next < patch.faces.size(); ++next) {
            const std::uint32_t face = patch.faces[next];
            patch.first_triangle = std::min(patch.first_triangle, face_triangle_[face]);
            patch.area += area_of(face);
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t from = faces_[face][corner], to = faces_[face][(corner + 1) % 3];
                const std::span<const DirectedEdge> edge = uses_of(from, to);
                const Neighbour other = beyond(edge, face);
                if (!goes_on(face, other)) {
                    patch.border.push_back(key_of(from, to));
                    patch.shared_edges += edge.size() > 2;
                } else if (patch_of_[other.face] == kNoPatch) {
                    patch_of_[other.face] = seed;
                    is_turned_[other.face] = is_turned_[face] != other.is_against;
                    patch.faces.push_back(other.face);
                } else if (patch_of_[other.face] != seed) {
                    return std::nullopt;  // goes on in one that was left
                }
            }
            if (patch.faces.size() > kMostBentFaces && (patch.faces.size() > kMostFaces || turns_away(face, patch)))
                return std::nullopt;
        }
        std::sort(patch.border.begin(), patch.border.end());
        if (std::adjacent_find(patch.border.begin(), patch.border.end()) != patch.border.end()) return std::nullopt;
        return patch;
    }

    bool turns_away(std::uint32_t face, const Patch& patch) const
    {
        const glm::dvec3 own = area_of(face);
        const double whole = glm::length(patch.area);
        return glm::dot(own, patch.area) < kInPlane * glm::length(own) * whole - kPlaceError * whole * whole;
    }

    static std::uint64_t key_of(std::uint32_t a, std::uint32_t b)
    {
        return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
    }

    bool is_one_sheet(const Patch& a, const Patch& b) const
    {
        const double area = glm::length(a.area);
        if (!(area > 0.0)) return false;
        const glm::dvec3 normal = a.area / area;
        const double size = std::sqrt(area);
        const glm::dvec3 middle = middle_of(a);
        const auto is_flat = [&](const Patch& patch, double depth, double cosine) {
            const double side = glm::dot(patch.area, normal) < 0.0 ? -1.0 : 1.0;
            return std::all_of(patch.faces.begin(), patch.faces.end(), [&](std::uint32_t face) {
                const glm::dvec3 own = area_of(face);
                if (side * glm::dot(own, normal) < cosine * glm::length(own) - kPlaceError * area) return false;
                return std::all_of(faces_[face].begin(), faces_[face].end(), [&](std::uint32_t corner) {
                    return std::abs(glm::dot(place(corner) - middle, normal)) <= depth;
                });
            });
        };
        const double in_plane = std::max(tolerance_, kPlaceError * size);
        if (is_flat(a, in_plane, 0.0) && is_flat(b, in_plane, 0.0)) return true;
        if (std::min(a.shared_edges, b.shared_edges) < kFewestShared) return false;
        return are_all_on_border(a) && are_all_on_border(b) && is_flat(a, kMostBent * size, kLeastAligned) &&
               is_flat(b, kMostBent * size, kLeastAligned);
    }

    glm::dvec3 middle_of(const Patch& patch) const
    {
        glm::dvec3 sum(0.0);
        for (const std::uint32_t face : patch.faces)
            for (const std::uint32_t corner : faces_[face]) sum += place(corner);
        return sum / (3.0 * static_cast<double>(patch.faces.size()));
    }

    /// As in a polygon without holes: two triangles fewer than edges.
    static bool are_all_on_border(const Patch& patch) { return patch.faces.size() + 2 == patch.border.size(); }

    /// Along the normal that most of it winds to.
    glm::dvec3 wound_area(const Patch& patch) const
    {
        glm::dvec3 sum(0.0);
        for (const std::uint32_t face : patch.faces) sum += wound_area(face);
        return sum;
    }

    void drop(DoubledFaces& doubled, const Patch& kept, const Patch& other) const
    {
        if (doubled.is_dropped.empty()) {
            doubled.is_dropped.resize(faces_.size(), false);
            doubled.is_two_sided.resize(faces_.size(), false);
        }
        for (const std::uint32_t face : other.faces) doubled.is_dropped[face] = true;
        if (glm::dot(wound_area(kept), wound_area(other)) > 0.0) return;
        for (const std::uint32_t face : kept.faces) doubled.is_two_sided[face] = true;
    }

    std::span<const glm::vec3> positions_;
    std::span<const FaceCorners> faces_;
    std::span<const DirectedEdge> uses_;
    std::span<const std::uint32_t> face_triangle_;
    double tolerance_;
    std::vector<std::uint32_t> seeds_;
    std::vector<std::uint32_t> patch_of_;
    std::vector<bool> is_turned_;  ///< Winds against the first face of its patch.
    std::map<std::vector<std::uint64_t>, std::vector<Patch>> with_border_;
};

}  // namespace

DoubledFaces find_doubled_patches(std::span<const glm::vec3> positions, std::span<const FaceCorners> faces,
                                  std::span<const DirectedEdge> uses, std::span<const std::uint32_t> face_triangle,
                                  float tolerance)
{
    return PatchSearch(positions, faces, uses, face_triangle, tolerance).run();
}

}  // namespace hw
