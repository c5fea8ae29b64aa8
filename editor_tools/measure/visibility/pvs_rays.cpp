#include "measure/visibility/pvs_rays.hpp"

#include <embree3/rtcore.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

namespace hw::measure {
namespace {

using Rational3 = std::array<mpq_class, 3>;

Rational3 rational(const glm::dvec3& p)
{
    return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
}

Rational3 difference(const Rational3& a, const Rational3& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational3 cross(const Rational3& a, const Rational3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpq_class dot(const Rational3& a, const Rational3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Crossing {
    mpq_class along;         ///< In units of the direction.
    bool is_inside = false;  ///< Strictly; false: on an edge or a corner.
    bool from_front = false;
};

/// Where a ray crosses a closed triangle; nothing if it misses it or runs within its plane.
std::optional<Crossing> exact_crossing(const SightTriangle& triangle, const Rational3& origin,
                                       const Rational3& direction)
{
    const Rational3 a = rational(triangle.a), b = rational(triangle.b), c = rational(triangle.c);
    const Rational3 normal = cross(difference(b, a), difference(c, a));
    const mpq_class slope = dot(normal, direction);
    if (sgn(slope) == 0) return std::nullopt;
    Crossing crossing;
    crossing.along = dot(normal, difference(a, origin)) / slope;
    crossing.from_front = sgn(slope) < 0;
    if (sgn(crossing.along) <= 0) return std::nullopt;
    const Rational3 point{origin[0] + crossing.along * direction[0], origin[1] + crossing.along * direction[1],
                          origin[2] + crossing.along * direction[2]};
    crossing.is_inside = true;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
        const int side = sgn(dot(cross(difference(*to, *from), difference(point, *from)), normal));
        if (side < 0) return std::nullopt;
        if (side == 0) crossing.is_inside = false;
    }
    return crossing;
}

/// A generous test in floating point: false only where the ray surely misses.
bool may_cross(const SightTriangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction)
{
    const glm::dvec3 a = triangle.a - origin, b = triangle.b - origin, c = triangle.c - origin;
    const double u = glm::dot(glm::cross(a, b), direction);
    const double v = glm::dot(glm::cross(b, c), direction);
    const double w = glm::dot(glm::cross(c, a), direction);
    const double scale = (glm::length(a) + glm::length(b) + glm::length(c));
    const double unsure = 1e-13 * scale * scale * glm::length(direction);
    const bool all_up = u > -unsure && v > -unsure && w > -unsure;
    const bool all_down = u < unsure && v < unsure && w < unsure;
    return all_up || all_down;
}

bool is_drawn_from(const SightTriangle& triangle, bool from_front)
{
    return from_front || triangle.is_double_sided;
}

}  // namespace

std::vector<SightTriangle> sight_triangles(const Scene& scene, std::span<const MeshChunks> chunks_of_mesh)
{
    std::vector<SightTriangle> result;
    std::uint32_t slot = 0;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const Object& object = scene.objects[id];
        const MeshData& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(object.material)];
        const bool is_static = !scene.nodes[static_cast<std::size_t>(object.node)].is_animated;
        const glm::dmat4& matrix = scene.world_from_object(id);
        const bool is_mirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
        for (const MeshChunk& chunk : chunks_of_mesh[static_cast<std::size_t>(object.mesh)]) {
            for (std::uint32_t i = chunk.first_index; i < chunk.first_index + chunk.index_count; i += 3) {
                const auto corner = [&](std::uint32_t k) {
                    return glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
                };
                SightTriangle triangle{corner(0),
                                       corner(1),
                                       corner(2),
                                       slot,
                                       material.is_double_sided,
                                       is_static && material.alpha_mode == AlphaMode::opaque};
                if (is_mirrored) std::swap(triangle.b, triangle.c);
                const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
                if (glm::dot(normal, normal) > 0.0) result.push_back(triangle);
            }
            ++slot;
        }
    }
    return result;
}

struct SightRays::Embree {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    Embree() = default;
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    ~Embree()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
};

SightRays::SightRays(std::span<const SightTriangle> triangles) : triangles_(triangles), embree_(new Embree)
{
    RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::array<glm::dvec3, 3> corners{triangles[i].a, triangles[i].b, triangles[i].c};
        for (std::size_t k = 0; k < 3; ++k) {
            for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(corners[k][axis]);
            *indices++ = static_cast<unsigned>(3 * i + k);
        }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(embree_->scene);
}

SightRays::~SightRays()
{
    delete embree_;
}

void SightRays::trace(const glm::dvec3& origin, const glm::dvec3& direction, std::vector<std::uint32_t>& met) const
{
    constexpr int kMostCrossings = 256;
    met.clear();
    float from = 0.0f;
    for (int crossing = 0; crossing < kMostCrossings; ++crossing) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit ray{};
        ray.ray.org_x = static_cast<float>(origin.x);
        ray.ray.org_y = static_cast<float>(origin.y);
        ray.ray.org_z = static_cast<float>(origin.z);
        ray.ray.dir_x = static_cast<float>(direction.x);
        ray.ray.dir_y = static_cast<float>(direction.y);
        ray.ray.dir_z = static_cast<float>(direction.z);
        ray.ray.tnear = from;
        ray.ray.tfar = std::numeric_limits<float>::infinity();
        ray.ray.mask = ~0u;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(embree_->scene, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
        const SightTriangle& triangle = triangles_[ray.hit.primID];
        const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
        const bool is_drawn = is_drawn_from(triangle, glm::dot(normal, direction) < 0.0);
        if (is_drawn) met.push_back(ray.hit.primID);
        if (is_drawn && triangle.blocks) return;
        from = std::nextafter(ray.ray.tfar * 1.000001f, std::numeric_limits<float>::infinity());
    }
}

bool is_seen_exactly(std::span<const SightTriangle> triangles, const glm::dvec3& origin, const glm::dvec3& direction,
                     std::uint32_t target)
{
    const Rational3 from = rational(origin);
    const Rational3 way = rational(direction);
    const auto reached = exact_crossing(triangles[target], from, way);
    if (!reached || !reached->is_inside || !is_drawn_from(triangles[target], reached->from_front)) return false;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (i == target || !triangles[i].blocks || !may_cross(triangles[i], origin, direction)) continue;
        const auto met = exact_crossing(triangles[i], from, way);
        if (met && met->along <= reached->along && is_drawn_from(triangles[i], met->from_front)) return false;
    }
    return true;
}

}  // namespace hw::measure
