// Embree's triangles are flattened into the world: a ray then meets the same floats that the luxels were placed on, and
// an edge that two triangles of different objects share is as tight as one within an object.
#include "hatchway/world/light/scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hatchway/core/error.hpp"
#include "hatchway/world/light/material.hpp"
#include "hatchway/world/open_backs.hpp"

namespace hw {
namespace {

constexpr float kMaxAlbedo = 0.98f;       // so that light in a closed white room dies out
constexpr double kClearanceShare = 3e-6;  // of the scene's radius: a few steps of single precision

/// What the filter of a masked object needs.
struct MaskedObject {
    const Scene* scene;
    ObjectId object;
};

/// Lets a ray through where the mask cuts the surface out.
void pass_cut_out(const RTCFilterFunctionNArguments* arguments)
{
    const auto* masked = static_cast<const MaskedObject*>(arguments->geometryUserPtr);
    const Object& object = masked->scene->objects[masked->object];
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] == 0) continue;
        const float u = RTCHitN_u(arguments->hit, arguments->N, i);
        const float v = RTCHitN_v(arguments->hit, arguments->N, i);
        const MaterialPoint point{*masked->scene,
                                  object.mesh,
                                  object.material,
                                  RTCHitN_primID(arguments->hit, arguments->N, i),
                                  {1.0f - u - v, u, v}};
        if (base_colour_at(point).a < masked->scene->materials[object.material].alpha_cutoff) arguments->valid[i] = 0;
    }
}

RTCRay ray_of(const glm::vec3& from, const glm::vec3& direction, float distance)
{
    RTCRay ray{};
    ray.org_x = from.x;
    ray.org_y = from.y;
    ray.org_z = from.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tfar = distance;
    ray.mask = 0xffffffffu;
    return ray;
}

}  // namespace

struct LightScene::Rays {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<ObjectId> object_of_geometry;
    std::vector<std::vector<glm::vec3>> positions;  // of each object that takes part, relative to the origin
    std::vector<bool> is_mirrored;                  // of each object
    std::vector<std::unique_ptr<MaskedObject>> masked;

    ~Rays()
    {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }
    void add(const Scene& scene_data, ObjectId id, const glm::dvec3& origin_world);
    std::array<glm::vec3, 3> corners(const Scene& scene_data, ObjectId object, std::uint32_t triangle) const
    {
        const MeshData& mesh = scene_data.meshes[scene_data.objects[object].mesh];
        const std::uint32_t* index = &mesh.indices[triangle * 3];
        return {positions[object][index[0]], positions[object][index[1]], positions[object][index[2]]};
    }
    glm::vec3 front_normal(const Scene& scene_data, ObjectId object, std::uint32_t triangle) const
    {
        const auto [a, b, c] = corners(scene_data, object, triangle);
        const glm::vec3 normal = glm::cross(b - a, c - a);
        const float length = glm::length(normal);
        if (!(length > 0.0f)) return {0.0f, 1.0f, 0.0f};
        return normal * ((is_mirrored[object] ? -1.0f : 1.0f) / length);
    }
};

void LightScene::Rays::add(const Scene& scene_data, ObjectId id, const glm::dvec3& origin_world)
{
    const Object& object = scene_data.objects[id];
    const MeshData& mesh = scene_data.meshes[object.mesh];
    const glm::dmat4& matrix = scene_data.world_from_object(id);
    is_mirrored[id] = glm::determinant(glm::dmat3(matrix)) < 0.0;
    positions[id].reserve(mesh.positions.size());
    for (const glm::vec3& position : mesh.positions)
        positions[id].emplace_back(glm::dvec3(matrix * glm::dvec4(glm::dvec3(position), 1.0)) - origin_world);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), positions[id].size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangle_count()));
    if (!vertices || !indices)
        throw Error(
            {.what = "there is no memory for the scene's rays", .file = scene_data.file, .fault = Fault::device});
    std::copy(positions[id].begin(), positions[id].end(), vertices);
    std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
    if (scene_data.materials[object.material].alpha_mode == AlphaMode::mask) {
        masked.push_back(std::make_unique<MaskedObject>(MaskedObject{&scene_data, id}));
        rtcSetGeometryUserData(geometry, masked.back().get());
        rtcSetGeometryIntersectFilterFunction(geometry, pass_cut_out);
        rtcSetGeometryOccludedFilterFunction(geometry, pass_cut_out);
    }
    rtcCommitGeometry(geometry);
    HW_ASSERT(rtcAttachGeometry(scene, geometry) == object_of_geometry.size());
    rtcReleaseGeometry(geometry);
    object_of_geometry.push_back(id);
}

bool receives_light(const Scene& scene, ObjectId id)
{
    const Object& object = scene.objects[id];
    return !scene.materials[object.material].is_unlit && !scene.meshes[object.mesh].indices.empty();
}

bool blocks_light(const Scene& scene, ObjectId id)
{
    const Object& object = scene.objects[id];
    return receives_light(scene, id) && scene.materials[object.material].alpha_mode != AlphaMode::blend &&
           !scene.nodes[object.node].is_animated;
}

