#include "measure/silhouettes/silhouette_oracle.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace hw {
namespace {

using Rational3 = std::array<mpq_class, 3>;
using Wide = long double;

constexpr Wide kWideBound = 1e-17L;  // far above the rounding of a dozen operations with 64 bits

Rational3 rational(const glm::vec3& p)
{
    return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
}

Rational3 minus(const Rational3& a, const Rational3& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational3 cross(const Rational3& a, const Rational3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpq_class dot(const Rational3& a, const Rational3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

OracleEdge edge_of(std::uint32_t u, std::uint32_t v)
{
    return {std::min(u, v), std::max(u, v)};
}

/// Side vectors of a face in long doubles.
struct WideSides {
    Wide px, py, pz, qx, qy, qz;
    WideSides(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
        : px(Wide(b.x) - a.x),
          py(Wide(b.y) - a.y),
          pz(Wide(b.z) - a.z),
          qx(Wide(c.x) - a.x),
          qy(Wide(c.y) - a.y),
          qz(Wide(c.z) - a.z)
    {
    }
};

}  // namespace

SilhouetteOracle::SilhouetteOracle(std::span<const glm::vec3> positions,
                                   std::span<const std::array<std::uint32_t, 3>> faces, Arithmetic arithmetic)
    : positions_(positions), faces_(faces), arithmetic_(arithmetic), is_closed_(positions.size(), true)
{
    std::map<OracleEdge, std::vector<std::uint32_t>> faces_at;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        for (int i = 0; i < 3; ++i) faces_at[edge_of(faces[f][i], faces[f][(i + 1) % 3])].push_back(f);
    }
    edge_count_ = faces_at.size();
    for (const auto& [edge, list] : faces_at) {
        if (list.size() == 2) pairs_.push_back({edge, list[0], list[1]});
        if (list.size() != 2) is_closed_[edge[0]] = is_closed_[edge[1]] = false;
    }
    std::map<std::uint32_t, std::uint32_t> beyond_longest;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (!is_collinear(f)) continue;
        const int side = longest_side(f);
        const auto& around = faces_at[edge_of(faces[f][side], faces[f][(side + 1) % 3])];
        beyond_longest[f] = around.size() == 2 ? around[0] + around[1] - f : f;
    }
    for (const auto& [face, next] : beyond_longest) {
        std::uint32_t source = next;
        for (std::size_t step = 0; step <= beyond_longest.size() && beyond_longest.contains(source); ++step) {
            source = beyond_longest[source];
        }
        inherits_.push_back({face, source});
    }
}

bool SilhouetteOracle::is_collinear(std::uint32_t face) const
{
    const glm::vec3 &a = positions_[faces_[face][0]], &b = positions_[faces_[face][1]],
                    &c = positions_[faces_[face][2]];
    const WideSides s(a, b, c);
    const Wide terms[3][2] = {{s.py * s.qz, s.pz * s.qy}, {s.pz * s.qx, s.px * s.qz}, {s.px * s.qy, s.py * s.qx}};
    for (const auto& [left, right] : terms) {
        if (std::abs(left - right) > kWideBound * (std::abs(left) + std::abs(right))) return false;
    }
    const Rational3 origin = rational(a);
    const Rational3 normal = cross(minus(rational(b), origin), minus(rational(c), origin));
    return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

int SilhouetteOracle::longest_side(std::uint32_t face) const
{
    int longest = 0;
    mpq_class length = -1;
    for (int i = 0; i < 3; ++i) {
        const Rational3 side =
            minus(rational(positions_[faces_[face][(i + 1) % 3]]), rational(positions_[faces_[face][i]]));
        const mpq_class squared = dot(side, side);
        if (squared > length) {
            length = squared;
            longest = i;
        }
    }
    return longest;
}

int SilhouetteOracle::sign(std::uint32_t face, const glm::dvec3& eye, double w) const
{
    const glm::vec3 &a = positions_[faces_[face][0]], &b = positions_[faces_[face][1]],
                    &c = positions_[faces_[face][2]];
    if (arithmetic_ == Arithmetic::filtered) {
        const WideSides s(a, b, c);
        const Wide ex = eye.x - w * Wide(a.x), ey = eye.y - w * Wide(a.y), ez = eye.z - w * Wide(a.z);
        const Wide value =
            ex * (s.py * s.qz - s.pz * s.qy) + ey * (s.pz * s.qx - s.px * s.qz) + ez * (s.px * s.qy - s.py * s.qx);
        const Wide size = std::abs(ex) * (std::abs(s.py * s.qz) + std::abs(s.pz * s.qy)) +
                          std::abs(ey) * (std::abs(s.pz * s.qx) + std::abs(s.px * s.qz)) +
                          std::abs(ez) * (std::abs(s.px * s.qy) + std::abs(s.py * s.qx));
        if (std::abs(value) > kWideBound * size) return value > 0 ? 1 : -1;
    }
    const Rational3 origin = rational(a);
    const Rational3 to_eye = {mpq_class(eye.x) - w * origin[0], mpq_class(eye.y) - w * origin[1],
                              mpq_class(eye.z) - w * origin[2]};
    return sgn(dot(cross(minus(rational(b), origin), minus(rational(c), origin)), to_eye));
}

std::vector<OracleEdge> SilhouetteOracle::silhouettes(const glm::dvec3& eye, double w) const
{
    std::vector<bool> is_front(faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) is_front[f] = sign(f, eye, w) > 0;
    for (const auto& [face, source] : inherits_) is_front[face] = is_front[source];
    std::vector<OracleEdge> found;
    for (const Pair& pair : pairs_) {
        if (is_front[pair.face_a] != is_front[pair.face_b]) found.push_back(pair.edge);
    }
    return found;
}

SilhouetteErrors SilhouetteOracle::judge(std::span<const OracleEdge> found, std::span<const OracleEdge> expected) const
{
    SilhouetteErrors errors;
    std::vector<OracleEdge> wrong;
    std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(wrong));
    errors.false_positives = wrong.size();
    wrong.clear();
    std::set_difference(expected.begin(), expected.end(), found.begin(), found.end(), std::back_inserter(wrong));
    errors.false_negatives = wrong.size();

    std::vector<std::uint32_t> count(positions_.size(), 0);
    for (const OracleEdge& edge : found) {
        for (const std::uint32_t position : edge) ++count[position];
    }
    for (std::size_t i = 0; i < count.size(); ++i) errors.odd_vertices += is_closed_[i] && count[i] % 2 == 1;
    return errors;
}

}  // namespace hw
