#include "measure/lines/ray_judge.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

namespace hw {
namespace {

constexpr double kStep_px = 1.0;
constexpr double kReach_px = 1.5;
constexpr double kLongest_px = 1e6;     // of an edge that passes close by the eye
constexpr double kSeen = 1.0 - 1e-4;    // of the way to the edge: free so far, it is seen
constexpr double kHidden = 1.0 - 1e-3;  // blocked before, it is hidden
constexpr double kBeside_px = 0.1;      // where rays ask whether the surface runs straight on: less than what is seen
constexpr double kStraightCosine = 0.9998;
constexpr double kStraightShare = 1e-3;  // off the plane, of the distance
constexpr double kFlatCosine = 1.0 - 1e-6;
constexpr double kFlatShare = 1e-5;

/// The pinhole, eye-relative.
struct Pinhole {
    explicit Pinhole(const JudgeCamera& camera) : size_px(camera.size_px), near_m(camera.near_m)
    {
        forward = glm::normalize(camera.target_world - camera.eye_world);
        right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
        up = glm::cross(right, forward);
        focal_px = 0.5 * size_px.y / std::tan(0.5 * camera.fov_rad);
    }
    double depth(const glm::dvec3& way) const { return glm::dot(way, forward); }
    glm::dvec2 project(const glm::dvec3& way) const
    {
        return 0.5 * glm::dvec2(size_px) + focal_px / depth(way) * glm::dvec2(glm::dot(way, right), -glm::dot(way, up));
    }
    glm::dvec3 ray(const glm::dvec2& at_px) const
    {
        const glm::dvec2 off = at_px - 0.5 * glm::dvec2(size_px);
        return glm::normalize(focal_px * forward + off.x * right - off.y * up);
    }
    bool holds(const glm::dvec2& p) const { return p.x >= 0.0 && p.y >= 0.0 && p.x < size_px.x && p.y < size_px.y; }

    glm::dvec3 forward, right, up;
    double focal_px;
    glm::ivec2 size_px;
    double near_m;
};

/// Pixels within the reach of something.
class Mask {
 public:
    explicit Mask(glm::ivec2 size) : size_(size), is_set_(static_cast<std::size_t>(size.x) * size.y) {}

    void add(const glm::dvec2& p)
    {
        const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(p - kReach_px)), glm::ivec2(0));
        const glm::ivec2 high = glm::min(glm::ivec2(glm::floor(p + kReach_px)), size_ - 1);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if (glm::distance(p, glm::dvec2(x + 0.5, y + 0.5)) <= kReach_px) is_set_[index(x, y)] = true;
    }
    bool holds(const glm::dvec2& p) const
    {
        const glm::ivec2 at(glm::floor(p));
        return at.x >= 0 && at.y >= 0 && at.x < size_.x && at.y < size_.y && is_set_[index(at.x, at.y)];
    }

 private:
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * size_.x + x; }

    glm::ivec2 size_;
    std::vector<bool> is_set_;
};

/// Calls `use(point, length)` along a polyline, step by step, for what is in the picture.
template <typename Use>
void walk(const JudgedLine& line, const Pinhole& pinhole, const Use& use)
{
    for (std::size_t i = 0; i + 1 < line.points_px.size(); ++i) {
        const glm::dvec2 a = line.points_px[i], b = line.points_px[i + 1];
        const double length = glm::distance(a, b);
        const int count = 1 + static_cast<int>(length / kStep_px);
        for (int k = 0; k < count; ++k) {
            const glm::dvec2 p = glm::mix(a, b, (k + 0.5) / count);
            if (pinhole.holds(p)) use(p, length / count);
        }
    }
}

struct Hit {
    double share = 1.0;  ///< Of the ray's given length.
    glm::dvec3 normal{0.0};
};

/// The triangles that hide something from one eye, around it.
class Blockers {
 public:
    Blockers() : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {}
    ~Blockers()
    {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Blockers(const Blockers&) = delete;
    Blockers& operator=(const Blockers&) = delete;

    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    {
        for (const glm::dvec3& p : {a, b, c}) positions_.emplace_back(p);
    }
    void commit()
    {
        const std::size_t count = positions_.size() / 3;
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), positions_.size()));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
        std::copy(positions_.begin(), positions_.end(), vertices);
        for (std::uint32_t i = 0; i < 3 * count; ++i) indices[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
    }

    /// The first triangle on the way from the eye, not beyond `most` of it.
    std::optional<Hit> first(const glm::dvec3& way, double most) const
    {
        ++rays;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit ray{};
        ray.ray.dir_x = static_cast<float>(way.x);
        ray.ray.dir_y = static_cast<float>(way.y);
        ray.ray.dir_z = static_cast<float>(way.z);
        ray.ray.tfar = static_cast<float>(most);
        ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
        const glm::dvec3 normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
        return Hit{ray.ray.tfar, glm::normalize(normal)};
    }

    mutable std::uint64_t rays = 0;

 private:
    std::vector<glm::vec3> positions_;
    RTCDevice device_;
    RTCScene scene_;
};

