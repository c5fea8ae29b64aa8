// Determinants are formed from coordinate differences, never from n.e + d: at an offset of 1e5 the plane form loses
// more digits than a mesh has. The file is compiled without contraction: a fused multiply-add would break two_product's
// tail.
#include "hatchway/geometry/exact/predicates.hpp"

#include <cmath>
#include <cstddef>

#include "hatchway/geometry/exact/expansion.hpp"

namespace hw {
namespace {

constexpr double kEpsilon = 0x1p-53;
constexpr double kVolumeBound = (7.0 + 56.0 * kEpsilon) * kEpsilon;   // Shewchuk's o3derrboundA
constexpr double kProductBound = (5.0 + 48.0 * kEpsilon) * kEpsilon;  // the same without the third difference
constexpr double kAreaBound = (3.0 + 16.0 * kEpsilon) * kEpsilon;     // Shewchuk's ccwerrboundA

struct Filtered {
    double value;
    double bound;
};

int sign_of(double x)
{
    return (x > 0.0) - (x < 0.0);
}

/// p x q . r in doubles, with the sum of magnitudes that scales its error.
Filtered triple_product(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r)
{
    const double yz = p.y * q.z, zy = p.z * q.y;
    const double zx = p.z * q.x, xz = p.x * q.z;
    const double xy = p.x * q.y, yx = p.y * q.x;
    return {r.x * (yz - zy) + r.y * (zx - xz) + r.z * (xy - yx), std::abs(r.x) * (std::abs(yz) + std::abs(zy)) +
                                                                     std::abs(r.y) * (std::abs(zx) + std::abs(xz)) +
                                                                     std::abs(r.z) * (std::abs(xy) + std::abs(yx))};
}

using Difference = Expansion<2>;

struct Differences {
    Difference x, y, z;
};

Differences exact_differences(const glm::dvec3& a, const glm::dvec3& b)
{
    return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

/// p x q, one component of it.
Expansion<16> cross_term(const Difference& a, const Difference& b, const Difference& c, const Difference& d)
{
    return sum(product(a, b), negated(product(c, d)));
}

int exact_sign(const Differences& p, const Differences& q, const Differences& r)
{
    const auto x = product(cross_term(p.y, q.z, p.z, q.y), r.x);
    const auto y = product(cross_term(p.z, q.x, p.x, q.z), r.y);
    const auto z = product(cross_term(p.x, q.y, p.y, q.x), r.z);
    return sum(sum(x, y), z).sign();
}

int volume_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                PredicateStage& stage)
{
    const Filtered filtered = triple_product(b - a, c - a, d - a);
    stage = PredicateStage::filter;
    if (std::abs(filtered.value) > kVolumeBound * filtered.bound) return sign_of(filtered.value);
    if (filtered.bound == 0.0) return 0;
    stage = PredicateStage::exact;
    return exact_sign(exact_differences(b, a), exact_differences(c, a), exact_differences(d, a));
}

int product_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& direction,
                 PredicateStage& stage)
{
    const Filtered filtered = triple_product(b - a, c - a, direction);
    stage = PredicateStage::filter;
    if (std::abs(filtered.value) > kProductBound * filtered.bound) return sign_of(filtered.value);
    if (filtered.bound == 0.0) return 0;
    stage = PredicateStage::exact;
    return exact_sign(exact_differences(b, a), exact_differences(c, a), exact_differences(direction, glm::dvec3(0.0)));
}

/// Whether (b - a) x (c - a) has a zero component, given one pair of axes.
bool is_area_zero(double pu, double pv, double qu, double qv, const Difference& pu_exact, const Difference& pv_exact,
                  const Difference& qu_exact, const Difference& qv_exact)
{
    const double left = pu * qv, right = pv * qu;
    if (std::abs(left - right) > kAreaBound * (std::abs(left) + std::abs(right))) return false;
    return cross_term(pu_exact, qv_exact, pv_exact, qu_exact).sign() == 0;
}

}  // namespace

int orient3d_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    PredicateStage stage;
    return volume_sign(a, b, c, d, stage);
}

int direction_sign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& direction)
{
    PredicateStage stage;
    return product_sign(a, b, c, direction, stage);
}

int facing_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Viewpoint& viewpoint_object,
                PredicateStage* stage)
{
    PredicateStage used;
    const int sign = viewpoint_object.is_orthographic ? product_sign(a, b, c, viewpoint_object.eye, used)
                                                      : volume_sign(a, b, c, viewpoint_object.eye, used);
    if (stage) *stage = used;
    return sign;
}

bool are_collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 p = glm::dvec3(b) - glm::dvec3(a), q = glm::dvec3(c) - glm::dvec3(a);
    const Differences pe = exact_differences(b, a), qe = exact_differences(c, a);
    return is_area_zero(p.x, p.y, q.x, q.y, pe.x, pe.y, qe.x, qe.y) &&
           is_area_zero(p.y, p.z, q.y, q.z, pe.y, pe.z, qe.y, qe.z) &&
           is_area_zero(p.z, p.x, q.z, q.x, pe.z, pe.x, qe.z, qe.x);
}

}  // namespace hw
