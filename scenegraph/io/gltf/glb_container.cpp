#include "hatchway/io/gltf/glb_container.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004e4942;   // "BIN"
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t place)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[place + i]) << (8 * i);
    return word;
}

struct Chunk {
    std::uint32_t type = 0;
    std::size_t place = 0;  ///< Of its header.
    std::span<const std::byte> bytes;
};

class GlbSplitter {
 public:
    GlbSplitter(std::span<const std::byte> bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    GltfParts split()
    {
        check_header();
        const Chunk json = next_chunk();
        if (json.type != kJsonChunk) refuse(json.place, "the first chunk is not JSON", "a JSON chunk");
        GltfParts parts;
        parts.json = {reinterpret_cast<const char*>(json.bytes.data()), json.bytes.size()};
        for (int index = 1; place_ < bytes_.size(); ++index) {
            const Chunk chunk = next_chunk();
            if (chunk.type == kJsonChunk) refuse(chunk.place, "a second JSON chunk stands here", "one");
            if (chunk.type != kBinChunk) continue;  // The format allows chunks of unknown types.
            if (index != 1) refuse(chunk.place, "a BIN chunk stands here", "it right after the JSON chunk, once");
            parts.binary = chunk.bytes;
        }
        return parts;
    }

 private:
    [[noreturn]] void refuse(std::size_t place, std::string what, std::string expected) const
    {
        throw Error({.what = std::move(what),
                     .file = file_,
                     .pointer = fmt::format("byte {}", place),
                     .expected = std::move(expected)});
    }

    void check_header()
    {
        if (bytes_.size() < kHeaderSize) refuse(bytes_.size(), "the header ends too early", "12 bytes");
        const std::uint32_t version = word_at(bytes_, 4);
        if (version != 2) refuse(4, fmt::format("the container has version {}", version), "2");
        const std::uint32_t length = word_at(bytes_, 8);
        if (length != bytes_.size())
            refuse(8, fmt::format("the header states {} bytes", length), fmt::format("{}", bytes_.size()));
        place_ = kHeaderSize;
    }

    Chunk next_chunk()
    {
        Chunk chunk;
        chunk.place = place_;
        if (bytes_.size() - place_ < kChunkHeaderSize) refuse(place_, "a chunk's header ends too early", "8 bytes");
        const std::uint32_t length = word_at(bytes_, place_);
        chunk.type = word_at(bytes_, place_ + 4);
        const std::size_t left = bytes_.size() - place_ - kChunkHeaderSize;
        if (length > left)
            refuse(place_, fmt::format("a chunk of {} bytes does not fit", length), fmt::format("at most {}", left));
        if (length % 4 != 0) refuse(place_, fmt::format("a chunk has {} bytes", length), "a multiple of 4");
        chunk.bytes = bytes_.subspan(place_ + kChunkHeaderSize, length);
        place_ += kChunkHeaderSize + length;
        return chunk;
    }

    std::span<const std::byte> bytes_;
    const std::string& file_;
    std::size_t place_ = 0;
};

}  // namespace

GltfParts split_gltf(std::span<const std::byte> bytes, const std::string& file)
{
    const bool is_magic = bytes.size() >= 4 && word_at(bytes, 0) == kMagic;
    if (is_magic) return GlbSplitter(bytes, file).split();
    if (file.ends_with(".glb"))
        throw Error({.what = "the file is no .glb", .file = file, .pointer = "byte 0", .expected = "the word glTF"});
    return {.json = {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, .binary = {}};
}

}  // namespace hw
