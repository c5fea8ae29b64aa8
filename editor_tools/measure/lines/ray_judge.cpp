#include "measure/lines/ray_judge.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "measure/lines/line_mask.hpp"

namespace hw {
namespace {

constexpr double kStep_px = 1.0;
constexpr double kLongest_px = 1e6;     // of an edge that passes close by the eye
constexpr double kSeen = 1.0 - 1e-4;    // of the way to the edge: free so far, it is seen
constexpr double kHidden = 1.0 - 1e-3;  // blocked before, it is hidden
constexpr double kBeside_px = 0.1;      // where rays ask whether the surface runs straight on: less than what is seen
constexpr double kClosest_px = 0.01;    // where they ask once more before a line is extra: a gap can be as narrow
constexpr double kStraightCosine = 0.9998;
constexpr double kStraightShare = 1e-3;  // off the plane, of the distance
constexpr double kFlatCosine = 1.0 - 1e-6;
constexpr double kFlatShare = 1e-5;

/// Calls `use(point, length, way)` along a polyline, step by step, for what is in the picture.
template <typename Use>
void walk(const JudgedLine& line, const Pinhole& pinhole, const Use& use)
{
    for (std::size_t i = 0; i + 1 < line.points_px.size(); ++i) {
        const glm::dvec2 a = line.points_px[i], b = line.points_px[i + 1];
        const double length = glm::distance(a, b);
        const int count = 1 + static_cast<int>(length / kStep_px);
        for (int k = 0; k < count; ++k) {
            const glm::dvec2 p = glm::mix(a, b, (k + 0.5) / count);
            if (pinhole.holds(p)) use(p, length / count, b - a);
        }
    }
}

/// How far the surface that is seen on both sides of an edge is from one plane, in which no line is to be.
struct Bend {
    double cosine = -1.0;  ///< Between the normals.
    double step = 1.0;     ///< Off the plane, of the distance.

    bool may_be_none() const { return cosine >= kStraightCosine && step < kStraightShare; }
    bool is_surely_none() const { return cosine >= kFlatCosine && step < kFlatShare; }
};

Bend bend_at(const EyeRays& rays, const Pinhole& pinhole, const glm::dvec2& at, const glm::dvec2& across,
             double beside_px)
{
    constexpr double kFar = 1e9;
    const glm::dvec3 left_way = pinhole.ray(at - beside_px * across);
    const glm::dvec3 right_way = pinhole.ray(at + beside_px * across);
    const auto left = rays.first(left_way, kFar), right = rays.first(right_way, kFar);
    if (!left || !right) return {};
    const glm::dvec3 step = right->share * right_way - left->share * left_way;
    return {std::abs(glm::dot(left->normal, right->normal)), std::abs(glm::dot(step, left->normal)) / left->share};
}

}  // namespace

void RayVerdict::add(const RayVerdict& other)
{
    candidates_px += other.candidates_px;
    visible_px += other.visible_px;
    missed_px += other.missed_px;
    crossed_px += other.crossed_px;
    thinned_px += other.thinned_px;
    found_px += other.found_px;
    extra_px += other.extra_px;
    noticed_px += other.noticed_px;
    unsure_px += other.unsure_px;
    unjudged_px += other.unjudged_px;
    rays += other.rays;
}

RayJudge::RayJudge(const Scene& scene, double crease_rad) : triangles_(hiding_triangles(scene))
{
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const std::vector<JudgedEdge> edges = judged_edges(scene, id, crease_rad);
        edges_.insert(edges_.end(), edges.begin(), edges.end());
    }
}

/// One view that is being judged.
struct RayJudge::Look {
    Look(const RayJudge& judge, const JudgeCamera& camera, std::span<const JudgedLine> found,
         std::span<const JudgedLine> drawn)
        : eye(camera.eye_world),
          pinhole(camera),
          rays(judge.triangles_, camera.eye_world),
          is_found(camera.size_px),
          is_drawn(camera.size_px),
          is_crossed(camera.size_px),
          may_be(camera.size_px),
          is_seen(camera.size_px)
    {
        for (const JudgedLine& line : found) {
            walk(line, pinhole, [&](const auto& p, double, const auto& way) {
                line.is_intersection ? is_crossed.add(p, way) : is_found.add(p, way);
            });
            is_found.end_line();
        }
        for (const JudgedLine& line : drawn)
            walk(line, pinhole, [&](const auto& p, double, const auto& way) { is_drawn.add(p, way); });
    }

