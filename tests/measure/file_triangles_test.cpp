// What a file holds, and what repair makes of it, are two things for the judge of silhouettes.
#include "measure/silhouettes/file_triangles.hpp"

#include <gmock/gmock.h>

#include "hatchway/geometry/surface/surface.hpp"
#include "tests/geometry/test_meshes.hpp"

using namespace hw::test;

namespace {

const glm::dvec3 kEye(3.1, 2.3, 1.7);

std::vector<hw::OracleEdge> of_surface_in_file(const hw::MeshData& mesh, const hw::FileTriangles& file)
{
    const hw::Surface surface = hw::build_surface(mesh);
    const hw::SilhouetteOracle oracle(surface.positions, surface.faces);
    return file.edges_between(surface.positions, oracle.silhouettes(kEye));
}

std::vector<hw::OracleEdge> of_file(const hw::FileTriangles& file)
{
    return hw::SilhouetteOracle(file.positions(), file.faces()).silhouettes(kEye);
}

}  // namespace

TEST(file_triangles, a_mesh_that_needs_no_repair_has_the_silhouettes_of_its_surface)
{
    const hw::MeshData mesh = torus(40, 20);
    const hw::FileTriangles file(mesh);
    EXPECT_EQ(file.faces().size(), mesh.triangle_count());
    EXPECT_GT(of_file(file).size(), 50u);
    EXPECT_EQ(of_surface_in_file(mesh, file), of_file(file));
}

TEST(file_triangles, a_triangle_that_repair_turns_over_is_seen_by_the_judge)
{
    hw::MeshData mesh = torus(40, 20);
    std::swap(mesh.indices[300], mesh.indices[301]);
    const hw::FileTriangles file(mesh);
    const auto whole = of_surface_in_file(mesh, file), flipped = of_file(file);
    std::vector<hw::OracleEdge> unlike;
    std::set_symmetric_difference(whole.begin(), whole.end(), flipped.begin(), flipped.end(),
                                  std::back_inserter(unlike));
    EXPECT_EQ(unlike.size(), 3u);
}

TEST(file_triangles, where_winding_says_nothing_a_turned_triangle_changes_no_silhouette)
{
    hw::MeshData mesh = torus(40, 20);
    std::swap(mesh.indices[300], mesh.indices[301]);
    const hw::FileTriangles file(mesh);
    const hw::SilhouetteOracle oracle(file.positions(), file.faces(), hw::SilhouetteOracle::Arithmetic::filtered, {},
                                      hw::SilhouetteOracle::Winding::says_nothing);
    EXPECT_EQ(oracle.silhouettes(kEye), of_surface_in_file(mesh, file));
}

TEST(file_triangles, of_triangles_with_the_same_corners_one_counts_so_a_folded_sheet_has_borders_and_no_silhouettes)
{
    hw::MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 1, 1, 2, 0};
    const hw::FileTriangles file(mesh);
    EXPECT_EQ(file.faces().size(), 1u);
    EXPECT_EQ(file.doubled(), 2u);
    EXPECT_THAT(of_file(file), testing::IsEmpty());
    EXPECT_THAT(of_surface_in_file(mesh, file), testing::IsEmpty());
}

TEST(file_triangles, edges_of_faces_that_are_moved_left_out_or_without_a_plane_of_their_own_are_changed)
{
    const hw::MeshData mesh = torus(40, 20);
    const hw::FileTriangles file(mesh);
    std::vector<glm::vec3> positions = file.positions();
    std::vector<std::array<std::uint32_t, 3>> faces = file.faces();
    std::vector<bool> is_own(faces.size(), true);
    EXPECT_THAT(file.changed_edges(positions, faces, is_own), testing::IsEmpty());
    is_own[7] = false;
    EXPECT_EQ(file.changed_edges(positions, faces, is_own).size(), 3u);
    faces.erase(faces.begin() + 7);
    is_own.assign(faces.size(), true);
    EXPECT_EQ(file.changed_edges(positions, faces, is_own).size(), 3u);
    positions[0].x += 1.0f;  // six triangles meet there: twelve edges of the file, and six to nowhere
    EXPECT_EQ(file.changed_edges(positions, file.faces(), std::vector<bool>(file.faces().size(), true)).size(), 18u);
}

TEST(file_triangles, triangles_with_two_equal_corners_are_none_and_corners_without_one_are_nowhere)
{
    hw::MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 0}};
    mesh.indices = {0, 1, 2, 0, 1, 3};
    const hw::FileTriangles file(mesh);
    EXPECT_EQ(file.positions().size(), 3u);
    EXPECT_EQ(file.faces().size(), 1u);
    const auto edges = file.edges_between({{0, 0, 0}, {5, 5, 5}}, {{0, 1}});
    EXPECT_EQ(edges, (std::vector<hw::OracleEdge>{{0, hw::FileTriangles::kNowhere}}));
}
