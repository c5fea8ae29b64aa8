#pragma once

#include <cstdint>

namespace hw {

/// What a piece of a drawn line is a part of, in four bytes. A fresh one is of nothing.
class LineSource {
 public:
    enum class Kind : std::uint8_t {
        edge,          ///< Of the object's surface, by its id.
        kept,          ///< What seams keep of edges: by its place in Seams::kept.
        intersection,  ///< By its place among the intersections of all objects.
        none,
    };

    LineSource() = default;
    LineSource(Kind kind, std::uint32_t index) : bits_(static_cast<std::uint32_t>(kind) << 30 | index) {}

    Kind kind() const { return static_cast<Kind>(bits_ >> 30); }
    std::uint32_t index() const { return bits_ & 0x3fffffffu; }
    bool is_edge() const { return kind() == Kind::edge; }
    auto operator<=>(const LineSource&) const = default;

 private:
    std::uint32_t bits_ = 0xffffffffu;
};

}  // namespace hw
