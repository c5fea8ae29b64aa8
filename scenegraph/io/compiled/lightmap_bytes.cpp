// The bytes of a lightmap: a head, the layouts, the places, the luxels, and last a hash of all before it. Little-endian
// like every machine that we build for. The hash finds damage; the checks after it keep a file that was made to deceive
// from being read out of bounds.
#include "hatchway/io/compiled/lightmap_bytes.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <span>

#include "hatchway/core/error.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/world/light/layout.hpp"

namespace hw {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::array<char, 8> kMagic{'H', 'W', 'L', 'I', 'G', 'H', 'T', '1'};
constexpr int kMaxAtlasSide = 4096;
constexpr std::uint16_t kInfiniteHalf = 0x7c00;  // and what is above is infinite, no number or negative

class ByteWriter {
 public:
    template <typename Value>
    void add(const Value& value)
    {
        const auto from = std::as_bytes(std::span(&value, 1));
        bytes_.insert(bytes_.end(), from.begin(), from.end());
    }
    template <typename Value>
    void add_all(const std::vector<Value>& values)
    {
        add(static_cast<std::uint64_t>(values.size()));
        const auto from = std::as_bytes(std::span(values));
        bytes_.insert(bytes_.end(), from.begin(), from.end());
    }
    std::vector<std::byte> take()
    {
        add(hash_bytes(bytes_));
        return std::move(bytes_);
    }

