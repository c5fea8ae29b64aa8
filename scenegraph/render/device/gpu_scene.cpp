#include "hatchway/render/device/gpu_scene.hpp"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numeric>

#include "hatchway/core/error.hpp"
#include "hatchway/style/colour.hpp"

namespace hw {
namespace {

constexpr std::size_t kSampledTriangles = 4096;
constexpr int kSampledRows = 32;

/// Appends one stream's values to interleaved vertices.
class Interleaver {
 public:
    explicit Interleaver(std::size_t vertex_count) : count_(vertex_count) {}
    void add(VertexInput input, const float* values, int components)
    {
        parts_.push_back({input, values, components});
        stride_ += components;
    }
    std::vector<float> floats() const
    {
        std::vector<float> result(count_ * stride_);
        int offset = 0;
        for (const Part& part : parts_) {
            for (std::size_t v = 0; v < count_; ++v)
                std::memcpy(&result[v * stride_ + offset], part.values + v * part.components,
                            sizeof(float) * part.components);
            offset += part.components;
        }
        return result;
    }
    std::vector<VertexStream> streams(const GpuBuffer& buffer) const
    {
        std::vector<VertexStream> result;
        std::size_t offset = 0;
        for (const Part& part : parts_) {
            result.push_back({.input = part.input,
                              .buffer = &buffer,
                              .components = part.components,
                              .stride_bytes = static_cast<int>(stride_ * sizeof(float)),
                              .offset_bytes = offset});
            offset += part.components * sizeof(float);
        }
        return result;
    }

