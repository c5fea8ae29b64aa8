#pragma once

#include <array>
#include <cstdint>

#include "hatchway/geometry/surface/rounded_planes.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define HW_HAS_AVX2_PATH 1
#endif

namespace hw {

// What the loops over planes share: sums of products, one at a time or eight. Nobody else needs it.

inline std::int32_t plane_product(const StepBlocks::Block* blocks, std::size_t place,
                                  const std::array<std::int16_t, 4>& eye)
{
    const StepBlocks::Block& block = blocks[place / StepBlocks::kPlaces];
    const auto [a, b] = block.first[place % StepBlocks::kPlaces];
    const auto [c, d] = block.second[place % StepBlocks::kPlaces];
    return a * eye[0] + b * eye[1] + (c * eye[2] + d * eye[3]);
}

/// A bit for each of up to 32 places.
struct WordSides {
    std::uint32_t front, certain;
};

/// The bits of a word that stand for something.
inline std::uint32_t bits_until(std::uint32_t count)
{
    return count >= 32 ? ~0u : (1u << count) - 1;
}

#ifdef HW_HAS_AVX2_PATH
inline bool has_avx2()
{
    static const bool answer = __builtin_cpu_supports("avx2");
    return answer;
}

/// Four numbers in every place.
struct EightEyes {
    __m256i first, second;
};

__attribute__((target("avx2"))) inline EightEyes eight_eyes(const std::array<std::int16_t, 4>& eye)
{
    const auto pair = [](std::int16_t a, std::int16_t b) {
        return static_cast<std::uint16_t>(a) | static_cast<std::int32_t>(b) * 65536;
    };
    return {_mm256_set1_epi32(pair(eye[0], eye[1])), _mm256_set1_epi32(pair(eye[2], eye[3]))};
}

__attribute__((target("avx2"))) inline __m256i eight_products(const StepBlocks::Block& block, const EightEyes& eye)
{
    const __m256i a = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(block.first.data()));
    const __m256i b = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(block.second.data()));
    return _mm256_add_epi32(_mm256_madd_epi16(a, eye.first), _mm256_madd_epi16(b, eye.second));
}

/// Front and certain: a bit for each of eight. `least` is the least magnitude that `middle` stands for.
__attribute__((target("avx2"))) inline WordSides eight_sides(__m256i middle, __m256i least, __m256i bound)
{
    const __m256i is_certain = _mm256_cmpgt_epi32(least, bound);
    const __m256i is_front = _mm256_andnot_si256(_mm256_srai_epi32(middle, 31), is_certain);
    return {static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(is_front))),
            static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(is_certain)))};
}

/// Up to 32 planes; `count` is rounded up to eights.
__attribute__((target("avx2"))) inline WordSides word_sides(const StepBlocks::Block* blocks, std::uint32_t count,
                                                            const EightEyes& eyes, __m256i bound)
{
    WordSides word{0, 0};
    for (std::uint32_t lane = 0; lane < count; lane += 8) {
        const __m256i product = eight_products(*blocks++, eyes);
        const WordSides sides = eight_sides(product, _mm256_abs_epi32(product), bound);
        word.front |= sides.front << lane;
        word.certain |= sides.certain << lane;
    }
    return word;
}
#endif

}  // namespace hw
