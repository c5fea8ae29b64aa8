#include "hatchway/world/light/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <numeric>

#include "hatchway/world/light/random.hpp"

namespace hw {
namespace {

constexpr float kReach = 1.4143f;    // a picture's point blends luxels whose middles are nearer than 1 along u and v
constexpr float kOffEdge = 0.05f;    // luxels that a point taken to the chart's edge stays inside, off a wall there
constexpr float kMostLiftM = 0.02f;  // height over the surface at which walls are looked for
constexpr float kLiftLuxels = 0.25f;
constexpr float kVertexReach = 0.35f;  // of the way to a triangle's middle that a vertex stands for
constexpr std::uint32_t kBuriedRays = 16;
constexpr int kWallRays = 8;
constexpr float kWallReach = 0.75f;  // luxels: a little more than to the corner of one

// The middle comes first, and a little beside it: walls like to stand on round numbers, and so do the middles of
// luxels.
constexpr std::array<glm::vec2, 9> kTries{{{0.513f, 0.483f},
                                           {0.17f, 0.48f},
                                           {0.83f, 0.52f},
                                           {0.52f, 0.17f},
                                           {0.48f, 0.83f},
                                           {0.16f, 0.15f},
                                           {0.84f, 0.16f},
                                           {0.15f, 0.84f},
                                           {0.85f, 0.83f}}};

struct FlatTriangle {
    std::array<glm::vec2, 3> corners;

    float doubled_area() const
    {
        const glm::vec2 a = corners[1] - corners[0];
        const glm::vec2 b = corners[2] - corners[0];
        return a.x * b.y - a.y * b.x;
    }
    glm::vec3 barycentric(const glm::vec2& p) const
    {
        const auto cross = [](const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; };
        const float area = doubled_area();
        const float b = cross(p - corners[0], corners[2] - corners[0]) / area;
        const float c = cross(corners[1] - corners[0], p - corners[0]) / area;
        return {1.0f - b - c, b, c};
    }
    /// The point of the triangle that is nearest to p.
    glm::vec2 nearest(const glm::vec2& p) const
    {
        const glm::vec3 weights = barycentric(p);
        if (weights.x >= 0.0f && weights.y >= 0.0f && weights.z >= 0.0f) return p;
        glm::vec2 best = corners[0];
        for (int k = 0; k < 3; ++k) {
            const glm::vec2 from = corners[k];
            const glm::vec2 way = corners[(k + 1) % 3] - from;
            const float share = glm::clamp(glm::dot(p - from, way) / std::max(glm::dot(way, way), 1e-20f), 0.0f, 1.0f);
            const glm::vec2 at = from + share * way;
            if (glm::distance(at, p) < glm::distance(best, p)) best = at;
        }
        return best;
    }
};

FlatTriangle flat_triangle(const LightmapLayout& layout, std::uint32_t t)
{
    const std::uint32_t* index = &layout.indices[t * 3];
    return {{layout.uv[index[0]], layout.uv[index[1]], layout.uv[index[2]]}};
}

/// Lists of numbers, one for each of a range of keys.
struct Lists {
    std::vector<std::uint32_t> first{0};
    std::vector<std::uint32_t> values;

    Lists() = default;
    Lists(std::size_t keys, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs)
    {
        std::sort(pairs.begin(), pairs.end());
        first.assign(keys + 1, 0);
        for (const auto& [key, value] : pairs) {
            ++first[key + 1];
            values.push_back(value);
        }
        std::partial_sum(first.begin(), first.end(), first.begin());
    }
    std::span<const std::uint32_t> of(std::size_t key) const
    {
        return std::span(values).subspan(first[key], first[key + 1] - first[key]);
    }
};

}  // namespace

struct LuxelPoints::MeshLuxels {
    Lists triangles;                             // that a luxel stands for, or that meet at a vertex
    std::vector<std::uint32_t> chart_of_vertex;  // of the layout's vertices
    std::uint32_t chart_count = 1;

    void add_charts(const MeshData& mesh, const LightmapLayout& layout);
    void add_vertices(const MeshData& mesh);
};

struct LuxelPoints::Instance {
    glm::dmat4 local_from_object{1.0};  // world, relative to the rays' origin
    glm::dmat3 normal_from_object{1.0};
    float handedness = 1.0f;
};

void LuxelPoints::MeshLuxels::add_vertices(const MeshData& mesh)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) pairs.emplace_back(mesh.indices[i], i / 3);
    triangles = Lists(mesh.positions.size(), std::move(pairs));
}

