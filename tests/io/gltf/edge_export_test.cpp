#include "hatchway/io/gltf/edge_export.hpp"

#include <gtest/gtest.h>

#include "hatchway/geometry/surface/surface.hpp"
#include "hatchway/io/gltf/import.hpp"
#include "tests/io/gltf/model_builder.hpp"
#include "tests/temporary_folder.hpp"

namespace {

/// A roof: two slopes that meet at a ridge of 90 degrees, each of two triangles.
ModelBuilder roof()
{
    ModelBuilder builder;
    const int positions = builder.add_positions({0, 0, 0, 4, 0, 0, 4, 1, -1, 0, 1, -1, 4, 0, -2, 0, 0, -2});
    const int indices = builder.add_indices({0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5});
    auto& primitive = builder.add_object({{"POSITION", positions}});
    primitive["indices"] = indices;
    return builder;
}

}  // namespace

TEST(edge_export, creases_come_back_as_the_artists_edges)
{
    const TemporaryFolder folder;
    const auto in = folder.write("roof.glb", roof().glb()), out = folder.path() / "marked.glb";
    const hw::EdgeExport counts = hw::export_edges(in, folder.path(), out, 0.7f);
    EXPECT_EQ(counts.primitives, 1u);
    EXPECT_EQ(counts.drawn_edges, 7u);  // the ridge and six borders
    EXPECT_EQ(counts.silhouette_edges, 0u);

    const hw::Scene scene = hw::import_gltf(out, folder.path());
    const hw::Surface surface = hw::build_surface(scene.meshes[0]);
    EXPECT_EQ(surface.report.artist_edges, 1u);  // a border is no edge of two faces
    EXPECT_EQ(hw::build_surface(hw::import_gltf(in, folder.path()).meshes[0]).report.artist_edges, 0u);
    // Without folds the ridge stays drawn: it is the artist's now.
    const hw::EdgeClasses classes = hw::classes_at(surface, 3.2f);
    ASSERT_EQ(classes.artist[0].size(), 1u);
    const auto [a, b] = hw::edge_vertices(surface, classes.artist[0].begin);
    EXPECT_EQ(surface.positions[a].y, 1.0f);
    EXPECT_EQ(surface.positions[b].y, 1.0f);
}

TEST(edge_export, the_model_stays_what_it_was_and_a_second_export_changes_nothing)
{
    const TemporaryFolder folder;
    const auto in = folder.write("roof.glb", roof().glb());
    hw::export_edges(in, folder.path(), folder.path() / "once.glb", 0.7f);
    const hw::EdgeExport again =
        hw::export_edges(folder.path() / "once.glb", folder.path(), folder.path() / "twice.glb", 3.2f);
    EXPECT_EQ(again.drawn_edges, 7u);  // what was marked once stays marked at every crease angle
    const hw::Scene before = hw::import_gltf(in, folder.path());
    const hw::Scene after = hw::import_gltf(folder.path() / "twice.glb", folder.path());
    EXPECT_EQ(before.meshes[0].positions, after.meshes[0].positions);
    EXPECT_EQ(before.meshes[0].indices, after.meshes[0].indices);
}