    void judge_sample(const JudgedEdge& edge, const glm::dvec3& way, const glm::dvec2& at, const glm::dvec2& across,
                      double length)
    {
        verdict.candidates_px += length;
        const auto before = rays.first(way, kSeen);
        if (before && before->share < kHidden) return;
        const Bend bend = bend_at(rays, pinhole, at, across, kBeside_px);
        const glm::dvec2 along(across.y, -across.x);
        const bool is_none = bend.is_surely_none() && bend_at(rays, pinhole, at, across, kClosest_px).is_surely_none();
        if (!is_none) may_be.add(at, along);
        if (before || !edge.is_sure || bend.may_be_none()) return;
        verdict.visible_px += length;
        is_seen.add(at, along);
        if (!is_found.hold(at, along)) {
            const bool is_missed = !is_crossed.holds(at, along);
            (is_missed ? verdict.missed_px : verdict.crossed_px) += length;
            if (is_missed) show(at, judged_missed);
        } else if (!is_drawn.holds(at, along)) {
            verdict.thinned_px += length;
            show(at, judged_thinned);
        }
    }

    bool is_line(const JudgedEdge& edge) const
    {
        const auto looks_here = [&](const glm::dvec3& normal) { return glm::dot(normal, edge.from - eye) < 0.0; };
        const auto front = std::count_if(edge.normals.begin(), edge.normals.end(), looks_here);
        const auto all = static_cast<std::ptrdiff_t>(edge.normals.size());
        const bool is_contour = all != 2 || (front != 0 && front != all);
        return (edge.is_crease || is_contour) && !(edge.is_culled && front == 0);
    }

    void judge_edge(const JudgedEdge& edge)
    {
        glm::dvec3 from = edge.from - eye, to = edge.to - eye;
        const double near_from = pinhole.depth(from) - pinhole.near_m, near_to = pinhole.depth(to) - pinhole.near_m;
        if (near_from <= 0.0 && near_to <= 0.0) return;
        if (near_from < 0.0) from = glm::mix(to, from, near_to / (near_to - near_from));
        if (near_to < 0.0) to = glm::mix(from, to, near_from / (near_from - near_to));
        const glm::dvec2 a = pinhole.project(from), b = pinhole.project(to);
        const double length = glm::distance(a, b);
        if (!(length > 0.0) || length > kLongest_px) return;
        const glm::dvec2 across = glm::dvec2(a.y - b.y, b.x - a.x) / length;
        const int count = 1 + static_cast<int>(length / kStep_px);
        for (int k = 0; k < count; ++k) {
            const double t = (k + 0.5) / count;
            const glm::dvec2 at = glm::mix(a, b, t);
            if (!pinhole.holds(at)) continue;
            // Even steps in the picture are none on the edge.
            const double share = t * pinhole.depth(from) / glm::mix(pinhole.depth(to), pinhole.depth(from), t);
            judge_sample(edge, glm::mix(from, to, share), at, across, length / count);
        }
    }

    void judge_found(const JudgedLine& line)
    {
        walk(line, pinhole, [&](const glm::dvec2& p, double length, const glm::dvec2& way) {
            (line.is_intersection ? verdict.unjudged_px : verdict.found_px) += length;
            const bool is_extra = !line.is_intersection && !may_be.holds(p, way);
            if (is_extra) verdict.extra_px += length;
            if (!line.is_intersection && !is_extra) judge_explained(p, length, way);
            show(p, is_extra ? judged_extra : judged_found);
        });
    }

    void judge_explained(const glm::dvec2& p, double length, const glm::dvec2& way)
    {
        if (!is_seen.holds(p, way))
            verdict.unsure_px += length;
        else if (!is_found.hold_two(p, way))
            verdict.noticed_px += length;
    }

    void show(const glm::dvec2& p, JudgedPixel what)
    {
        if (to_show == nullptr) return;
        std::uint8_t& pixel =
            (*to_show)[static_cast<std::size_t>(p.y) * pinhole.size_px.x + static_cast<std::size_t>(p.x)];
        pixel = std::max<std::uint8_t>(pixel, what);
    }

    std::vector<std::uint8_t>* to_show = nullptr;
    glm::dvec3 eye;
    Pinhole pinhole;
    EyeRays rays;
    FoundLines is_found;
    LineMask is_drawn, is_crossed, may_be, is_seen;
    RayVerdict verdict;
};

RayVerdict RayJudge::judge(const JudgeCamera& camera, std::span<const JudgedLine> found,
                           std::span<const JudgedLine> drawn, std::vector<std::uint8_t>* to_show) const
{
    Look look(*this, camera, found, drawn);
    look.to_show = to_show;
    if (to_show != nullptr)
        to_show->assign(static_cast<std::size_t>(camera.size_px.x) * camera.size_px.y, judged_paper);
    for (const JudgedEdge& edge : edges_)
        if (look.is_line(edge)) look.judge_edge(edge);
    for (const JudgedLine& line : found) look.judge_found(line);
    look.verdict.rays = look.rays.count();
    return look.verdict;
}

}  // namespace hw