LightScene::LightScene(const Scene& scene, std::span<const Light> lights, std::span<const glm::dvec3> eyes_world)
    : scene_(scene), open_backs_(find_open_backs(scene, lights, eyes_world)), rays_(std::make_unique<Rays>())
{
    Box box;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        if (!blocks_light(scene, id)) continue;
        const glm::dmat4& matrix = scene.world_from_object(id);
        for (const glm::vec3& position : scene.meshes[scene.objects[id].mesh].positions)
            box.add(glm::dvec3(matrix * glm::dvec4(glm::dvec3(position), 1.0)));
    }
    if (!box.is_empty()) origin_world_ = box.centre();
    const double radius_m = box.is_empty() ? 1.0 : 0.5 * glm::length(box.size());
    lamps_ = LampChoice(lights, origin_world_, std::max(0.5 * radius_m, 1e-6));
    clearance_m_ = static_cast<float>(kClearanceShare * radius_m);

    rays_->device = rtcNewDevice(nullptr);
    if (!rays_->device) throw Error({.what = "Embree does not start", .fault = Fault::device});
    rays_->scene = rtcNewScene(rays_->device);
    rtcSetSceneFlags(rays_->scene, RTC_SCENE_FLAG_ROBUST);
    rays_->positions.resize(scene.objects.size());
    rays_->is_mirrored.resize(scene.objects.size());
    for (const Material& material : scene.materials) mean_emission_.push_back(mean_emission(scene, material));
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        if (!blocks_light(scene, id)) continue;
        rays_->add(scene, id, origin_world_);
        add_emitters(id);
    }
    rtcCommitScene(rays_->scene);
}

LightScene::~LightScene() = default;

void LightScene::add_emitters(ObjectId id)
{
    const float emission = mean_emission_[scene_.objects[id].material];
    if (!(emission > 0.0f)) return;
    const std::size_t count = scene_.meshes[scene_.objects[id].mesh].triangle_count();
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
        const auto [a, b, c] = rays_->corners(scene_, id, triangle);
        const float power = 0.5f * glm::length(glm::cross(b - a, c - a)) * emission;
        if (!(power > 0.0f)) continue;
        emitters_.push_back({id, triangle, (emitters_.empty() ? 0.0f : emitters_.back().power_so_far) + power});
    }
}

std::optional<LightHit> LightScene::first_hit(const glm::vec3& from, const glm::vec3& direction) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray = ray_of(from, direction, std::numeric_limits<float>::infinity());
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(rays_->scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    LightHit hit;
    hit.object = rays_->object_of_geometry[ray.hit.geomID];
    hit.triangle = ray.hit.primID;
    hit.barycentric = {1.0f - ray.hit.u - ray.hit.v, ray.hit.u, ray.hit.v};
    const auto [a, b, c] = rays_->corners(scene_, hit.object, hit.triangle);
    hit.position = hit.barycentric.x * a + hit.barycentric.y * b + hit.barycentric.z * c;
    hit.normal = rays_->front_normal(scene_, hit.object, hit.triangle);
    const bool is_behind = glm::dot(hit.normal, direction) > 0.0f;
    if (is_behind) hit.normal = -hit.normal;
    hit.is_back = is_behind && !is_double_sided(hit.object);
    return hit;
}

bool LightScene::is_blocked(const glm::vec3& from, const glm::vec3& direction, float distance) const
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = ray_of(from, direction, distance);
    rtcOccluded1(rays_->scene, &context, &ray);
    return ray.tfar < 0.0f;
}

glm::vec3 LightScene::albedo(const LightHit& hit) const
{
    const Object& object = scene_.objects[hit.object];
    const glm::vec3 colour(base_colour_at({scene_, object.mesh, object.material, hit.triangle, hit.barycentric}));
    return glm::clamp(colour, 0.0f, kMaxAlbedo);
}

glm::vec3 LightScene::emission(const LightHit& hit) const
{
    const Object& object = scene_.objects[hit.object];
    if (hit.is_back || !(mean_emission_[object.material] > 0.0f)) return glm::vec3(0.0f);
    return emission_at({scene_, object.mesh, object.material, hit.triangle, hit.barycentric});
}

bool LightScene::is_double_sided(ObjectId object) const
{
    return open_backs_[object];
}

float LightScene::emitter_density(ObjectId object) const
{
    if (emitters_.empty()) return 0.0f;
    return mean_emission_[scene_.objects[object].material] / emitters_.back().power_so_far;
}

LightHit LightScene::point_of(const Emitter& emitter, const glm::vec2& share) const
{
    const float root = std::sqrt(share.x);
    LightHit hit;
    hit.object = emitter.object;
    hit.triangle = emitter.triangle;
    hit.barycentric = {1.0f - root, root * (1.0f - share.y), root * share.y};
    const auto [a, b, c] = rays_->corners(scene_, hit.object, hit.triangle);
    hit.position = hit.barycentric.x * a + hit.barycentric.y * b + hit.barycentric.z * c;
    hit.normal = rays_->front_normal(scene_, hit.object, hit.triangle);
    return hit;
}

}  // namespace hw
