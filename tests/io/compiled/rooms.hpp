#pragma once

#include <algorithm>
#include <cstring>

#include "hatchway/core/error.hpp"
#include "hatchway/core/hash.hpp"
#include "hatchway/io/compiled/key.hpp"
#include "hatchway/io/compiled/level.hpp"
#include "hatchway/io/compiled/read.hpp"
#include "hatchway/io/compiled/write.hpp"
#include "tests/world/scene_builder.hpp"

namespace hw::test {

/// Three rooms in a row, doorways out of line, and a box in each; small, so that files are.
inline Scene& rooms(SceneBuilder& builder, double scale = 1.0)
{
    const auto box = [&](const glm::dvec3& min, const glm::dvec3& max, bool from_inside) {
        builder.box(scale * min, scale * max, from_inside);
    };
    box({-10, -3, -5}, {10, 3, 5}, true);
    for (int i = 0; i < 2; ++i) {
        const double x = -3.0 + 6.0 * i, from = i == 0 ? 3.0 : -4.0;
        box({x - 0.2, -3, -5}, {x + 0.2, 3, from}, false);
        box({x - 0.2, -3, from + 1.0}, {x + 0.2, 3, 5}, false);
    }
    for (const double x : {-7.0, 0.0, 7.0}) box({x, -2, -1}, {x + 1, -1, 1}, false);
    return builder.scene();
}

struct Rooms {
    SceneBuilder builder;
    Scene& scene;
    std::vector<MeshChunks> chunks;
    CompiledLevel level;

    explicit Rooms(int threads = 0, double scale = 1.0) : scene(rooms(builder, scale))
    {
        VisibilityOptions options;
        options.threads = threads;
        options.max_cells = 12;
        auto compiled = compile(scene, options);
        chunks = std::move(compiled.chunks);
        level = {compiled_level_key(geometry_key(scene), scene, {}, options), options.effort,
                 std::move(compiled.visibility)};
    }
    std::vector<std::byte> bytes() const { return compiled_level_bytes(level, chunks); }
    CompiledLevel read(std::span<const std::byte> from) const
    {
        return compiled_level_from_bytes(from, scene, chunks, "rooms.compiled");
    }
};

inline std::vector<std::uint8_t> seen_from(const Visibility& visibility, const glm::dvec3& eye)
{
    std::vector<std::uint8_t> seen;
    visible_chunks(visibility, eye, 0.1, seen);
    return seen;
}

/// Whether the bytes are taken; what is refused must be refused by Error, and what is taken must be usable.
inline bool is_taken(const Rooms& rooms, std::span<const std::byte> bytes)
{
    try {
        const CompiledLevel level = rooms.read(bytes);
        seen_from(level.visibility, glm::dvec3(-8, 0, 0));
        visible_leaf_count(level.visibility, glm::dvec3(-8, 0, 0), 0.1);
        return true;
    } catch (const Error&) {
        return false;
    }
}

inline constexpr std::size_t kNoPlace = static_cast<std::size_t>(-1);

/// Where a value stands in a file.
template <typename Value>
std::size_t place_of(const std::vector<std::byte>& bytes, const Value& value)
{
    for (std::size_t at = 0; at + sizeof value <= bytes.size(); ++at)
        if (std::memcmp(bytes.data() + at, &value, sizeof value) == 0) return at;
    return kNoPlace;
}

/// A file's content, which is its last and longest part, and the place of the hash over it, found by its value.
struct Signature {
    std::size_t content = kNoPlace;
    std::size_t size = 0;
    std::size_t hash = kNoPlace;

    explicit Signature(const std::vector<std::byte>& good)
    {
        for (std::size_t at = 0; at + 4 < good.size() && hash == kNoPlace; at += 4) {
            std::uint32_t count = 0;
            std::memcpy(&count, good.data() + at, 4);
            if (count == 0 || at + 4 + count > good.size()) continue;
            const auto part = std::span(good).subspan(at + 4, count);
            if (count < good.size() / 2) continue;
            content = at + 4;
            size = count;
            hash = place_of(good, hash_bytes(part));
        }
    }
    /// Signs what is left of the content, if anything is.
    void renew(std::vector<std::byte>& bytes) const
    {
        if (bytes.size() <= content) return;
        const auto signed_bytes = std::span(bytes).subspan(content, std::min(size, bytes.size() - content));
        const std::uint64_t value = hash_bytes(signed_bytes);
        std::memcpy(bytes.data() + hash, &value, sizeof value);
    }
};

}  // namespace hw::test
