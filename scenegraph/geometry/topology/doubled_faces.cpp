#include "hatchway/geometry/topology/doubled_faces.hpp"

#include <algorithm>
#include <tuple>

namespace hw {
namespace {

/// A face at its edge of the two smallest corners. Faces with the same corners meet there.
struct FaceAtEdge {
    std::uint32_t apex;
    std::uint32_t triangle;
    std::uint32_t face;
    bool is_forward;

    auto key() const { return std::tuple(apex, triangle); }
};

std::uint32_t apex_of(std::span<const FaceCorners> faces, const DirectedEdge& use)
{
    return faces[use.face][(use.corner + 2) % 3];
}

void drop(DoubledFaces& doubled, std::size_t face_count, const FaceAtEdge& kept, const FaceAtEdge& other)
{
    if (doubled.is_dropped.empty()) {
        doubled.is_dropped.resize(face_count, false);
        doubled.is_two_sided.resize(face_count, false);
    }
    doubled.is_dropped[other.face] = true;
    if (other.is_forward != kept.is_forward) doubled.is_two_sided[kept.face] = true;
}

}  // namespace

DoubledFaces find_doubled_faces(std::span<const FaceCorners> faces, std::span<const DirectedEdge> uses,
                                std::span<const std::uint32_t> face_triangle)
{
    DoubledFaces doubled;
    std::vector<FaceAtEdge> here;
    for_each_edge(uses, [&](std::span<const DirectedEdge> edge) {
        if (edge.size() < 2 || (edge.size() == 2 && apex_of(faces, edge[0]) != apex_of(faces, edge[1]))) return;
        here.clear();
        for (const DirectedEdge& use : edge) {
            const std::uint32_t apex = apex_of(faces, use);
            if (apex > use.high) here.push_back({apex, face_triangle[use.face], use.face, use.is_forward});
        }
        std::sort(here.begin(), here.end(), [](const auto& a, const auto& b) { return a.key() < b.key(); });
        for (std::size_t i = 1, kept = 0; i < here.size(); ++i) {
            if (here[i].apex == here[kept].apex)
                drop(doubled, faces.size(), here[kept], here[i]);
            else
                kept = i;
        }
    });
    return doubled;
}

}  // namespace hw
