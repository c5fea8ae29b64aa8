// The measuring data beside the project: silhouettes of every model, edge for edge against rational arithmetic.
#include <gtest/gtest.h>

#include <algorithm>

#include "measure/silhouettes/half_edge_mesh.hpp"
#include "tests/geometry/glb_meshes.hpp"
#include "tests/geometry/silhouettes/silhouette_checks.hpp"
#include "tests/shared_data.hpp"

namespace {

using namespace hw::test;
namespace fs = std::filesystem;

class shared_models : public testing::TestWithParam<const char*> {
 protected:
    template <typename Judge>
    void for_each_mesh(Judge judge) const
    {
        for (const fs::path& file : files_)
            for (const hw::MeshData& mesh : read_glb_meshes(file)) judge(file, mesh, hw::build_surface(mesh));
    }

    const std::vector<fs::path> files_ = shared_glb_files(GetParam());
};

}  // namespace

TEST_P(shared_models, agree_edge_for_edge_with_exact_arithmetic)
{
    HATCHWAY_NEEDS_DATA(!files_.empty(), "measuring data beside the project");
    for_each_mesh([](const fs::path& file, const hw::MeshData&, const hw::Surface& surface) {
        EXPECT_EQ(wrong_edges_in_all_views(surface), 0u) << file;
    });
}

TEST_P(shared_models, lose_no_face)
{
    HATCHWAY_NEEDS_DATA(!files_.empty(), "measuring data beside the project");
    for_each_mesh([](const fs::path& file, const hw::MeshData& mesh, const hw::Surface& surface) {
        const auto caps = std::count(surface.face_triangle.begin(), surface.face_triangle.end(), hw::kNoFace);
        EXPECT_EQ(surface.faces.size() - static_cast<std::size_t>(caps) + surface.report.removed_faces +
                      surface.report.doubled_faces,
                  mesh.triangle_count())
            << file;
        EXPECT_EQ(hw::HalfEdgeMesh(surface).face_count(), surface.faces.size()) << file;
    });
}

INSTANTIATE_TEST_SUITE_P(folders, shared_models, testing::Values("models", "hard", "scenes"),
                         [](const auto& folder) { return std::string(folder.param); });
