// The proof of the bound. Unit: anchor steps for lengths, 1/32767 for normals. A face has unit normal n and corner p;
// the filter knows N = round(32767 n) and P = round((p - c) / h), and tests s = N . (E - P) with E = (eye - c) / h
// against t = 32767 n . ((eye - p) / h), whose sign is the facing. With D = E - P, u = 2^-24:
//   |N - 32767 n| <= sqrt(3)/2 + 0.07      rounding, and the normal itself from doubles to a relative 2e-6 (else N = 0)
//   |P - (p - c) / h| <= sqrt(3)/2 + 0.001  rounding, and the doubles before it
//   |s - N . D| <= 6 u |N| |D| < 0.013 |D|  three products, two sums, the difference and E rounded to floats
// so |s - t| <= 0.95 |D| + 32767 * 0.868, and |D| <= |E| + 32767 sqrt(3). query() takes more than that.
#include "geometry/facing_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define HW_HAS_AVX2_PATH 1
#endif

namespace hw {
namespace {

constexpr double kSteps = 32767.0;
constexpr std::uint32_t kBlock = FacingFilter::kBlock;

struct Streams {
    std::array<const std::int16_t*, 3> normal;
    std::array<const std::int16_t*, 3> anchor;
};

/// Where open faces are listed; the padding after the last face is always open and never listed.
struct OpenList {
    std::span<std::uint32_t> faces;
    std::uint32_t count;
    std::uint32_t face_count;

    void add(std::uint32_t open, std::uint32_t first)
    {
        for (; open != 0; open &= open - 1) {
            const std::uint32_t face = first + static_cast<std::uint32_t>(std::countr_zero(open));
            if (face < face_count) faces[count++] = face;
        }
    }
};

void decide_portably(const Streams& s, std::uint32_t first, std::uint32_t end, const FacingFilter::Query& query,
                     std::uint8_t* facing, OpenList& list)
{
    for (; first < end; first += kBlock) {
        std::uint32_t open = 0;
        for (std::uint32_t i = 0; i < kBlock; ++i) {
            const std::uint32_t f = first + i;
            float distance = 0.0f;
            for (int axis = 0; axis < 3; ++axis) {
                distance += s.normal[axis][f] * (query.eye[axis] - query.anchor_weight * s.anchor[axis][f]);
            }
            facing[f] = distance > query.bound;
            open |= static_cast<std::uint32_t>(!(distance > query.bound) && !(distance < -query.bound)) << i;
        }
        list.add(open, first);
    }
}

#ifdef HW_HAS_AVX2_PATH
__attribute__((target("avx2,fma"))) inline __m256 eight_steps(const std::int16_t* from)
{
    return _mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))));
}

/// A byte of 0 or 1 for each bit.
__attribute__((target("avx2,fma"))) inline __m256i bytes_of(std::uint32_t bits)
{
    const __m256i places = _mm256_setr_epi64x(0, 0x0101010101010101, 0x0202020202020202, 0x0303030303030303);
    const __m256i own_bit = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201ull));
    const __m256i spread = _mm256_shuffle_epi8(_mm256_set1_epi32(static_cast<int>(bits)), places);
    const __m256i is_set = _mm256_cmpeq_epi8(_mm256_and_si256(spread, own_bit), own_bit);
    return _mm256_and_si256(is_set, _mm256_set1_epi8(1));
}

__attribute__((target("avx2,fma"))) void decide_with_avx2(const Streams& s, std::uint32_t first, std::uint32_t end,
                                                          const FacingFilter::Query& query, std::uint8_t* facing,
                                                          OpenList& list)
{
    const __m256 eye[3] = {_mm256_set1_ps(query.eye.x), _mm256_set1_ps(query.eye.y), _mm256_set1_ps(query.eye.z)};
    const __m256 weight = _mm256_set1_ps(query.anchor_weight);
    const __m256 above = _mm256_set1_ps(query.bound), below = _mm256_set1_ps(-query.bound);
    for (; first < end; first += kBlock) {
        std::uint32_t front = 0, back = 0;
        for (std::uint32_t lane = 0; lane < kBlock; lane += 8) {
            __m256 distance = _mm256_setzero_ps();
            for (int axis = 0; axis < 3; ++axis) {
                const __m256 offset = _mm256_fnmadd_ps(weight, eight_steps(s.anchor[axis] + first + lane), eye[axis]);
                distance = _mm256_fmadd_ps(eight_steps(s.normal[axis] + first + lane), offset, distance);
            }
            front |= static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(distance, above, _CMP_GT_OQ))) << lane;
            back |= static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(distance, below, _CMP_LT_OQ))) << lane;
        }
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(facing + first), bytes_of(front));
        const std::uint32_t open = ~(front | back);
        if (open != 0) list.add(open, first);
    }
}
#endif

