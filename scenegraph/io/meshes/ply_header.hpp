#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hw {

/// A type of numbers in a PLY file.
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);
inline bool is_whole(PlyType type)
{
    return type < PlyType::float32;
}

/// What becomes of a property.
enum class PlyUse : std::uint8_t { skipped, coordinate, normal, uv, colour, corners };

struct PlyProperty {
    std::string name;  ///< As OpenMesh knows it, where it is used.
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type;  ///< Of a list.
    PlyUse use = PlyUse::skipped;
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    bool uses(PlyUse use) const;
};

enum class PlyEncoding : std::uint8_t { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;  ///< Bytes to the body.

    std::uint64_t vertices() const;
};

/// Reads the header and decides what is used: of vertices x, y, z and, where they are whole and of a type that can be
/// read, normals, texture coordinates and colours; of faces their corners and colours. Throws hw::Error with the line
/// for what is no header, no triangle mesh, or announces more than a scene may have.
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

/// The header of what is used, in words that OpenMesh's reader knows; a face's corners stand before its colours.
std::string text_of(const PlyHeader& header);

}  // namespace hw
