#include "measure/lines/eye_rays.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace hw {

Pinhole::Pinhole(const JudgeCamera& camera) : size_px(camera.size_px), near_m(camera.near_m)
{
    forward = glm::normalize(camera.target_world - camera.eye_world);
    right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
    const double c = std::cos(camera.roll_rad), s = std::sin(camera.roll_rad);
    right = c * right + s * glm::cross(right, forward);
    up = glm::cross(right, forward);
    focal_px = 0.5 * size_px.y / std::tan(0.5 * camera.fov_rad);
}

double Pinhole::depth(const glm::dvec3& way) const
{
    return glm::dot(way, forward);
}

glm::dvec2 Pinhole::project(const glm::dvec3& way) const
{
    return 0.5 * glm::dvec2(size_px) + focal_px / depth(way) * glm::dvec2(glm::dot(way, right), -glm::dot(way, up));
}

glm::dvec3 Pinhole::ray(const glm::dvec2& at_px) const
{
    const glm::dvec2 off = at_px - 0.5 * glm::dvec2(size_px);
    return glm::normalize(focal_px * forward + off.x * right - off.y * up);
}

bool Pinhole::holds(const glm::dvec2& at_px) const
{
    return at_px.x >= 0.0 && at_px.y >= 0.0 && at_px.x < size_px.x && at_px.y < size_px.y;
}

std::vector<HidingTriangle> hiding_triangles(const Scene& scene)
{
    std::vector<HidingTriangle> triangles;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
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
            triangles.push_back({a, b, c, !material.is_double_sided});
        }
    }
    return triangles;
}

struct EyeRays::Device {
    Device() : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {}
    ~Device()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    RTCDevice device;
    RTCScene scene;
};

EyeRays::~EyeRays() = default;

EyeRays::EyeRays(std::span<const HidingTriangle> triangles, const glm::dvec3& eye) : device_(std::make_unique<Device>())
{
    std::vector<glm::vec3> positions;
    for (const HidingTriangle& t : triangles) {
        const glm::dvec3 a = t.a - eye, b = t.b - eye, c = t.c - eye;
        if (t.is_culled && glm::dot(glm::cross(b - a, c - a), a) >= 0.0) continue;
        for (const glm::dvec3& p : {a, b, c}) positions.emplace_back(p);
    }
    const std::size_t count = positions.size() / 3;
    RTCGeometry geometry = rtcNewGeometry(device_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), positions.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), count));
    std::copy(positions.begin(), positions.end(), vertices);
    for (std::uint32_t i = 0; i < 3 * count; ++i) indices[i] = i;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(device_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(device_->scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(device_->scene);
}

std::optional<Hit> EyeRays::first(const glm::dvec3& way, double most) const
{
    ++count_;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray.dir_x = static_cast<float>(way.x);
    ray.ray.dir_y = static_cast<float>(way.y);
    ray.ray.dir_z = static_cast<float>(way.z);
    ray.ray.tfar = static_cast<float>(most);
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(device_->scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const glm::dvec3 normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
    return Hit{ray.ray.tfar, glm::normalize(normal)};
}

}  // namespace hw