/// The unit normal in steps, or zero where doubles cannot tell it to 2e-6.
glm::dvec3 rounded_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 p = b - a, q = c - a;
    const glm::dvec3 normal = glm::cross(p, q);
    const double length = glm::length(normal);
    constexpr double kSharpest = 1e-9;  // sine of the corner below which rounding is over 2e-6 of the normal
    if (!(length > kSharpest * glm::length(p) * glm::length(q)) || !(length > 1e-280)) return glm::dvec3(0.0);
    return glm::round(normal * (kSteps / length));
}

}  // namespace

void FacingFilter::prepare(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> faces)
{
    face_count_ = static_cast<std::uint32_t>(faces.size());
    const std::size_t padded = (faces.size() + kBlock - 1) / kBlock * kBlock;
    for (auto& stream : normal_) stream.assign(padded, 0);
    for (auto& stream : anchor_) stream.assign(padded, 0);
    if (positions.empty()) return;
    glm::dvec3 low = positions[0], high = low;
    for (const glm::vec3& p : positions) {
        low = glm::min(low, glm::dvec3(p));
        high = glm::max(high, glm::dvec3(p));
    }
    centre_ = 0.5 * (low + high);
    const glm::dvec3 reach = glm::max(high - centre_, centre_ - low);
    step_ = std::max({reach.x, reach.y, reach.z, 1e-300}) / kSteps;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const glm::dvec3 a = positions[faces[face][0]], b = positions[faces[face][1]], c = positions[faces[face][2]];
        const glm::dvec3 normal = rounded_normal(a, b, c), anchor = glm::round((a - centre_) / step_);
        for (int axis = 0; axis < 3; ++axis) {
            normal_[axis][face] = static_cast<std::int16_t>(normal[axis]);
            anchor_[axis][face] = static_cast<std::int16_t>(std::clamp(anchor[axis], -kSteps, kSteps));
        }
    }
}

FacingFilter::Query FacingFilter::query(const Viewpoint& viewpoint_object) const
{
    glm::dvec3 eye = viewpoint_object.eye;
    if (viewpoint_object.is_orthographic) {
        const double length = std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)});
        eye *= length > 0.0 ? kSteps / length : 0.0;
        return {glm::vec3(eye), 0.0f, static_cast<float>(1.001 * glm::length(eye))};
    }
    eye = (eye - centre_) / step_;
    const double reach = glm::length(eye) + 1.7321 * kSteps;
    if (!(reach < 1e15)) return {glm::vec3(0.0f), 1.0f, std::numeric_limits<float>::infinity()};
    return {glm::vec3(eye), 1.0f, static_cast<float>(1.001 * (0.97 * reach + 0.88 * kSteps))};
}

std::uint32_t FacingFilter::decide(const Query& query, std::uint32_t first_block, std::uint32_t block_count,
                                   std::span<std::uint8_t> facing, std::span<std::uint32_t> open_faces,
                                   std::uint32_t open_count) const
{
    Streams streams;
    for (int axis = 0; axis < 3; ++axis) {
        streams.normal[axis] = normal_[axis].data();
        streams.anchor[axis] = anchor_[axis].data();
    }
    OpenList list{open_faces, open_count, face_count_};
    const std::uint32_t first = first_block * kBlock, end = first + block_count * kBlock;
#ifdef HW_HAS_AVX2_PATH
    static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (has_avx2) {
        decide_with_avx2(streams, first, end, query, facing.data(), list);
        return list.count;
    }
#endif
    decide_portably(streams, first, end, query, facing.data(), list);
    return list.count;
}

}  // namespace hw
