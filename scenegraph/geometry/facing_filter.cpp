// The proof of the bound. Unit: anchor steps for lengths, 1/32767 for normals. A face has unit normal n and corner p; the
// filter knows N = round(32767 n) and P = round((p - c) / h), and tests s = N . (E - P) with E = (eye - c) / h against
// t = 32767 n . ((eye - p) / h), whose sign is the facing. With D = E - P, u = 2^-24:
//   |N - 32767 n| <= sqrt(3)/2 + 0.07      rounding, and the normal itself from doubles to a relative 2e-6 (else N = 0)
//   |P - (p - c) / h| <= sqrt(3)/2 + 0.001  rounding, and the doubles before it
//   |s - N . D| <= 6 u |N| |D| < 0.013 |D|  three products, two sums, the difference and E rounded to floats
// so |s - t| <= 0.95 |D| + 32767 * 0.868, and |D| <= |E| + 32767 sqrt(3). bound_of() returns more than that.
#include "geometry/facing_filter.hpp"

#include <algorithm>
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
constexpr std::size_t kBlock = 32;

/// The eye in steps and the certainty bound for one query.
struct Query {
    glm::vec3 eye;
    float anchor_weight;  ///< 1; 0 for orthographic views, whose faces need no anchor.
    float bound;
};

Query query_of(const Viewpoint& viewpoint, const glm::dvec3& centre, double step)
{
    glm::dvec3 eye = viewpoint.eye;
    if (viewpoint.is_orthographic) {
        const double length = std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)});
        eye *= length > 0.0 ? kSteps / length : 0.0;
        return {glm::vec3(eye), 0.0f, static_cast<float>(1.001 * glm::length(eye))};
    }
    eye = (eye - centre) / step;
    const double reach = glm::length(eye) + 1.7321 * kSteps;
    const bool is_near = reach < 1e15;
    return {is_near ? glm::vec3(eye) : glm::vec3(0.0f), 1.0f,
            is_near ? static_cast<float>(1.001 * (0.97 * reach + 0.88 * kSteps))
                    : std::numeric_limits<float>::infinity()};
}

struct Streams {
    std::array<const std::int16_t*, 3> normal;
    std::array<const std::int16_t*, 3> anchor;
};

struct Words {
    std::uint32_t front;
    std::uint32_t open;
};

Words decide_block(const Streams& s, std::size_t first, const Query& query)
{
    Words words{0, 0};
    for (std::size_t i = 0; i < kBlock; ++i) {
        const std::size_t f = first + i;
        float distance = 0.0f;
        for (int axis = 0; axis < 3; ++axis) {
            distance += s.normal[axis][f] * (query.eye[axis] - query.anchor_weight * s.anchor[axis][f]);
        }
        const bool is_front = distance > query.bound, is_back = distance < -query.bound;
        words.front |= static_cast<std::uint32_t>(is_front) << i;
        words.open |= static_cast<std::uint32_t>(!is_front && !is_back) << i;
    }
    return words;
}

void store_open(std::uint32_t open, std::uint32_t first, std::span<std::uint32_t> open_faces, std::uint32_t& count)
{
    for (; open != 0; open &= open - 1) {
        open_faces[count++] = first + static_cast<std::uint32_t>(__builtin_ctz(open));
    }
}

std::uint32_t decide_portably(const Streams& streams, std::size_t padded, const Query& query, std::uint32_t* bits,
                              std::span<std::uint32_t> open_faces)
{
    std::uint32_t count = 0;
    for (std::size_t first = 0; first < padded; first += kBlock) {
        const Words words = decide_block(streams, first, query);
        bits[first / kBlock] = words.front;
        store_open(words.open, static_cast<std::uint32_t>(first), open_faces, count);
    }
    return count;
}

#ifdef HW_HAS_AVX2_PATH
__attribute__((target("avx2,fma"))) inline __m256 eight_steps(const std::int16_t* from)
{
    return _mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))));
}

__attribute__((target("avx2,fma"))) std::uint32_t decide_with_avx2(const Streams& s, std::size_t padded,
                                                                   const Query& query, std::uint32_t* bits,
                                                                   std::span<std::uint32_t> open_faces)
{
    const __m256 eye[3] = {_mm256_set1_ps(query.eye.x), _mm256_set1_ps(query.eye.y), _mm256_set1_ps(query.eye.z)};
    const __m256 weight = _mm256_set1_ps(query.anchor_weight);
    const __m256 above = _mm256_set1_ps(query.bound), below = _mm256_set1_ps(-query.bound);
    std::uint32_t count = 0;
    for (std::size_t first = 0; first < padded; first += kBlock) {
        std::uint32_t front = 0, back = 0;
        for (unsigned lane = 0; lane < kBlock; lane += 8) {
            __m256 distance = _mm256_setzero_ps();
            for (int axis = 0; axis < 3; ++axis) {
                const __m256 offset =
                    _mm256_fnmadd_ps(weight, eight_steps(s.anchor[axis] + first + lane), eye[axis]);
                distance = _mm256_fmadd_ps(eight_steps(s.normal[axis] + first + lane), offset, distance);
            }
            front |= static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(distance, above, _CMP_GT_OQ))) << lane;
            back |= static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(distance, below, _CMP_LT_OQ))) << lane;
        }
        bits[first / kBlock] = front;
        const std::uint32_t open = ~(front | back);
        if (open != 0) store_open(open, static_cast<std::uint32_t>(first), open_faces, count);
    }
    return count;
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

std::uint32_t FacingFilter::decide(const Viewpoint& viewpoint_object, std::span<std::uint32_t> facing_bits,
                                   std::span<std::uint32_t> open_faces) const
{
    const Query query = query_of(viewpoint_object, centre_, step_);
    Streams streams;
    for (int axis = 0; axis < 3; ++axis) {
        streams.normal[axis] = normal_[axis].data();
        streams.anchor[axis] = anchor_[axis].data();
    }
    const std::size_t padded = normal_[0].size();
    std::uint32_t count = 0;
#ifdef HW_HAS_AVX2_PATH
    static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    count = has_avx2 ? decide_with_avx2(streams, padded, query, facing_bits.data(), open_faces)
                     : decide_portably(streams, padded, query, facing_bits.data(), open_faces);
#else
    count = decide_portably(streams, padded, query, facing_bits.data(), open_faces);
#endif
    while (count > 0 && open_faces[count - 1] >= face_count_) --count;  // the padding is always open
    return count;
}

}  // namespace hw
