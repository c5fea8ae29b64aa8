#include "measure/visibility/sight_measure.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <mutex>

#include "hatchway/render/view/visible_set.hpp"
#include "measure/lines/eye_rays.hpp"
#include "measure/share_work.hpp"

namespace hw::measure {
namespace {

constexpr std::uint32_t kPieceTriangles = 64;

JudgeCamera judge_camera(const View& view, const glm::ivec2& size_px)
{
    const glm::dvec3 back = glm::dmat3(glm::transpose(glm::dmat4(view.view_from_world)))[2];
    return {.eye_world = view.eye_world,
            .target_world = view.eye_world - back,
            .fov_rad = 2.0 * std::atan(1.0 / view.clip_from_view[1][1]),
            .size_px = size_px};
}

/// A hidden chunk and a ray that seems to meet it.
struct Claim {
    std::uint32_t triangle = 0;
    glm::dvec3 way{0.0};
};

}  // namespace

void SightCounts::add(const SightCounts& other)
{
    in_view += other.in_view;
    drawn += other.drawn;
    needed += other.needed;
    met += other.met;
    rays += other.rays;
    lost += other.lost;
}

SightJudge::SightJudge(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh, const Visibility& visibility)
    : scene_(scene),
      chunks_(chunks_of_mesh),
      visibility_(visibility),
      triangles_(sight_triangles(scene, chunks_of_mesh)),
      rays_(triangles_)
{
    for (const MeshData& mesh : scene.meshes) {
        Box box;
        for (const glm::vec3& position : mesh.positions) box.add(glm::dvec3(position));
        mesh_bounds_.push_back(box);
    }
}

std::uint64_t SightJudge::triangles_in(const View& view, const Visibility* visibility) const
{
    VisibleSet set;
    find_visible(
        {.scene = &scene_, .chunks = chunks_, .mesh_bounds = mesh_bounds_, .visibility = visibility, .left_out = {}},
        view, set);
    std::uint64_t count = 0;
    for (const IndexRange& range : set.ranges) count += range.count / 3;
    return count;
}

void SightJudge::count_met(const std::vector<std::uint8_t>& is_met, SightCounts& counts) const
{
    std::size_t first = 0;
    while (first < triangles_.size()) {
        std::size_t end = first;
        while (end < triangles_.size() && end - first < kPieceTriangles &&
               triangles_[end].slot == triangles_[first].slot)
            ++end;
        const auto met = std::count(is_met.begin() + static_cast<std::ptrdiff_t>(first),
                                    is_met.begin() + static_cast<std::ptrdiff_t>(end), 1);
        counts.met += static_cast<std::uint64_t>(met);
        if (met > 0) counts.needed += end - first;
        first = end;
    }
}

SightCounts SightJudge::judge(const View& view, const glm::ivec2& size_px) const
{
    SightCounts counts{.in_view = triangles_in(view, nullptr), .drawn = triangles_in(view, &visibility_)};
    std::vector<std::uint8_t> is_shown;
    visible_chunks(visibility_, view.eye_world, 0.0, is_shown);
    std::vector<std::uint8_t> is_met(triangles_.size(), 0);
    std::vector<Claim> claims;
    std::mutex adding;
    const Pinhole pinhole(judge_camera(view, size_px));
    share_work(static_cast<std::size_t>(size_px.y), 0, [&](std::size_t y) {
        std::vector<std::uint32_t> met, row;
        std::vector<Claim> own_claims;
        for (int x = 0; x < size_px.x; ++x) {
            const glm::dvec3 way = pinhole.ray({x + 0.5, static_cast<double>(y) + 0.5});
            rays_.trace(view.eye_world, way, met);
            for (const std::uint32_t triangle : met) {
                row.push_back(triangle);
                if (is_shown[triangles_[triangle].slot] == 0) own_claims.push_back({triangle, way});
            }
        }
        const std::lock_guard lock(adding);
        for (const std::uint32_t triangle : row) is_met[triangle] = 1;
        claims.insert(claims.end(), own_claims.begin(), own_claims.end());
    });
    counts.rays = static_cast<std::uint64_t>(size_px.x) * static_cast<std::uint64_t>(size_px.y);
    count_met(is_met, counts);
    std::vector<std::uint8_t> is_lost(visibility_.slots.size(), 0);
    for (const Claim& claim : claims) {
        std::uint8_t& lost = is_lost[triangles_[claim.triangle].slot];
        if (lost == 0 && is_seen_exactly(triangles_, view.eye_world, claim.way, claim.triangle)) lost = 1;
    }
    counts.lost = static_cast<std::uint64_t>(std::count(is_lost.begin(), is_lost.end(), 1));
    return counts;
}

}  // namespace hw::measure
