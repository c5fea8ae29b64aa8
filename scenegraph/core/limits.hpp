#pragma once

#include <cstdint>

/// What we accept from files that strangers made. A file over a limit is refused with a message, before any allocation.
/// What budget.hpp names can be raised by the program's user.
namespace hw::limits {

inline constexpr std::uint64_t kMaxFileBytes = 1ull << 30;         ///< One scene, buffer or image file.
inline constexpr std::uint64_t kMaxTotalBytes = 2ull << 30;        ///< All files of one level together.
inline constexpr std::uint64_t kMaxLevelFileBytes = 16ull << 20;   ///< A level file (JSON).
inline constexpr std::uint64_t kMaxShaderBytes = 1ull << 20;       ///< One shader file.
inline constexpr int kMaxJsonDepth = 64;                           ///< Nesting of arrays and objects.
inline constexpr std::uint64_t kMaxNodes = 1'000'000;              ///< Nodes of one scene.
inline constexpr int kMaxNodeDepth = 256;                          ///< Length of a chain of parents.
inline constexpr std::uint64_t kMaxObjects = 1'000'000;            ///< Node x primitive pairs.
inline constexpr std::uint64_t kMaxTriangles = 20'000'000;         ///< Triangles stored in one scene.
inline constexpr std::uint64_t kMaxVertices = 60'000'000;          ///< Vertices stored in one scene.
inline constexpr std::uint64_t kMaxDrawnTriangles = 40'000'000;    ///< Triangles of all objects of one scene.
inline constexpr std::uint64_t kMaxPathBytes = 128ull << 20;       ///< Text of the paths of all nodes of one scene.
inline constexpr std::uint64_t kMaxMapPixels = 1ull << 28;         ///< Texels of all maps of one level.
inline constexpr std::uint64_t kMaxRuleSteps = 2'000'000'000;      ///< Characters compared: rules x nodes x paths.
inline constexpr std::uint64_t kMaxLineBytes = 1'200'000'000;      ///< Positions and faces of a line drawing.
inline constexpr std::uint64_t kMaxLineSteps = 3'000'000'000;      ///< Faces and contours looked at for its lines.
inline constexpr std::uint64_t kMaxStrokes = 300'000;              ///< That a drawing of pixels is read as.
inline constexpr std::uint64_t kMaxLayers = 4000;                  ///< Of faces over a picture's pixels, at the mean.
inline constexpr int kMaxImageSide = 16384;                        ///< Width and height of one image.
inline constexpr std::uint64_t kMaxImagePixels = 1ull << 27;       ///< Pixels of one image.
inline constexpr std::uint64_t kMaxTotalImagePixels = 1ull << 28;  ///< Pixels of all images of one scene.
inline constexpr std::uint64_t kFreeImagePixels = 1ull << 26;      ///< Of these, as many as a scene likes; past them
inline constexpr std::uint64_t kMaxPixelsOfByte = 64;              ///< so many for each byte of the images' files.
inline constexpr int kMaxNames = 10'000;                           ///< Styles, cameras, paths, rules: of each kind.
inline constexpr double kMaxCoordinate = 1e15;                     ///< Largest magnitude of a position.

}  // namespace hw::limits