void LuxelPoints::MeshLuxels::add_charts(const MeshData& mesh, const LightmapLayout& layout)
{
    std::vector<std::uint32_t> root(layout.uv.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const FlatTriangle flat = flat_triangle(layout, t);
        const std::uint32_t* index = &layout.indices[t * 3];
        root[find(index[1])] = find(index[0]);
        root[find(index[2])] = find(index[0]);
        if (std::abs(flat.doubled_area()) < 1e-12f) continue;
        const glm::vec2 low = glm::min(flat.corners[0], glm::min(flat.corners[1], flat.corners[2]));
        const glm::vec2 high = glm::max(flat.corners[0], glm::max(flat.corners[1], flat.corners[2]));
        const glm::ivec2 from = glm::max(glm::ivec2(glm::floor(low - 1.5f)), glm::ivec2(0));
        const glm::ivec2 to = glm::min(glm::ivec2(glm::ceil(high + 1.5f)), layout.size - 1);
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) {
                const glm::vec2 middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                if (glm::distance(flat.nearest(middle), middle) < kReach)
                    pairs.emplace_back(static_cast<std::uint32_t>(y * layout.size.x + x), t);
            }
    }
    triangles = Lists(static_cast<std::size_t>(layout.size.x) * layout.size.y, std::move(pairs));
    for (std::uint32_t v = 0; v < root.size(); ++v) chart_of_vertex.push_back(find(v));
    chart_count = static_cast<std::uint32_t>(root.size());
}

LuxelPoints::LuxelPoints(const Scene& scene, const Lightmap& lightmap, const LightScene& light_scene)
    : scene_(scene),
      lightmap_(lightmap),
      light_scene_(light_scene),
      luxel_m_(static_cast<float>(1.0 / lightmap.luxels_per_m)),
      meshes_(scene.meshes.size()),
      instances_(scene.objects.size())
{
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
        if (lightmap.layouts[i].is_empty()) continue;
        if (lightmap.layouts[i].is_per_vertex)
            meshes_[i].add_vertices(scene.meshes[i]);
        else
            meshes_[i].add_charts(scene.meshes[i], lightmap.layouts[i]);
    }
    std::uint32_t charts = 0;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        Instance& instance = instances_[id];
        instance.local_from_object = scene.world_from_object(id);
        instance.local_from_object[3] -= glm::dvec4(light_scene.origin_world(), 0.0);
        instance.normal_from_object = glm::transpose(glm::inverse(glm::dmat3(instance.local_from_object)));
        instance.handedness = glm::determinant(glm::dmat3(instance.local_from_object)) < 0.0 ? -1.0f : 1.0f;
        for (int side = 0; side < lightmap.places[id].sides; ++side) {
            add_luxels(id, side == 1, charts);
            charts += meshes_[scene.objects[id].mesh].chart_count;
        }
    }
}

LuxelPoints::~LuxelPoints() = default;

std::vector<bool> LuxelPoints::charted_objects() const
{
    std::vector<bool> result;
    for (const Object& object : scene_.objects) result.push_back(!lightmap_.layouts[object.mesh].is_per_vertex);
    return result;
}

void LuxelPoints::add_luxels(ObjectId id, bool is_back, std::uint32_t first_chart)
{
    const LightmapLayout& layout = lightmap_.layouts[scene_.objects[id].mesh];
    const MeshLuxels& mesh = meshes_[scene_.objects[id].mesh];
    const LightmapPlace& place = lightmap_.places[id];
    const std::size_t count = mesh.triangles.first.size() - 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (mesh.triangles.of(i).empty()) continue;
        Luxel luxel{.object = id, .chart = first_chart, .is_back = is_back};
        if (layout.is_per_vertex) {
            luxel.at = {static_cast<int>(i), 0};
            luxel.place = static_cast<std::uint32_t>(place.corner.y * lightmap_.size.x + place.corner.x) + i +
                          (is_back ? static_cast<std::uint32_t>(count) : 0u);
        } else {
            luxel.at = {static_cast<int>(i) % layout.size.x, static_cast<int>(i) / layout.size.x};
            const glm::ivec2 at = place.corner + luxel.at + glm::ivec2(is_back ? layout.size.x : 0, 0);
            luxel.place = static_cast<std::uint32_t>(at.y * lightmap_.size.x + at.x);
            luxel.chart += mesh.chart_of_vertex[layout.indices[mesh.triangles.of(i).front() * 3]];
        }
        luxels_.push_back(luxel);
    }
}

