#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace hw {

/// The pixels within reach of lines, and which way the lines run there: a bit for each 15 degrees. A line runs like
/// another within 15 to 30 degrees. Pixels, origin top left.
class LineMask {
 public:
    static constexpr double kReach_px = 1.0;

    /// A pixel, by its place in a row-major picture, and its bits.
    using Stamp = std::pair<std::size_t, std::uint16_t>;

    explicit LineMask(glm::ivec2 size_px);

    /// What a line that runs along `way` sets around a point.
    template <typename Use>
    void stamp(const glm::dvec2& at, const glm::dvec2& way, const Use& use) const;
    void add(const glm::dvec2& at, const glm::dvec2& way);
    void add(const Stamp& stamp) { bits_[stamp.first] |= stamp.second; }

    /// Whether a line within reach runs along `way`.
    bool holds(const glm::dvec2& at, const glm::dvec2& way) const;
    std::uint16_t bits(std::size_t pixel) const { return bits_[pixel]; }

 private:
    glm::ivec2 size_;
    std::vector<std::uint16_t> bits_;
};

/// Lines, and where two of them within reach of each other run alike: there one of them would not be missed.
class FoundLines {
 public:
    explicit FoundLines(glm::ivec2 size_px) : all_(size_px), shared_(size_px) {}

    void add(const glm::dvec2& at, const glm::dvec2& way);
    /// What was added since the last call is one line.
    void end_line();

    bool hold(const glm::dvec2& at, const glm::dvec2& way) const { return all_.holds(at, way); }
    bool hold_two(const glm::dvec2& at, const glm::dvec2& way) const { return shared_.holds(at, way); }

 private:
    LineMask all_, shared_;
    std::vector<LineMask::Stamp> line_;
};

}  // namespace hw
