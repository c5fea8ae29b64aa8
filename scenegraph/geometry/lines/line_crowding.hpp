#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "hatchway/geometry/lines/seams.hpp"
#include "hatchway/geometry/surface/surface.hpp"

namespace hw {

/// A line as what crowds others; object space.
struct CrowdingLine {
    std::array<glm::vec3, 2> ends{};
    float share = 1.0f;  ///< Of its length that a view is expected to show.
};

/// The lines that a surface draws, for LineCrowding: borders and creases but those that `seams` (or null) hides, what
/// seams keep of them, `pieces` such as intersections, and every edge that can be a silhouette, by the share of all
/// views in which it is one: its fold over pi.
std::vector<CrowdingLine> crowding_lines(const Surface& surface, float crease_rad, const Seams* seams,
                                         std::span<const std::array<glm::vec3, 2>> pieces);

/// How crowded the lines of an object are around places of it: how many of them lie side by side in windows of four
/// sizes. What a window of some pixels covers on an object grows with the distance, so that this tells, for every
/// distance and without any view, how much of a line can be drawn before lines run together.
///
/// Lengths are summed up in sparse grids, smoothly, so that the answer is a continuous function of the place. Memory:
/// a few numbers for each cell of the finest grid that lines go through; gone with this.
class LineCrowding {
 public:
    static constexpr int kScales = 4;

    /// Object space, any number of lines. `places`: where alone it will be asked for, which takes far less; without
    /// them, anywhere.
    explicit LineCrowding(std::span<const CrowdingLine> lines,
                          std::optional<std::span<const glm::vec3>> places = std::nullopt);

    std::size_t bytes() const;  ///< That this takes.

    /// The smallest window; the others are 4, 16 and 64 times as wide. Object space; above 0.
    float window() const { return window_; }

    /// For each window the logarithm to base 2 of how many times more lines are across it than are drawn in full; 0
    /// where all are, never falling.
    glm::vec4 at(const glm::vec3& place) const;

    /// The same for many places, on all threads.
    std::vector<glm::vec4> at(std::span<const glm::vec3> places) const;

 private:
    /// Bricks that were looked up last: places that follow each other along a line lie in the same ones.
    class NearBricks {
     public:
        /// The number of the brick of a key; `corner` is the key's place among 2 x 2 x 2 neighbours.
        template <typename Find>
        std::uint32_t brick(std::uint64_t key, int corner, Find&& find)
        {
            if (keys_[corner] != key) {
                keys_[corner] = key;
                bricks_[corner] = find();
            }
            return bricks_[corner];
        }

     private:
        std::array<std::uint64_t, 8> keys_{};
        std::array<std::uint32_t, 8> bricks_{};
    };
    using Near = std::array<NearBricks, kScales>;

    /// A grid in which lengths lie on the nodes around them: bricks of 4 x 4 x 4 nodes in a hash table, so that the 27
    /// nodes around a place lie in few of them.
    class Lengths {
     public:
        explicit Lengths(float cell);
        /// Makes the nodes around a place; before lengths are added.
        void make_room(const glm::vec3& place);
        /// Adds to those nodes around a place that were made.
        void add(const glm::vec3& place, float length);
        std::size_t bytes() const { return slots_.capacity() * sizeof(Slot) + bricks_.capacity() * sizeof(Brick); }
        /// Lines across a window around a place.
        float lines_at(const glm::vec3& place, NearBricks& near) const;

     private:
        using Brick = std::array<float, 64>;
        static constexpr std::uint32_t kNoBrick = ~0u;
        struct Slot {
            std::uint64_t key = 0;
            std::uint32_t brick = 0;
        };
        /// The slot of a brick, or the empty one where it would be.
        std::size_t slot_of(std::uint64_t key) const;
        std::uint32_t found(std::uint64_t key) const;
        std::uint32_t made(std::uint64_t key);
        void grow();

        float cell_;
        std::vector<Slot> slots_;
        std::vector<Brick> bricks_;
        NearBricks near_;  ///< For make_room() and add().
    };

    glm::vec4 at(const glm::vec3& place, Near& near) const;

    float window_ = 1.0f;
    glm::vec3 origin_{0.0f};
    std::vector<Lengths> scales_;
};

/// From LineCrowding at the ends of a line and in its middle, what the line goes by at its ends, linearly in between:
/// other lines meet at every end, which must not thin it, and where it ends nothing else may go on, which must not
/// thicken it.
std::array<glm::vec4, 2> crowding_of_line(const glm::vec4& at_a, const glm::vec4& at_b, const glm::vec4& in_middle);

/// The share of its width that a line is drawn with where `windows` is how wide a window is on the object, over
/// LineCrowding::window(): however many lines there are, they get as much ink as the most that are drawn in full. In
/// (0, 1], falling with the distance; for windows larger than the largest it falls as if the object went on for ever.
/// shaders/lines/line_width.glsl does the same.
float crowded_share(const glm::vec4& crowding, float windows);

/// Of parallel lines on a face that is seen from the front, how far apart they are in windows when all are just drawn
/// in full.
inline constexpr float kFullSpacingInWindows = 0.92f;

}  // namespace hw