 private:
    std::vector<std::byte> bytes_;
};

class ByteReader {
 public:
    ByteReader(std::span<const std::byte> bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    template <typename Value>
    Value take()
    {
        Value value;
        const auto from = take_bytes(sizeof(Value));
        std::memcpy(static_cast<void*>(&value), from.data(), sizeof(Value));
        return value;
    }
    /// A list of exactly `count` values, or of any number.
    template <typename Value>
    std::vector<Value> take_all(std::optional<std::uint64_t> count = {})
    {
        const auto stated = take<std::uint64_t>();
        require(!count || stated == *count, "a list has another length than the scene asks for");
        require(stated <= bytes_.size() / sizeof(Value), "a list is longer than the file");
        std::vector<Value> values(stated);
        const auto from = take_bytes(stated * sizeof(Value));
        if (stated > 0) std::memcpy(static_cast<void*>(values.data()), from.data(), from.size());
        return values;
    }
    bool is_at_end() const { return bytes_.empty(); }
    void require(bool condition, const char* what) const
    {
        if (!condition) throw Error({.what = what, .file = file_, .expected = "a lightmap baked for this level"});
    }

 private:
    std::span<const std::byte> take_bytes(std::size_t count)
    {
        require(count <= bytes_.size(), "the lightmap is cut short");
        const auto taken = bytes_.first(count);
        bytes_ = bytes_.subspan(count);
        return taken;
    }

    std::span<const std::byte> bytes_;
    const std::string& file_;
};

LightmapLayout layout_of(ByteReader& reader, const MeshData& mesh)
{
    LightmapLayout layout;
    layout.is_per_vertex = reader.take<std::uint8_t>() == 1;
    layout.size = reader.take<glm::ivec2>();
    layout.copied_vertices = reader.take_all<std::uint32_t>();
    layout.indices = reader.take_all<std::uint32_t>();
    layout.uv = reader.take_all<glm::vec2>();
    if (layout.is_per_vertex || layout.indices.empty()) {
        reader.require(layout.indices.empty() && layout.uv.empty() && layout.copied_vertices.empty(),
                       "a mesh without charts has places in them");
        return layout;
    }
    const std::size_t vertices = mesh.positions.size() + layout.copied_vertices.size();
    reader.require(layout.indices.size() == mesh.indices.size() && layout.uv.size() == vertices,
                   "a mesh has another number of vertices or triangles");
    for (const std::uint32_t vertex : layout.copied_vertices)
        reader.require(vertex < mesh.positions.size(), "a copied vertex is not in the mesh");
    for (std::size_t i = 0; i < layout.indices.size(); ++i) {
        const std::uint32_t index = layout.indices[i];
        reader.require(index < vertices, "an index is out of range");
        const std::size_t own = mesh.positions.size();
        reader.require((index < own ? index : layout.copied_vertices[index - own]) == mesh.indices[i],
                       "a triangle has other corners");
    }
    reader.require(glm::all(glm::greaterThan(layout.size, glm::ivec2(0))) &&
                       glm::all(glm::lessThanEqual(layout.size, glm::ivec2(kMaxAtlasSide))),
                   "a mesh has an impossible size");
    for (const glm::vec2& uv : layout.uv)
        reader.require(uv.x >= 0.0f && uv.y >= 0.0f && uv.x <= static_cast<float>(layout.size.x) &&
                           uv.y <= static_cast<float>(layout.size.y),
                       "a vertex lies outside of its mesh's luxels");
    return layout;
}

void check_place(const ByteReader& reader, const Lightmap& lightmap, const Scene& scene, ObjectId id)
{
    const LightmapPlace& place = lightmap.places[id];
    if (place.sides == 0) return;
    const int mesh = scene.objects[id].mesh;
    const LightmapLayout& layout = lightmap.layouts[mesh];
    reader.require(place.sides <= 2 && !layout.is_empty(), "an object has light that its mesh has no place for");
    reader.require(place.corner.x >= 0 && place.corner.y >= 0 && place.corner.x < lightmap.size.x &&
                       place.corner.y < lightmap.size.y,
                   "an object's luxels stand outside of the atlas");
    if (layout.is_per_vertex) {
        const std::uint64_t end = static_cast<std::uint64_t>(place.corner.y) * lightmap.size.x + place.corner.x +
                                  scene.meshes[mesh].positions.size() * place.sides;
        reader.require(end <= lightmap.luxels.size(), "an object's luxels stand outside of the atlas");
        return;
    }
    reader.require(place.corner.x + layout.size.x * place.sides <= lightmap.size.x &&
                       place.corner.y + layout.size.y <= lightmap.size.y,
                   "an object's luxels stand outside of the atlas");
}

}  // namespace

std::vector<std::byte> lightmap_bytes(const Lightmap& lightmap)
{
    ByteWriter writer;
    writer.add(kMagic);
    writer.add(lightmap.key);
    writer.add(lightmap.luxels_per_m);
    writer.add(lightmap.size);
    writer.add(static_cast<std::uint64_t>(lightmap.layouts.size()));
    for (const LightmapLayout& layout : lightmap.layouts) {
        writer.add(static_cast<std::uint8_t>(layout.is_per_vertex));
        writer.add(layout.size);
        writer.add_all(layout.copied_vertices);
        writer.add_all(layout.indices);
        writer.add_all(layout.uv);
    }
    writer.add(static_cast<std::uint64_t>(lightmap.places.size()));
    for (const LightmapPlace& place : lightmap.places) {
        writer.add(place.sides);
        writer.add(place.corner);
    }
    writer.add_all(lightmap.luxels);
    return writer.take();
}

Lightmap lightmap_from_bytes(std::span<const std::byte> bytes, const Scene& scene, const std::string& file)
{
    const std::size_t hash_size = sizeof(std::uint64_t);
    ByteReader reader(bytes.first(bytes.size() < hash_size ? 0 : bytes.size() - hash_size), file);
    reader.require(reader.take<std::array<char, 8>>() == kMagic, "this is no lightmap, or one of another version");
    std::uint64_t stated = 0;
    std::memcpy(&stated, bytes.data() + bytes.size() - hash_size, hash_size);
    reader.require(stated == hash_bytes(bytes.first(bytes.size() - hash_size)), "the lightmap is damaged");
    Lightmap lightmap;
    lightmap.key = reader.take<std::uint64_t>();
    lightmap.luxels_per_m = reader.take<double>();
    reader.require(lightmap.luxels_per_m >= 0.0 && std::isfinite(lightmap.luxels_per_m), "the density is impossible");
    lightmap.size = reader.take<glm::ivec2>();
    reader.require(lightmap.size.x > 0 && lightmap.size.y > 0 && lightmap.size.x <= kMaxAtlasSide &&
                       lightmap.size.y <= kMaxAtlasSide,
                   "the atlas has an impossible size");
    reader.require(reader.take<std::uint64_t>() == scene.meshes.size(), "the scene has another number of meshes");
    for (const MeshData& mesh : scene.meshes) lightmap.layouts.push_back(layout_of(reader, mesh));
    reader.require(reader.take<std::uint64_t>() == scene.objects.size(), "the scene has another number of objects");
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        LightmapPlace place;
        place.sides = reader.take<std::uint8_t>();
        place.corner = reader.take<glm::ivec2>();
        lightmap.places.push_back(place);
    }
    const std::uint64_t count = static_cast<std::uint64_t>(lightmap.size.x) * lightmap.size.y;
    lightmap.luxels = reader.take_all<std::array<std::uint16_t, 4>>(count);
    for (const std::array<std::uint16_t, 4>& luxel : lightmap.luxels)
        for (const std::uint16_t half : luxel) reader.require(half < kInfiniteHalf, "a luxel is no amount of light");
    reader.require(reader.is_at_end(), "bytes follow after the lightmap");
    for (ObjectId id = 0; id < scene.objects.size(); ++id) check_place(reader, lightmap, scene, id);
    return lightmap;
}

}  // namespace hw
