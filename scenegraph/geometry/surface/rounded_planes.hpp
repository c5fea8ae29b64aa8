#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hw {

/// A plane in 16-bit steps: x, y, z of its unit normal, and how far it is from the middle of the mesh along it. All
/// within -32767 .. 32767; all zero for a plane that is not known well enough: no eye is ever certain.
using RoundedPlane = std::array<std::int16_t, 4>;

/// An eye in the same way: x, y, z from the middle of the mesh, and minus the weight of a plane's offset. The sum of
/// products with a plane tells the eye's side of it where it is farther from 0 than `bound`. The magnitudes of `eye`
/// sum up to less than 65536, so that no sum of products leaves 32 bits.
struct EyeSteps {
    std::array<std::int16_t, 4> eye{};
    std::int32_t bound = 0;
};

/// Four numbers for each place: blocks of eight places, the first two numbers of each, then the last two. That is what
/// processors multiply and add in one step.
class StepBlocks {
 public:
    using Pair = std::array<std::int16_t, 2>;
    static constexpr std::size_t kPlaces = 8;  ///< In a block.
    /// A line of the processor's cache.
    struct alignas(64) Block {
        std::array<Pair, kPlaces> first;
        std::array<Pair, kPlaces> second;
    };

    void add(const RoundedPlane& plane);
    RoundedPlane at(std::size_t place) const
    {
        const auto [a, b] = block(place)->first[place % kPlaces];
        const auto [c, d] = block(place)->second[place % kPlaces];
        return {a, b, c, d};
    }
    const Block* block(std::size_t place) const { return blocks_.data() + place / kPlaces; }
    std::size_t bytes() const { return blocks_.size() * sizeof(Block); }

 private:
    std::size_t count_ = 0;
    std::vector<Block> blocks_;  ///< Places past the last are zero.
};

/// Writes a plane to its place in some blocks.
void put_plane(const RoundedPlane& plane, StepBlocks::Block* blocks, std::size_t place);

/// A bit for each place, 32 to a word; bits past the last are zero.
struct SideBits {
    std::span<std::uint32_t> front;  ///< For certain on the outer side.
    std::span<std::uint32_t> open;   ///< Neither that nor for certain behind.
};

/// Decides the first `count` planes of some blocks. Both spans hold a word for each 32 planes begun.
void decide_planes(const StepBlocks::Block* blocks, std::uint32_t count, const EyeSteps& eye, const SideBits& bits);

/// Boxes around sets of planes: when a box is certain, so is every plane in it, with the same sign. Middles and
/// half-widths in steps.
class PlaneBoxes {
 public:
    void add(std::span<const RoundedPlane> planes);
    /// As decide_planes().
    void decide(std::size_t begin, std::uint32_t count, const EyeSteps& eye, const SideBits& bits) const;
    std::size_t bytes() const { return middles_.bytes() + halves_.bytes(); }

 private:
    StepBlocks middles_;
    StepBlocks halves_;
};

}  // namespace hw
