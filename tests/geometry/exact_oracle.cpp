#include "geometry/exact_oracle.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace hw::test {
namespace {

using Rational3 = std::array<mpq_class, 3>;

Rational3 rational(const glm::vec3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

Rational3 minus(const Rational3& a, const Rational3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Rational3 cross(const Rational3& a, const Rational3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpq_class dot(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

ExactOracle::ExactOracle(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> faces,
                         bool every_sign_rational)
    : positions_(positions), faces_(faces), every_sign_rational_(every_sign_rational)
{
    std::map<Edge, std::vector<std::uint32_t>> faces_at;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t u = faces[f][i], v = faces[f][(i + 1) % 3];
            faces_at[{std::min(u, v), std::max(u, v)}].push_back(f);
        }
    }
    edge_count_ = faces_at.size();
    for (const auto& [edge, list] : faces_at) {
        if (list.size() == 2) pairs_.push_back({edge, list[0], list[1]});
    }
    std::map<std::uint32_t, std::uint32_t> beyond_longest;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const Rational3 p[3] = {rational(positions[faces[f][0]]), rational(positions[faces[f][1]]),
                                rational(positions[faces[f][2]])};
        const Rational3 n = cross(minus(p[1], p[0]), minus(p[2], p[0]));
        if (n[0] != 0 || n[1] != 0 || n[2] != 0) continue;
        int longest = 0;
        mpq_class length = -1;
        for (int i = 0; i < 3; ++i) {
            const Rational3 side = minus(p[(i + 1) % 3], p[i]);
            const mpq_class squared = dot(side, side);
            if (squared > length) {
                length = squared;
                longest = i;
            }
        }
        const std::uint32_t u = faces[f][longest], v = faces[f][(longest + 1) % 3];
        const auto& around = faces_at[{std::min(u, v), std::max(u, v)}];
        beyond_longest[f] = around.size() == 2 ? around[0] + around[1] - f : f;
    }
    for (const auto& [face, next] : beyond_longest) {
        std::uint32_t source = next;
        for (std::size_t step = 0; step <= beyond_longest.size() && beyond_longest.count(source); ++step) {
            source = beyond_longest[source];
        }
        inherits_.push_back({face, source});
    }
}

int ExactOracle::sign(std::uint32_t face, const glm::dvec3& eye, double w) const
{
    const glm::vec3 &a = positions_[faces_[face][0]], &b = positions_[faces_[face][1]], &c = positions_[faces_[face][2]];
    if (!every_sign_rational_) {
        using Wide = long double;
        const Wide px = Wide(b.x) - a.x, py = Wide(b.y) - a.y, pz = Wide(b.z) - a.z;
        const Wide qx = Wide(c.x) - a.x, qy = Wide(c.y) - a.y, qz = Wide(c.z) - a.z;
        const Wide ex = eye.x - w * Wide(a.x), ey = eye.y - w * Wide(a.y), ez = eye.z - w * Wide(a.z);
        const Wide value = ex * (py * qz - pz * qy) + ey * (pz * qx - px * qz) + ez * (px * qy - py * qx);
        const Wide size = std::abs(ex) * (std::abs(py * qz) + std::abs(pz * qy)) +
                          std::abs(ey) * (std::abs(pz * qx) + std::abs(px * qz)) +
                          std::abs(ez) * (std::abs(px * qy) + std::abs(py * qx));
        if (std::abs(value) > 1e-17L * size) return value > 0 ? 1 : -1;
    }
    const Rational3 pa = rational(a);
    const Rational3 to_eye = {mpq_class(eye.x) - w * pa[0], mpq_class(eye.y) - w * pa[1], mpq_class(eye.z) - w * pa[2]};
    return sgn(dot(cross(minus(rational(b), pa), minus(rational(c), pa)), to_eye));
}

std::vector<ExactOracle::Edge> ExactOracle::silhouettes(const glm::dvec3& eye, double w) const
{
    std::vector<bool> is_front(faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) is_front[f] = sign(f, eye, w) > 0;
    for (const auto& [face, source] : inherits_) is_front[face] = is_front[source];
    std::vector<Edge> found;
    for (const Pair& pair : pairs_) {
        if (is_front[pair.a] != is_front[pair.b]) found.push_back(pair.edge);
    }
    return found;
}

}  // namespace hw::test