/// How far the surface that is seen on both sides of an edge is from one plane, in which no line is to be.
struct Bend {
    double cosine = -1.0;  ///< Between the normals.
    double step = 1.0;     ///< Off the plane, of the distance.

    bool may_be_none() const { return cosine >= kStraightCosine && step < kStraightShare; }
    bool is_surely_none() const { return cosine >= kFlatCosine && step < kFlatShare; }
};

Bend bend_at(const Blockers& blockers, const Pinhole& pinhole, const glm::dvec2& at, const glm::dvec2& across)
{
    constexpr double kFar = 1e9;
    const glm::dvec3 left_way = pinhole.ray(at - kBeside_px * across);
    const glm::dvec3 right_way = pinhole.ray(at + kBeside_px * across);
    const auto left = blockers.first(left_way, kFar), right = blockers.first(right_way, kFar);
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
    thinned_px += other.thinned_px;
    found_px += other.found_px;
    extra_px += other.extra_px;
    unjudged_px += other.unjudged_px;
    rays += other.rays;
}

RayJudge::RayJudge(const Scene& scene, double crease_rad)
{
    for (ObjectId id = 0; id < scene.objects.size(); ++id) add_object(scene, id, crease_rad);
}

void RayJudge::add_object(const Scene& scene, ObjectId id, double crease_rad)
{
    const Object& object = scene.objects[id];
    const MeshData& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    const Material& material = scene.materials[static_cast<std::size_t>(object.material)];
    const glm::dmat4& matrix = scene.world_from_object(id);
    const bool is_mirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
    const bool hides = material.alpha_mode != AlphaMode::blend;
    for (std::size_t i = 0; hides && i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
        };
        const glm::dvec3 a = corner(0), b = corner(is_mirrored ? 2 : 1), c = corner(is_mirrored ? 1 : 2);
        triangles_.push_back({a, b, c, !material.is_double_sided});
    }
    const std::vector<JudgedEdge> edges = judged_edges(scene, id, crease_rad);
    edges_.insert(edges_.end(), edges.begin(), edges.end());
}

/// One view that is being judged.
struct RayJudge::Look {
    Look(const RayJudge& judge, const JudgeCamera& camera, std::span<const JudgedLine> found,
         std::span<const JudgedLine> drawn)
        : eye(camera.eye_world),
          pinhole(camera),
          is_found(camera.size_px),
          is_drawn(camera.size_px),
          may_be(camera.size_px)
    {
        for (const Triangle& t : judge.triangles_) {
            const glm::dvec3 a = t.a - eye, b = t.b - eye, c = t.c - eye;
            if (!t.is_culled || glm::dot(glm::cross(b - a, c - a), a) < 0.0) blockers.add(a, b, c);
        }
        blockers.commit();
        for (const JudgedLine& line : found) walk(line, pinhole, [&](const auto& p, double) { is_found.add(p); });
        for (const JudgedLine& line : drawn) walk(line, pinhole, [&](const auto& p, double) { is_drawn.add(p); });
    }

    void judge_sample(const JudgedEdge& edge, const glm::dvec3& way, const glm::dvec2& at, const glm::dvec2& across,
                      double length)
    {
        verdict.candidates_px += length;
        const auto before = blockers.first(way, kSeen);
        if (before && before->share < kHidden) return;
        const Bend bend = bend_at(blockers, pinhole, at, across);
        if (!bend.is_surely_none()) may_be.add(at);
        if (before || !edge.is_sure || bend.may_be_none()) return;
        verdict.visible_px += length;
        if (!is_found.holds(at)) {
            verdict.missed_px += length;
            show(at, judged_missed);
        } else if (!is_drawn.holds(at)) {
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
        walk(line, pinhole, [&](const glm::dvec2& p, double length) {
            (line.is_intersection ? verdict.unjudged_px : verdict.found_px) += length;
            const bool is_extra = !line.is_intersection && !may_be.holds(p);
            if (is_extra) verdict.extra_px += length;
            show(p, is_extra ? judged_extra : judged_found);
        });
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
    Blockers blockers;
    Mask is_found, is_drawn, may_be;
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
    look.verdict.rays = look.blockers.rays;
    return look.verdict;
}

}  // namespace hw
