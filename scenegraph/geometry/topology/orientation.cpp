#include "hatchway/geometry/topology/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace hw {
namespace {

constexpr double kEven = 1e-6;  // of two halves, relative

/// What a component's spanning tree says, and how well flipping the faces works that disagree with its first.
struct Component {
    std::vector<std::uint32_t> faces;
    bool has_border = false;
    std::uint32_t inconsistent_before = 0;  // counted once from each side
    std::uint32_t inconsistent_after = 0;
};

class WindingWalk {
 public:
    WindingWalk(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                std::span<const DirectedEdge> uses)
        : positions_(positions), faces_(faces), beyond_(faces.size(), Beyond{}), is_opposed_(faces.size(), false)
    {
        repair_.face_component.assign(faces.size(), kNoFace);
        for_each_edge(uses, [&](std::span<const DirectedEdge> edge) {
            if (edge.size() != 2) return;
            const bool is_against = edge[0].is_forward == edge[1].is_forward;
            for (int i = 0; i < 2; ++i) beyond_[edge[i].face][edge[i].corner] = {edge[1 - i].face, is_against};
        });
    }

    WindingRepair run()
    {
        for (std::uint32_t face = 0; face < faces_.size(); ++face) {
            if (repair_.face_component[face] != kNoFace) continue;
            const Component component = walk_from(face);
            flip_minority(component);
            ++repair_.component_count;
        }
        std::sort(repair_.flipped_faces.begin(), repair_.flipped_faces.end());
        return std::move(repair_);
    }

 private:
    /// The face beyond a side, over an edge of exactly two faces, and whether it winds against this one.
    struct Neighbour {
        std::uint32_t face = kNoFace;
        bool is_against = false;
    };
    using Beyond = std::array<Neighbour, 3>;

    Component walk_from(std::uint32_t seed)
    {
        Component component;
        component.faces.push_back(seed);
        repair_.face_component[seed] = repair_.component_count;
        for (std::size_t next = 0; next < component.faces.size(); ++next) {
            const std::uint32_t face = component.faces[next];
            for (const auto& [other, against] : beyond_[face]) {
                component.has_border |= other == kNoFace;
                if (other == kNoFace) continue;
                if (repair_.face_component[other] == kNoFace) {
                    repair_.face_component[other] = repair_.component_count;
                    is_opposed_[other] = is_opposed_[face] != against;
                    component.faces.push_back(other);
                }
                component.inconsistent_before += against;
                component.inconsistent_after += (is_opposed_[face] != is_opposed_[other]) != against;
            }
        }
        return component;
    }

    void flip_minority(const Component& component)
    {
        if (component.inconsistent_after >= component.inconsistent_before) return;
        std::array<double, 2> area{};  // of faces that agree with the first, of faces that do not
        for (const std::uint32_t face : component.faces) area[is_opposed_[face]] += area_of(face);
        const bool is_even = std::abs(area[0] - area[1]) <= kEven * (area[0] + area[1]);
        const bool flip_opposed =
            is_even && !component.has_border ? volume_of(component) >= 0.0 : is_even || area[1] < area[0];
        for (const std::uint32_t face : component.faces) {
            if (is_opposed_[face] != flip_opposed) continue;
            std::swap(faces_[face][1], faces_[face][2]);
            repair_.flipped_faces.push_back(face);
        }
    }

    double area_of(std::uint32_t face) const
    {
        const auto& [a, b, c] = faces_[face];
        const glm::dvec3 p = positions_[a];
        return 0.5 * glm::length(glm::cross(glm::dvec3(positions_[b]) - p, glm::dvec3(positions_[c]) - p));
    }

    /// As the component's first face would have all of them wound.
    double volume_of(const Component& component) const
    {
        const auto place = [&](std::uint32_t face, int corner) { return glm::dvec3(positions_[faces_[face][corner]]); };
        const glm::dvec3 origin = place(component.faces[0], 0);
        double volume = 0.0;
        for (const std::uint32_t face : component.faces) {
            const double own =
                glm::dot(glm::cross(place(face, 0) - origin, place(face, 1) - origin), place(face, 2) - origin);
            volume += is_opposed_[face] ? -own : own;
        }
        return volume;
    }

    std::span<const glm::vec3> positions_;
    std::vector<FaceCorners>& faces_;
    std::vector<Beyond> beyond_;
    std::vector<bool> is_opposed_;
    WindingRepair repair_;
};

}  // namespace

WindingRepair repair_winding(std::span<const glm::vec3> positions, std::vector<FaceCorners>& faces,
                             std::span<const DirectedEdge> uses)
{
    return WindingWalk(positions, faces, uses).run();
}

}  // namespace hw