 private:
    struct Part {
        VertexInput input;
        const float* values;
        int components;
    };
    std::size_t count_;
    std::size_t stride_ = 0;
    std::vector<Part> parts_;
};

/// Median over (a sample of) the triangles of the square root of surface area over uv area.
float metres_per_uv(const MeshData& mesh)
{
    std::vector<float> ratios;
    const std::size_t step = std::max<std::size_t>(1, mesh.triangle_count() / kSampledTriangles);
    for (std::size_t t = 0; t < mesh.triangle_count(); t += step) {
        const std::uint32_t* corner = &mesh.indices[t * 3];
        const glm::vec3 a = mesh.positions[corner[0]];
        const float area = glm::length(glm::cross(mesh.positions[corner[1]] - a, mesh.positions[corner[2]] - a));
        const glm::vec2 u = mesh.uv0[corner[1]] - mesh.uv0[corner[0]];
        const glm::vec2 v = mesh.uv0[corner[2]] - mesh.uv0[corner[0]];
        const float uv_area = std::abs(u.x * v.y - u.y * v.x);
        if (area > 0.0f && uv_area > 0.0f) ratios.push_back(std::sqrt(area / uv_area));
    }
    if (ratios.empty()) return 1.0f;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle;
}

/// Coordinates as the vertex stage reads them: u, v and the vertex of the model.
std::vector<glm::vec3> hatch_stream(const HatchCoordinates& hatch)
{
    std::vector<glm::vec3> stream;
    stream.reserve(hatch.vertex.size());
    for (std::size_t i = 0; i < hatch.vertex.size(); ++i)
        stream.emplace_back(hatch.uv.empty() ? glm::vec2(0.0f) : hatch.uv[i], static_cast<float>(hatch.vertex[i]));
    return stream;
}

/// The mesh's own vertices, without coordinates.
HatchCoordinates no_coordinates(const MeshData& mesh)
{
    HatchCoordinates none;
    none.vertex.resize(mesh.positions.size());
    std::iota(none.vertex.begin(), none.vertex.end(), 0u);
    none.indices = mesh.indices;
    return none;
}

/// Three vertices for each triangle, so that a vertex tells its triangle: gl_PrimitiveID is not in ES.
HatchCoordinates loosened(const HatchCoordinates& hatch)
{
    HatchCoordinates loose;
    for (const std::uint32_t vertex : hatch.indices) {
        loose.indices.push_back(static_cast<std::uint32_t>(loose.indices.size()));
        loose.vertex.push_back(hatch.vertex[vertex]);
        if (!hatch.uv.empty()) loose.uv.push_back(hatch.uv[vertex]);
        if (!hatch.direction.empty()) loose.direction.push_back(hatch.direction[vertex]);
    }
    return loose;
}

/// The mesh with its vertices repeated as the coordinates need them.
MeshData repeated(const MeshData& mesh, const HatchCoordinates& hatch)
{
    MeshData result;
    const auto repeat = [&](const auto& from, auto& to) {
        if (from.empty()) return;
        for (const std::uint32_t vertex : hatch.vertex) to.push_back(from[vertex]);
    };
    repeat(mesh.positions, result.positions);
    repeat(mesh.normals, result.normals);
    repeat(mesh.tangents, result.tangents);
    repeat(mesh.uv0, result.uv0);
    repeat(mesh.uv1, result.uv1);
    repeat(mesh.colours, result.colours);
    repeat(mesh.lightmap_uv, result.lightmap_uv);
    result.indices = hatch.indices;
    return result;
}

GpuMesh upload_mesh(const MeshData& mesh, const HatchCoordinates* hatch = nullptr)
{
    namespace f = surface_feature;
    GpuMesh gpu;
    Interleaver vertices(mesh.positions.size());
    vertices.add(VertexInput::position, &mesh.positions[0].x, 3);
    vertices.add(VertexInput::normal, &mesh.normals[0].x, 3);
    const auto add_optional = [&](const auto& stream, VertexInput input, SurfaceFeatures feature) {
        if (stream.empty()) return;
        vertices.add(input, &stream[0].x, static_cast<int>(sizeof(stream[0]) / sizeof(float)));
        gpu.features |= feature;
    };
    add_optional(mesh.tangents, VertexInput::tangent, f::kTangents);
    add_optional(mesh.uv0, VertexInput::uv0, f::kUv0);
    add_optional(mesh.uv1, VertexInput::uv1, f::kUv1);
    add_optional(mesh.colours, VertexInput::colour, f::kColours);
    if (!mesh.lightmap_uv.empty()) vertices.add(VertexInput::lightmap_uv, &mesh.lightmap_uv[0].x, 2);
    std::vector<glm::vec3> coordinates;
    if (hatch != nullptr) {
        coordinates = hatch_stream(*hatch);
        vertices.add(VertexInput::hatch, &coordinates[0].x, 3);
        if (!hatch->direction.empty()) vertices.add(VertexInput::direction, &hatch->direction[0].x, 3);
    }
    gpu.vertices = GpuBuffer(vertices.floats());
    gpu.indices = GpuBuffer(mesh.indices);
    gpu.array = GpuVertexArray(vertices.streams(gpu.vertices), &gpu.indices);
    gpu.index_count = static_cast<std::uint32_t>(mesh.indices.size());
    if (!mesh.uv0.empty()) gpu.metres_per_uv = metres_per_uv(mesh);
    return gpu;
}

std::vector<std::uint8_t> as_rgba(const Pixels& image)
{
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
    std::vector<std::uint8_t> rgba(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* from = &image.bytes[i * image.channels];
        const bool is_gray = image.channels < 3;
        for (int c = 0; c < 3; ++c) rgba[i * 4 + c] = from[is_gray ? 0 : c];
        rgba[i * 4 + 3] = image.channels == 4 ? from[3] : image.channels == 2 ? from[1] : 255;
    }
    return rgba;
}

/// Of about a thousand texels, linear.
glm::vec3 mean_colour(const Pixels& image)
{
    const int step = std::max(1, std::min(image.width, image.height) / kSampledRows);
    glm::vec3 sum(0.0f);
    float count = 0.0f;
    for (int y = step / 2; y < image.height; y += step)
        for (int x = step / 2; x < image.width; x += step) {
            const std::uint8_t* at = image.at(x, y);
            const bool is_gray = image.channels < 3;
            sum += linear_colour(glm::vec3(at[0], at[is_gray ? 0 : 1], at[is_gray ? 0 : 2]) / 255.0f);
            ++count;
        }
    return sum / std::max(count, 1.0f);
}

WrapMode wrap_mode(TextureWrap wrap)
{
    if (wrap == TextureWrap::repeat) return WrapMode::repeat;
    return wrap == TextureWrap::clamp ? WrapMode::clamp : WrapMode::mirrored_repeat;
}

GpuMap upload_map(const MapLevels& map)
{
    const MapKindFacts& kind = facts_of(map.kind);
    const Pixels& finest = map.levels.front();
    // A picture of one level, as painting programs save it, gets the others here; strips need none.
    const bool makes_levels = kind.is_colour && !kind.is_strip && map.levels.size() == 1;
    const WrapMode wrap = kind.repeats ? WrapMode::repeat : WrapMode::clamp;
    GpuMap gpu;
    gpu.texture = GpuTexture({.format = kind.is_colour ? TextureFormat::srgb8_alpha8 : TextureFormat::r8,
                              .size_px = {finest.width, finest.height},
                              .levels = makes_levels ? 0 : static_cast<int>(map.levels.size()),
                              .wrap_u = wrap,
                              .wrap_v = wrap,
                              .filter = FilterMode::trilinear});
    for (std::size_t i = 0; i < map.levels.size(); ++i) {
        const std::vector<std::uint8_t> bytes = kind.is_colour ? as_rgba(map.levels[i]) : map.levels[i].bytes;
        gpu.texture.upload(static_cast<int>(i), std::as_bytes(std::span(bytes)));
    }
    if (makes_levels) gpu.texture.make_levels();
    const auto size_m = static_cast<float>(map.size_m > 0.0 ? map.size_m : 1.0);
    const float width = static_cast<float>(finest.width);
    const float height = static_cast<float>(finest.height);
    const float second = map.kind == MapKind::hatch   ? static_cast<float>(map.spacing_texels)
                         : map.kind == MapKind::tonal ? std::max(1.0f, std::round(width / height))
                                                      : height / width;
    gpu.info = glm::vec4(1.0f / size_m, second, width, static_cast<float>(map.levels.size()));
    return gpu;
}

}  // namespace

GpuScene::GpuScene(const Scene& scene, const std::vector<const MapLevels*>& maps, FilterMode texture_filter)
    : scene_(scene), texture_filter_(texture_filter), maps_(maps), gpu_maps_(maps.size())
{
    for (const MeshData& mesh : scene.meshes) meshes_.push_back(mesh.positions.empty() ? GpuMesh() : upload_mesh(mesh));
    for (const Material& material : scene.materials) materials_.push_back(upload(material));
    int first = 0;
    for (const Object& object : scene.objects) {
        first_triangle_.push_back(first);
        first += static_cast<int>(scene.meshes[object.mesh].triangle_count());
    }
}

bool GpuScene::makes_uv(ObjectId object, const Streams& streams) const
{
    const bool has_own = mesh_of(object).features & surface_feature::kUv0;
    return streams.hatch_uv && (streams.hatch_source != HatchSource::model || !has_own);
}

std::optional<GpuScene::StreamKey> GpuScene::key_of(ObjectId object, const Streams& streams) const
{
    const bool has_hatch = makes_uv(object, streams) || streams.direction;
    if (mesh_of(object).index_count == 0 || (!has_hatch && !streams.triangle_id)) return std::nullopt;
    StreamKey key{scene_.objects[object].mesh, std::nullopt, streams.triangle_id};
    if (has_hatch) key.source = streams.hatch_source;
    if (key.source == HatchSource::model) key.source = streams.direction ? HatchSource::principal : HatchSource::box;
    return key;
}

HatchCoordinates GpuScene::coordinates(const StreamKey& key) const
{
    const MeshData& mesh = scene_.meshes[key.mesh];
    HatchCoordinates hatch = key.source ? make_hatch_coordinates(mesh, *key.source) : no_coordinates(mesh);
    return key.is_loose ? loosened(hatch) : hatch;
}

void GpuScene::prepare(std::span<const StreamUse> uses)
{
    std::map<StreamKey, HatchCoordinates> missing;
    for (const StreamUse& use : uses)
        if (const auto key = key_of(use.object, use.streams); key && !stream_meshes_.contains(*key)) missing[*key];
    tbb::parallel_for_each(missing.begin(), missing.end(), [&](auto& each) { each.second = coordinates(each.first); });
    prepared_ = std::move(missing);
}

StreamMesh GpuScene::mesh_of(ObjectId object, const Streams& streams)
{
    namespace f = surface_feature;
    const GpuMesh& own = mesh_of(object);
    const std::optional<StreamKey> key = key_of(object, streams);
    if (!key) return {&own, own.features};
    auto found = stream_meshes_.find(*key);
    if (found == stream_meshes_.end()) {
        const auto prepared = prepared_.extract(*key);
        const HatchCoordinates hatch = prepared ? std::move(prepared.mapped()) : coordinates(*key);
        found = stream_meshes_.emplace(*key, upload_mesh(repeated(scene_.meshes[key->mesh], hatch), &hatch)).first;
    }
    SurfaceFeatures features = own.features;
    if (makes_uv(object, streams)) features |= f::kHatchUv;
    if (streams.direction) features |= f::kDirection;
    if (streams.triangle_id) features |= f::kTriangleId;
    return {&found->second, features};
}

std::uint32_t GpuScene::texture(const TextureUse& use, bool is_srgb)
{
    if (use.texture == kNone) return 0;
    const Texture& texture = scene_.textures[use.texture];
    if (texture.image == kNone || scene_.images[texture.image].is_empty()) return 0;
    const auto [place, is_new] = textures_.try_emplace({use.texture, is_srgb});
    if (is_new) {
        const Pixels& image = scene_.images[texture.image];
        place->second = GpuTexture({.format = is_srgb ? TextureFormat::srgb8_alpha8 : TextureFormat::rgba8,
                                    .size_px = {image.width, image.height},
                                    .levels = 0,
                                    .wrap_u = wrap_mode(texture.wrap_u),
                                    .wrap_v = wrap_mode(texture.wrap_v),
                                    .filter = texture_filter_,
                                    .is_magnified_nearest = texture.is_nearest});
        const std::vector<std::uint8_t> rgba = as_rgba(image);
        place->second.upload(0, std::as_bytes(std::span(rgba)));
        place->second.make_levels();
    }
    return place->second.id();
}

GpuMaterial GpuScene::upload(const Material& material)
{
    namespace f = surface_feature;
    GpuMaterial gpu;
    gpu.facts = &material;
    const auto take = [&](const TextureUse& use, bool is_srgb, int bit) {
        const std::uint32_t id = texture(use, is_srgb);
        if (id != 0) gpu.features |= static_cast<SurfaceFeatures>(use.uv_set == 1 ? 2 : 1) << bit;
        return id;
    };
    gpu.base_colour = take(material.base_colour_texture, true, f::kBaseColourMapBit);
    gpu.mean_colour = glm::vec3(material.base_colour);
    if (gpu.base_colour != 0)
        gpu.mean_colour *= mean_colour(scene_.images[scene_.textures[material.base_colour_texture.texture].image]);
    gpu.metallic_roughness = take(material.metallic_roughness_texture, false, f::kMetallicRoughnessMapBit);
    gpu.normal = take(material.normal_texture, false, f::kNormalMapBit);
    gpu.occlusion = take(material.occlusion_texture, false, f::kOcclusionMapBit);
    gpu.emissive = take(material.emissive_texture, true, f::kEmissiveMapBit);
    if (material.alpha_mode == AlphaMode::mask) gpu.features |= f::kAlphaMask;
    if (material.alpha_mode == AlphaMode::blend) gpu.features |= f::kAlphaBlend;
    if (material.is_double_sided) gpu.features |= f::kDoubleSided;
    if (material.is_unlit) gpu.features |= f::kUnlit;
    return gpu;
}

const GpuMap& GpuScene::map(int index)
{
    std::optional<GpuMap>& gpu = gpu_maps_[index];
    if (!gpu) gpu = upload_map(*maps_[index]);
    return *gpu;
}

}  // namespace hw
