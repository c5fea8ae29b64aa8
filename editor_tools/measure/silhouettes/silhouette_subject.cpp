#include "measure/silhouettes/silhouette_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <glm/ext/matrix_transform.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "hatchway/core/box.hpp"
#include "hatchway/core/log.hpp"

namespace hw {
namespace {

constexpr int kTrials = 1000;  // random views among which the worst are looked for
constexpr std::size_t kWorst = 5;
constexpr double kLeastFaces = 0.9;
constexpr double kTurn_rad = 0.7;  // of a node, around an axis that no coordinate has
const glm::dvec3 kTurnAxis(0.48, 0.6, 0.64);

constexpr SurfaceOptions kWithoutClusters{.cluster_from_faces = std::numeric_limits<std::uint32_t>::max()};

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Views of the object evenly around it, random ones, and of more random ones those from which the filter left most
/// faces open.
std::vector<Viewpoint> views_of(const Surface& surface, const SilhouetteViews& wanted)
{
    Box box;
    for (const glm::vec3& p : surface.positions) box.add(glm::dvec3(p));
    const double reach = 0.5 * glm::length(box.size());
    const auto view = [&](double x, double y, double z) {
        const glm::dvec3 direction(x, y, z);
        return Viewpoint{wanted.is_orthographic ? direction : box.centre() + 3.0 * reach * direction,
                         wanted.is_orthographic};
    };
    std::vector<Viewpoint> views;
    for (int i = 0; i < wanted.around; ++i) {
        const double y = 1.0 - 2.0 * (i + 0.5) / wanted.around, around = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double r = std::sqrt(1.0 - y * y);
        views.push_back(view(r * std::cos(around), y, r * std::sin(around)));
    }
    std::mt19937 random(wanted.seed);
    const auto part = [&] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
    const auto random_view = [&] {
        const double x = part(), y = part(), z = part();
        return view(x, y, z);
    };
    for (int i = 0; i < wanted.random; ++i) views.push_back(random_view());
    std::vector<std::pair<std::uint64_t, Viewpoint>> trials;
    SilhouetteScratch scratch;
    for (int i = 0; i < kTrials; ++i) {
        const Viewpoint trial = random_view();
        scratch.counters = {};
        find_facing(surface, trial, FacingPrecision::exact, scratch);
        trials.emplace_back(scratch.counters.double_stage, trial);
    }
    std::stable_sort(trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t i = 0; i < kWorst; ++i) views.push_back(trials[i].second);
    return views;
}

/// The file's triangles need no winding. Which faces of the surface take the plane of another, the engine says.
void add_oracles(SilhouetteSubject& subject)
{
    using Arithmetic = SilhouetteOracle::Arithmetic;
    const Surface& surface = subject.surface;
    subject.file_oracle =
        std::make_unique<SilhouetteOracle>(subject.file->positions(), subject.file->faces(), Arithmetic::filtered,
                                           std::span<const OraclePlane>(), SilhouetteOracle::Winding::says_nothing);
    std::vector<OraclePlane> given;
    std::vector<bool> is_own(surface.faces.size(), true);
    for (const auto& [face, plane_of] : surface.filter.inherited) {
        given.push_back({face, plane_of});
        is_own[face] = false;
    }
    subject.surface_oracle =
        std::make_unique<SilhouetteOracle>(surface.positions, surface.faces, Arithmetic::filtered, given);
    subject.changed = subject.file->changed_edges(surface.positions, surface.faces, is_own);
}

/// The views, and what both oracles see from them.
void add_views(SilhouetteSubject& subject, const SilhouettePlacement& placement, const SilhouetteViews& wanted)
{
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), glm::dvec3(placement.offset));
    const glm::dmat4 world = placement.is_by_node ? glm::rotate(moved, kTurn_rad, kTurnAxis) : glm::dmat4(1.0);
    for (Viewpoint view : views_of(subject.surface, wanted)) {
        const double w = view.is_orthographic ? 0.0 : 1.0;
        view.eye = glm::dvec3(world * glm::dvec4(view.eye, w));
        subject.views.push_back(in_object(view, world));
        subject.of_file.push_back(subject.file_oracle->silhouettes_in_world(view.eye, world, w));
        subject.edge_on.push_back(subject.file_oracle->edge_on_in_world(view.eye, world, w));
        subject.of_surface.push_back(subject.surface_oracle->silhouettes_in_world(view.eye, world, w));
    }
}

}  // namespace

std::size_t whole_faces_of(const MeshData& mesh)
{
    return build_surface(mesh, kWithoutClusters).faces.size();
}

std::optional<SilhouetteSubject> silhouette_subject(MeshData mesh, const SilhouettePlacement& placement,
                                                    std::size_t whole_faces, const SilhouetteViews& views)
{
    const double moved = placement.is_by_node ? 0.0 : placement.offset;
    for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(p) * placement.scale + moved);
    SilhouetteSubject subject;
    const auto start = std::chrono::steady_clock::now();
    subject.surface = build_surface(mesh, kWithoutClusters);
    subject.preprocess_s = seconds_since(start);
    const std::size_t left = subject.surface.faces.size();
    if (left == 0 || static_cast<double>(left) < kLeastFaces * static_cast<double>(whole_faces)) {
        log_warning(fmt::format("moved by {:g} and scaled by {:g}, {} of {} faces are left: not measured",
                                placement.offset, placement.scale, left, whole_faces));
        return std::nullopt;
    }
    const auto cluster_start = std::chrono::steady_clock::now();
    subject.surface.clusters.prepare(subject.surface);
    subject.cluster_s = seconds_since(cluster_start);
    subject.half_edges = std::make_unique<HalfEdgeMesh>(subject.surface);
    subject.file = std::make_unique<FileTriangles>(mesh);
    add_oracles(subject);
    add_views(subject, placement, views);
    return subject;
}

}  // namespace hw
