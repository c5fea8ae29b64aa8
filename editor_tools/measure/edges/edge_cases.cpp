#include "measure/edges/edge_cases.hpp"

#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "hatchway/render/view/line_camera.hpp"
#include "measure/lines/eye_rays.hpp"

namespace hw {
namespace {

constexpr double kSheetM = 1e-4;  // thickness of a sheet of paper
constexpr double kEyeM = 1.7;

/// Adds a grid of cells x cells rectangles with a normal, all in one plane.
void add_grid(MeshData& mesh, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, int cells = 1)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            mesh.positions.emplace_back(corner + (static_cast<double>(i) / cells) * u +
                                        (static_cast<double>(j) / cells) * v);
            mesh.normals.emplace_back(glm::normalize(glm::cross(u, v)));
        }
    for (std::uint32_t j = 0; j + 1 < row; ++j)
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t at = first + j * row + i;
            for (const std::uint32_t k : {at, at + 1, at + row + 1, at, at + row + 1, at + row})
                mesh.indices.push_back(k);
        }
}

Scene scene_of(MeshData mesh)
{
    Scene scene;
    mesh.has_own_normals = true;
    for (const glm::vec3& p : mesh.positions) scene.bounds_world.add(glm::dvec3(p));
    scene.meshes.push_back(std::move(mesh));
    scene.materials.push_back({.is_double_sided = true});
    scene.nodes.push_back({.name = "all", .path = "all"});
    scene.objects.push_back({.node = 0, .mesh = 0, .material = 0, .bounds_world = scene.bounds_world});
    return scene;
}

void add_outline(EdgeCase& to, const std::array<glm::dvec3, 4>& corners, EdgeKind kind)
{
    for (std::size_t i = 0; i < 4; ++i) to.lines.push_back({corners[i], corners[(i + 1) % 4], kind});
}

EdgeCase paper_on_a_desk()
{
    MeshData mesh;
    add_grid(mesh, {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
    add_grid(mesh, {-0.105, kSheetM, 0.15}, {0.21, 0, 0}, {0, 0, -0.297});
    EdgeCase made{"paper on a desk", scene_of(std::move(mesh)), {{0.1, 0.6, 0.7}, {0, 0, 0}, 30.0}, {}};
    const double y = kSheetM;
    add_outline(made, {{{-0.105, y, 0.15}, {0.105, y, 0.15}, {0.105, y, -0.147}, {-0.105, y, -0.147}}},
                EdgeKind::flush);
    return made;
}

/// A sheet in the air, a third of it folded over onto the rest.
EdgeCase folded_paper()
{
    MeshData mesh;
    add_grid(mesh, {-0.1, 0, 0.1}, {0.2, 0, 0}, {0, 0, -0.2});
    add_grid(mesh, {-0.1, kSheetM, 0.1}, {0.07, 0, 0}, {0, 0, -0.2});
    EdgeCase made{"folded paper", scene_of(std::move(mesh)), {{0.1, 0.6, 0.5}, {0, 0, 0}, 30.0}, {}};
    add_outline(made, {{{-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0.1, 0, -0.1}, {-0.1, 0, -0.1}}}, EdgeKind::profile);
    made.lines.push_back({{-0.03, kSheetM, 0.1}, {-0.03, kSheetM, -0.1}, EdgeKind::flush});
    return made;
}

EdgeCase far_wall()
{
    MeshData mesh;
    add_grid(mesh, {-100, -100, -80}, {200, 0, 0}, {0, 200, 0});
    return {"far wall seen flat-on", scene_of(std::move(mesh)), {{0, kEyeM, 0}, {0, kEyeM, -1}, 60.0}, {}};
}

/// From 1 to 5 degrees below the horizon.
EdgeCase floor(const std::string& name, int cells)
{
    MeshData mesh;
    add_grid(mesh, {-400, 0, 200}, {800, 0, 0}, {0, 0, -800}, cells);
    const double dip = std::tan(glm::radians(3.0));
    return {name, scene_of(std::move(mesh)), {{0, kEyeM, 0}, {0, kEyeM - dip, -1}, 4.0}, {}};
}

}  // namespace

std::vector<WantedEdge> EdgeCase::wanted(glm::ivec2 size_px) const
{
    const LineCamera place = line_camera(camera, camera_view(camera, size_px, scene.bounds_world));
    const Pinhole pinhole({place.eye_world, place.target_world, place.fov_rad, place.size_px, place.near_m});
    std::vector<WantedEdge> edges;
    for (const Line& line : lines) {
        const glm::dvec2 a = pinhole.project(line.from - place.eye_world);
        const glm::dvec2 b = pinhole.project(line.to - place.eye_world);
        const double length = glm::distance(a, b);
        const int count = 1 + static_cast<int>(2.0 * length);
        for (int k = 0; k < count; ++k) {
            const glm::dvec2 at = glm::mix(a, b, (k + 0.5) / count);
            if (pinhole.holds(at))
                edges.push_back({at, glm::dvec2(a.y - b.y, b.x - a.x) / length, length / count, line.kind});
        }
    }
    return edges;
}

EdgeCase cylinder_fan(int sides)
{
    MeshData mesh;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * glm::pi<double>() * i / sides;
        add_grid(mesh, {0, 0, 0}, {std::cos(angle), 0, std::sin(angle)}, {0, 1, 0});
    }
    return {fmt::format("fan of {} sides", sides), scene_of(std::move(mesh)), {{0.5, 2.5, 1.5}, {0, 0.5, 0}, 40.0}, {}};
}

std::vector<EdgeCase> edge_cases()
{
    std::vector<EdgeCase> cases;
    cases.push_back(paper_on_a_desk());
    cases.push_back(folded_paper());
    cases.push_back(far_wall());
    cases.push_back(floor("floor at 1 to 5 degrees", 1));
    cases.push_back(floor("floor of 20,000 triangles at 1 to 5 degrees", 100));
    return cases;
}

}  // namespace hw
