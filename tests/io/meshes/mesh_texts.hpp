#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>

#include "hatchway/io/model/import.hpp"
#include "tests/temporary_folder.hpp"

/// A cube of 2 m with coloured corners and six quads, in each format.
namespace mesh_texts {

inline const char* kPlyHeader =
    "element vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
inline constexpr int kQuads[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                     {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

inline float corner(int vertex, int axis)
{
    const int bits[8] = {0, 1, 3, 2, 4, 5, 7, 6};
    return (bits[vertex] >> axis & 1) != 0 ? 1.0f : -1.0f;
}
inline int colour(int vertex, int channel)
{
    return 20 * vertex + 40 * channel;
}
inline std::string numbers(int vertex)
{
    std::string text;
    for (int axis = 0; axis < 3; ++axis) text += std::to_string(corner(vertex, axis)) + ' ';
    return text;
}
inline std::string colours(int vertex)
{
    std::string text;
    for (int channel = 0; channel < 3; ++channel) text += std::to_string(colour(vertex, channel)) + ' ';
    return text;
}
inline std::string quads(int first_index)
{
    std::string text;
    for (const auto& quad : kQuads) {
        text += first_index == 0 ? "4" : "f";
        for (const int vertex : quad) text += ' ' + std::to_string(vertex + first_index);
        text += '\n';
    }
    return text;
}

inline std::string ply_text()
{
    std::string text = std::string("ply\nformat ascii 1.0\ncomment a cube\n") + kPlyHeader;
    for (int i = 0; i < 8; ++i) text += numbers(i) + colours(i) + '\n';
    return text + quads(0);
}

template <typename T>
std::string bytes_of(T value, bool is_big)
{
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(value));
    return is_big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline std::string ply_binary(bool is_big)
{
    std::string text = std::string("ply\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\n" + kPlyHeader;
    for (int i = 0; i < 8; ++i) {
        for (int axis = 0; axis < 3; ++axis) text += bytes_of(corner(i, axis), is_big);
        for (int channel = 0; channel < 3; ++channel) text += static_cast<char>(colour(i, channel));
    }
    for (const auto& quad : kQuads) {
        text += '\4';
        for (const int vertex : quad) text += bytes_of(vertex, is_big);
    }
    return text;
}

inline std::string obj_text()
{
    std::string text = "# a cube\nmtllib cube.mtl\no Cube\ng Sides\nusemtl Wood\n";
    for (int i = 0; i < 8; ++i) {
        text += "v " + numbers(i);
        for (int channel = 0; channel < 3; ++channel) text += std::to_string(colour(i, channel) / 255.0) + ' ';
        text += '\n';
    }
    return text + "vt 0 0\nvt 1 0\nvn 0 0 -1\n" + quads(1);
}

inline std::string off_text(const char* kind = "COFF")
{
    std::string text = std::string(kind) + "\n8 6 12\n";
    for (int i = 0; i < 8; ++i) text += numbers(i) + (kind[0] == 'C' ? colours(i) + "255" : "") + '\n';
    return text + quads(0);
}

/// Two triangles of each quad.
template <typename Triangle>
void each_triangle(Triangle triangle)
{
    for (const auto& quad : kQuads)
        for (int i = 1; i < 3; ++i) triangle(quad[0], quad[i], quad[i + 1]);
}

inline std::string stl_text()
{
    std::string text = "solid Cube\n";
    each_triangle([&](int a, int b, int c) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int vertex : {a, b, c}) text += "vertex " + numbers(vertex) + '\n';
        text += "endloop\nendfacet\n";
    });
    return text + "endsolid Cube\n";
}

inline std::string stl_binary()
{
    std::string text(80, ' ');
    text += bytes_of(std::uint32_t{12}, false);
    each_triangle([&](int a, int b, int c) {
        text.append(12, '\0');
        for (const int vertex : {a, b, c})
            for (int axis = 0; axis < 3; ++axis) text += bytes_of(corner(vertex, axis), false);
        text.append(2, '\0');
    });
    return text;
}

inline hw::Scene import_text(const std::string& text, const std::string& name)
{
    const TemporaryFolder folder;
    return hw::import_model(folder.write(name, text), folder.path());
}

}  // namespace mesh_texts
