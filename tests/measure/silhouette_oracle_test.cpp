// What the oracle says of a file, whose winding may be anything, does not depend on it.
#include "measure/silhouettes/silhouette_oracle.hpp"

#include <gmock/gmock.h>

#include <array>
#include <set>

#include "measure/silhouettes/file_triangles.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace hw {
namespace {

constexpr glm::dmat4 kHere(1.0);

/// Edges by their places, since numbers follow the order of the file.
using EdgeSet = std::set<std::set<std::array<float, 3>>>;

struct Seen {
    EdgeSet silhouettes;
    EdgeSet edge_on;
};

Seen seen_from(const MeshData& mesh, const glm::dvec3& eye)
{
    const FileTriangles file(mesh);
    const SilhouetteOracle oracle(file.positions(), file.faces(), SilhouetteOracle::Arithmetic::filtered, {},
                                  SilhouetteOracle::Winding::says_nothing);
    const auto places = [&](const std::vector<OracleEdge>& edges) {
        EdgeSet set;
        for (const auto& [a, b] : edges) {
            const glm::vec3 &p = file.positions()[a], &q = file.positions()[b];
            set.insert({{p.x, p.y, p.z}, {q.x, q.y, q.z}});
        }
        return set;
    };
    return {places(oracle.silhouettes_in_world(eye, kHere)), places(oracle.edge_on_in_world(eye, kHere))};
}

MeshData with_first_faces_turned(MeshData mesh, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) std::swap(mesh.indices[3 * i], mesh.indices[3 * i + 1]);
    return mesh;
}

TEST(silhouette_oracle, from_an_eye_in_the_plane_of_faces_a_file_wound_otherwise_has_the_same_silhouettes)
{
    const MeshData box = test::box({0, 0, 0}, {1, 1, 1});
    const glm::dvec3 in_plane(3.1, 1.0, 2.3);
    const Seen seen = seen_from(box, in_plane);
    EXPECT_THAT(seen.edge_on, testing::SizeIs(5)) << "of the two faces above";
    EXPECT_THAT(seen.silhouettes, testing::SizeIs(4)) << "below and at the far sides";
    for (std::size_t turned = 1; turned <= box.triangle_count(); ++turned) {
        const Seen again = seen_from(with_first_faces_turned(box, turned), in_plane);
        EXPECT_EQ(again.silhouettes, seen.silhouettes) << turned;
        EXPECT_EQ(again.edge_on, seen.edge_on) << turned;
    }
}

TEST(silhouette_oracle, from_elsewhere_no_edge_is_open)
{
    const Seen seen = seen_from(test::box({0, 0, 0}, {1, 1, 1}), {3.1, 2.7, 2.3});
    EXPECT_THAT(seen.edge_on, testing::IsEmpty());
    EXPECT_THAT(seen.silhouettes, testing::SizeIs(6));
}

}  // namespace
}  // namespace hw