LightReceiver LuxelPoints::receiver_at(const Luxel& luxel, std::uint32_t triangle, const glm::vec3& weights) const
{
    const MeshData& mesh = scene_.meshes[scene_.objects[luxel.object].mesh];
    const Instance& instance = instances_[luxel.object];
    const std::uint32_t* index = &mesh.indices[triangle * 3];
    std::array<glm::dvec3, 3> corner;
    glm::dvec3 position(0.0);
    glm::dvec3 normal(0.0);
    for (int k = 0; k < 3; ++k) {
        corner[k] = glm::dvec3(instance.local_from_object * glm::dvec4(glm::dvec3(mesh.positions[index[k]]), 1.0));
        position += static_cast<double>(weights[k]) * corner[k];
        if (!mesh.normals.empty()) normal += static_cast<double>(weights[k]) * glm::dvec3(mesh.normals[index[k]]);
    }
    const double side = luxel.is_back ? -1.0 : 1.0;
    glm::dvec3 face = glm::cross(corner[1] - corner[0], corner[2] - corner[0]) * side;
    face *= instance.handedness;
    const double length = glm::length(face);
    LightReceiver receiver;
    receiver.position = glm::vec3(position);
    if (length > 0.0) receiver.face_normal = glm::vec3(face / length);
    receiver.shading_normal = receiver.face_normal;
    normal = instance.normal_from_object * normal * side;
    if (!(glm::length(normal) > 0.0)) return receiver;
    const glm::vec3 shading(glm::normalize(normal));
    if (glm::dot(shading, receiver.face_normal) > 0.1f) receiver.shading_normal = shading;
    return receiver;
}

LightReceiver LuxelPoints::vertex_receiver(const Luxel& luxel, const glm::vec2& share) const
{
    const int mesh_index = scene_.objects[luxel.object].mesh;
    const MeshData& mesh = scene_.meshes[mesh_index];
    const auto vertex = static_cast<std::uint32_t>(luxel.at.x);
    const std::span<const std::uint32_t> triangles = meshes_[mesh_index].triangles.of(vertex);
    const std::uint32_t triangle = triangles[std::min(
        triangles.size() - 1, static_cast<std::size_t>(share.x * static_cast<float>(triangles.size())))];
    const std::uint32_t* index = &mesh.indices[triangle * 3];
    const glm::vec3 middle = (mesh.positions[index[0]] + mesh.positions[index[1]] + mesh.positions[index[2]]) / 3.0f;
    const glm::dmat3 matrix(instances_[luxel.object].local_from_object);
    const auto distance = static_cast<float>(glm::length(matrix * glm::dvec3(middle - mesh.positions[vertex])));
    const float most = distance > 0.0f ? std::min(kVertexReach, 0.5f * luxel_m_ / distance) : 0.0f;
    const float way = most * (0.1f + 0.9f * share.y);
    glm::vec3 weights(way / 3.0f);
    glm::vec3 at_vertex(0.0f);
    for (int k = 0; k < 3; ++k) {
        if (index[k] != vertex) continue;
        weights[k] += 1.0f - way;
        at_vertex[k] = 1.0f;
        break;
    }
    LightReceiver receiver = receiver_at(luxel, triangle, weights);
    receiver.shading_normal = receiver_at(luxel, triangle, at_vertex).shading_normal;
    return receiver;
}

glm::vec2 LuxelPoints::nearest_on_chart(const Luxel& luxel, const glm::vec2& wanted, std::uint32_t& triangle) const
{
    const int mesh_index = scene_.objects[luxel.object].mesh;
    const LightmapLayout& layout = lightmap_.layouts[mesh_index];
    const auto key = static_cast<std::size_t>(luxel.at.y) * layout.size.x + luxel.at.x;
    float distance = std::numeric_limits<float>::infinity();
    glm::vec2 found(0.0f);
    for (const std::uint32_t t : meshes_[mesh_index].triangles.of(key)) {
        const glm::vec2 at = flat_triangle(layout, t).nearest(wanted);
        if (glm::distance(at, wanted) >= distance) continue;
        distance = glm::distance(at, wanted);
        triangle = t;
        found = at;
        if (distance == 0.0f) break;
    }
    return found;
}

