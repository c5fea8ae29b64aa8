#include "hatchway/geometry/surface/rounded_planes.hpp"

#include <algorithm>
#include <cmath>

#include "hatchway/geometry/surface/plane_products.hpp"

namespace hw {
namespace {

using Block = StepBlocks::Block;

/// From the first place on; for boxes their half-widths too.
struct Places {
    const Block* middles;
    const Block* halves = nullptr;
};

std::array<std::int16_t, 4> magnitudes(const std::array<std::int16_t, 4>& eye)
{
    std::array<std::int16_t, 4> result;
    std::transform(eye.begin(), eye.end(), result.begin(),
                   [](std::int16_t x) { return static_cast<std::int16_t>(std::abs(x)); });
    return result;
}

/// A set of planes is certain when the magnitude of its middle exceeds its half-widths by more than the bound: both are
/// below 2^31, so their difference is an int.
template <bool kHasHalves>
void decide_portably(const Places& places, std::uint32_t count, const EyeSteps& eye, const SideBits& bits)
{
    const std::array<std::int16_t, 4> reach = magnitudes(eye.eye);
    for (std::uint32_t word = 0; 32 * word < count; ++word) {
        std::uint32_t front = 0, certain = 0;
        for (std::uint32_t bit = 0; bit < std::min(32u, count - 32 * word); ++bit) {
            const std::uint32_t i = 32 * word + bit;
            const std::int32_t middle = plane_product(places.middles, i, eye.eye);
            const std::int32_t half = kHasHalves ? plane_product(places.halves, i, reach) : 0;
            certain |= static_cast<std::uint32_t>(std::abs(middle) - half > eye.bound) << bit;
            front |= static_cast<std::uint32_t>(middle > 0) << bit;
        }
        bits.front[word] = front & certain;
        bits.open[word] = ~certain & bits_until(count - 32 * word);
    }
}

#ifdef HW_HAS_AVX2_PATH
__attribute__((target("avx2"))) inline WordSides box_word_sides(const Places& places, std::uint32_t first,
                                                                std::uint32_t count, const EightEyes& eyes,
                                                                const EightEyes& reach, __m256i bound)
{
    WordSides word{0, 0};
    for (std::uint32_t lane = 0; lane < count; lane += 8) {
        const std::uint32_t block = (first + lane) / 8;
        const __m256i middle = eight_products(places.middles[block], eyes);
        const __m256i half = eight_products(places.halves[block], reach);
        const WordSides sides = eight_sides(middle, _mm256_sub_epi32(_mm256_abs_epi32(middle), half), bound);
        word.front |= sides.front << lane;
        word.certain |= sides.certain << lane;
    }
    return word;
}

template <bool kHasHalves>
__attribute__((target("avx2"))) void decide_with_avx2(const Places& places, std::uint32_t count, const EyeSteps& eye,
                                                      const SideBits& bits)
{
    const EightEyes eyes = eight_eyes(eye.eye), reach = eight_eyes(magnitudes(eye.eye));
    const __m256i bound = _mm256_set1_epi32(eye.bound);
    for (std::uint32_t first = 0; first < count; first += 32) {
        const std::uint32_t used = std::min(32u, count - first);
        const WordSides sides = kHasHalves ? box_word_sides(places, first, used, eyes, reach, bound)
                                           : word_sides(places.middles + first / 8, used, eyes, bound);
        bits.front[first / 32] = sides.front & bits_until(used);
        bits.open[first / 32] = ~sides.certain & bits_until(used);
    }
}
#endif

template <bool kHasHalves>
void decide(const Places& places, std::uint32_t count, const EyeSteps& eye, const SideBits& bits)
{
#ifdef HW_HAS_AVX2_PATH
    if (has_avx2()) return decide_with_avx2<kHasHalves>(places, count, eye, bits);
#endif
    decide_portably<kHasHalves>(places, count, eye, bits);
}

}  // namespace

void put_plane(const RoundedPlane& plane, StepBlocks::Block* blocks, std::size_t place)
{
    StepBlocks::Block& block = blocks[place / StepBlocks::kPlaces];
    block.first[place % StepBlocks::kPlaces] = {plane[0], plane[1]};
    block.second[place % StepBlocks::kPlaces] = {plane[2], plane[3]};
}

void StepBlocks::add(const RoundedPlane& plane)
{
    if (count_ % kPlaces == 0) blocks_.push_back({});
    put_plane(plane, blocks_.data(), count_++);
}

void decide_planes(const StepBlocks::Block* blocks, std::uint32_t count, const EyeSteps& eye, const SideBits& bits)
{
    decide<false>({blocks}, count, eye, bits);
}

void PlaneBoxes::add(std::span<const RoundedPlane> planes)
{
    RoundedPlane middle, half;
    for (std::size_t axis = 0; axis < 4; ++axis) {
        int low = 32767, high = -32767;
        for (const RoundedPlane& plane : planes) {
            low = std::min<int>(low, plane[axis]);
            high = std::max<int>(high, plane[axis]);
        }
        const int centre = (low + high) / 2;
        middle[axis] = static_cast<std::int16_t>(centre);
        half[axis] = static_cast<std::int16_t>(std::max(high - centre, centre - low));
    }
    middles_.add(middle);
    halves_.add(half);
}

void PlaneBoxes::decide(std::size_t begin, std::uint32_t count, const EyeSteps& eye, const SideBits& bits) const
{
    hw::decide<true>({middles_.block(begin), halves_.block(begin)}, count, eye, bits);
}

}  // namespace hw
