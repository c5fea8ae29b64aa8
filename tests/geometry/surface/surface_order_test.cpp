// What a surface is does not depend on the order in which a file lists its triangles, nor on the corner at which one
// begins.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "hatchway/geometry/surface/surface.hpp"
#include "tests/geometry/test_meshes.hpp"

namespace {

using namespace hw::test;

hw::MeshData shuffled(const hw::MeshData& mesh, std::mt19937& random)
{
    std::vector<std::size_t> order(mesh.triangle_count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    hw::MeshData result = mesh;
    result.indices.clear();
    for (const std::size_t triangle : order) {
        const unsigned turn = random() % 3;
        for (unsigned corner = 0; corner < 3; ++corner)
            result.indices.push_back(mesh.indices[3 * triangle + (corner + turn) % 3]);
    }
    return result;
}

/// Triangles between random points of a small lattice: borders, complex edges, faces without area, faces twice.
hw::MeshData random_soup(std::mt19937& random)
{
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 12; ++i) positions.emplace_back(random() % 3, random() % 3, random() % 3);
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < 3 * 14; ++i) indices.push_back(random() % 12);
    return mesh_of(positions, indices);
}

/// What must not change: the report's counts and the sizes of all classes at some crease angles.
std::vector<std::uint32_t> counts_of(const hw::Surface& surface)
{
    const hw::SurfaceReport& r = surface.report;
    std::vector<std::uint32_t> counts{r.triangles_in,  r.removed_faces,  r.collinear_faces, r.border_edges,
                                      r.complex_edges, r.stitched_edges, r.artist_edges,    r.components};
    for (const float crease_rad : {0.1f, 0.7f, 1.2f, 3.2f}) {
        const hw::EdgeClasses classes = hw::classes_at(surface, crease_rad);
        for (const std::uint32_t count :
             {classes.borders.size(), classes.crease_count(), classes.candidate_count(), classes.silent.size()})
            counts.push_back(count);
    }
    return counts;
}

/// What holds beside them where every component can be oriented.
std::vector<std::uint32_t> oriented_counts_of(const hw::Surface& surface)
{
    const hw::SurfaceReport& r = surface.report;
    return {r.flipped_faces, r.inconsistent_edges, r.closed_components, r.inward_components, r.reflex_rule_components};
}

}  // namespace

TEST(surface_order, whole_meshes_are_the_same_in_any_order)
{
    std::mt19937 random(7);
    hw::MeshData open = torus(24, 12);
    open.indices.resize(open.indices.size() - 60);
    hw::MeshData wrong = sphere(12, 8);
    for (std::size_t triangle = 0; triangle < wrong.triangle_count(); triangle += 5)
        std::swap(wrong.indices[3 * triangle], wrong.indices[3 * triangle + 1]);
    for (const hw::MeshData& mesh : {prism(8), flat_shaded(prism(8)), open, wrong, turned_over(torus(9, 7)),
                                     joined({torus(20, 10), sphere(9, 7, 3.0f), box({0, 0, 0}, {1, 2, 3})})}) {
        const hw::Surface surface = hw::build_surface(mesh);
        for (int trial = 0; trial < 20; ++trial) {
            const hw::Surface again = hw::build_surface(shuffled(mesh, random));
            ASSERT_EQ(counts_of(again), counts_of(surface));
            ASSERT_EQ(oriented_counts_of(again), oriented_counts_of(surface));
        }
    }
}

TEST(surface_order, triangle_soups_are_the_same_in_any_order)
{
    std::mt19937 random(7);
    for (int trial = 0; trial < 2000; ++trial) {
        const hw::MeshData mesh = random_soup(random);
        const hw::Surface surface = hw::build_surface(mesh);
        ASSERT_EQ(counts_of(hw::build_surface(shuffled(mesh, random))), counts_of(surface)) << "trial " << trial;
    }
}