LightReceiver LuxelPoints::receiver(const Luxel& luxel, const glm::vec2& share) const
{
    const LightmapLayout& layout = lightmap_.layouts[scene_.objects[luxel.object].mesh];
    if (layout.is_per_vertex) return vertex_receiver(luxel, share);
    const glm::vec2 wanted = glm::vec2(luxel.at) + share;
    std::uint32_t triangle = 0;
    glm::vec2 found = nearest_on_chart(luxel, wanted, triangle);
    const FlatTriangle flat = flat_triangle(layout, triangle);
    if (found != wanted) {
        const glm::vec2 inward = (flat.corners[0] + flat.corners[1] + flat.corners[2]) / 3.0f - found;
        const float length = glm::length(inward);
        if (length > 0.0f) found += inward * std::min(0.5f, kOffEdge / length);
    }
    const glm::vec3 weights = glm::max(flat.barycentric(found), 0.0f);
    return receiver_at(luxel, triangle, weights / (weights.x + weights.y + weights.z));
}

bool LuxelPoints::is_buried(const LightReceiver& receiver, std::uint32_t seed) const
{
    const glm::vec3 from = receiver.position + receiver.face_normal * light_scene_.clearance_m();
    std::uint32_t backs = 0;
    for (std::uint32_t i = 0; i < kBuriedRays; ++i) {
        const auto hit = light_scene_.first_hit(from, cosine_direction(receiver.face_normal, sample_2d(i, 1, seed)));
        if (hit && hit->is_back) ++backs;
    }
    return 2 * backs > kBuriedRays;
}

glm::vec3 LuxelPoints::lifted(const LightReceiver& receiver) const
{
    return receiver.position + receiver.face_normal * std::min(kMostLiftM, kLiftLuxels * luxel_m_);
}

bool LuxelPoints::has_wall_near(const LightReceiver& receiver) const
{
    const glm::vec3 any =
        std::abs(receiver.face_normal.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 u = glm::normalize(glm::cross(receiver.face_normal, any));
    const glm::vec3 v = glm::cross(receiver.face_normal, u);
    for (int i = 0; i < kWallRays; ++i) {
        const float angle = 2.0f * glm::pi<float>() * (static_cast<float>(i) + 0.37f) / kWallRays;
        const glm::vec3 way = std::cos(angle) * u + std::sin(angle) * v;
        if (light_scene_.is_blocked(lifted(receiver), way, kWallReach * luxel_m_)) return true;
    }
    return false;
}

LuxelPlace LuxelPoints::place(const Luxel& luxel) const
{
    LuxelPlace place;
    for (const glm::vec2& share : kTries) {
        place.receiver = receiver(luxel, share);
        place.is_buried = is_buried(place.receiver, mixed(luxel.place));
        if (!place.is_buried) break;
    }
    if (place.is_buried) return place;
    place.is_near_wall = has_wall_near(place.receiver);
    if (lightmap_.layouts[scene_.objects[luxel.object].mesh].is_per_vertex) return place;
    const glm::vec2 middle = glm::vec2(luxel.at) + 0.5f;
    std::uint32_t triangle = 0;
    const glm::vec2 mirrored = 2.0f * nearest_on_chart(luxel, middle, triangle) - middle;
    place.mirrored = glm::ivec2(glm::floor(mirrored)) - luxel.at;
    return place;
}

LightReceiver LuxelPoints::part(const Luxel& luxel, const LuxelPlace& place, const glm::vec2& share) const
{
    const LightReceiver wanted = receiver(luxel, share);
    if (!place.is_near_wall) return wanted;
    const glm::vec3 from = lifted(place.receiver);
    const glm::vec3 way = lifted(wanted) - from;
    const float distance = glm::length(way);
    if (!(distance > 0.0f) || light_scene_.is_blocked(from, way / distance, distance)) return place.receiver;
    return wanted;
}

bool LuxelPoints::are_parted(const LuxelPlace& a, const LuxelPlace& b) const
{
    const glm::vec3 from = lifted(a.receiver);
    const glm::vec3 way = lifted(b.receiver) - from;
    const float distance = glm::length(way);
    return distance > 0.0f && light_scene_.is_blocked(from, way / distance, distance);
}

}  // namespace hw
