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

/// Whether a face goes from the edge's first corner to its second.
bool goes_along(const std::array<std::uint32_t, 3>& face, const OracleEdge& edge)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (face[i] == edge[0]) return face[(i + 1) % 3] == edge[1];
    return false;
}

/// To the precision of a long double.
Wide wide(const mpq_class& number)
{
    const double most = number.get_d();
    return Wide(most) + Wide(mpq_class(number - most).get_d());
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

/// An eye in the space of the faces, homogeneous with w 1 or 0: exactly, and rounded.
struct SilhouetteOracle::Eye {
    Eye(Rational3 place, int is_place) : exact(std::move(place)), w(is_place)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) rounded[axis] = wide(exact[axis]);
    }
    Rational3 exact;
    int w;
    std::array<Wide, 3> rounded;
};

SilhouetteOracle::SilhouetteOracle(std::span<const glm::vec3> positions,
                                   std::span<const std::array<std::uint32_t, 3>> faces, Arithmetic arithmetic,
                                   std::span<const OraclePlane> given, Winding winding)
    : positions_(positions),
      faces_(faces),
      arithmetic_(arithmetic),
      winding_(winding),
      is_closed_(positions.size(), true)
{
    std::map<OracleEdge, std::vector<std::uint32_t>> faces_at;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        for (int i = 0; i < 3; ++i) faces_at[edge_of(faces[f][i], faces[f][(i + 1) % 3])].push_back(f);
    }
    edge_count_ = faces_at.size();
    for (const auto& [edge, list] : faces_at) {
        if (list.size() == 2)
            pairs_.push_back({edge, list[0], list[1],
                              winding == Winding::says_nothing &&
                                  goes_along(faces[list[0]], edge) == goes_along(faces[list[1]], edge)});
        if (list.size() != 2) is_closed_[edge[0]] = is_closed_[edge[1]] = false;
    }
    std::map<std::uint32_t, std::uint32_t> beyond_longest;
    std::vector<bool> is_given(faces.size(), false);
    for (const OraclePlane& plane : given) {
        is_given[plane.face] = true;
        inherits_.push_back({plane.face, plane.source});
    }
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        if (is_given[f] || !is_collinear(f)) continue;
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

int SilhouetteOracle::sign(std::uint32_t face, const Eye& eye) const
{
    const glm::vec3 &a = positions_[faces_[face][0]], &b = positions_[faces_[face][1]],
                    &c = positions_[faces_[face][2]];
    if (arithmetic_ == Arithmetic::filtered) {
        const WideSides s(a, b, c);
        // What rounding the eye may lose counts beside the eye's distance.
        const auto away = [&](Wide e, Wide corner) { return std::abs(e) + std::abs(corner); };
        const auto& [ex, ey, ez] = eye.rounded;
        const Wide ax = eye.w * Wide(a.x), ay = eye.w * Wide(a.y), az = eye.w * Wide(a.z);
        const Wide value = (ex - ax) * (s.py * s.qz - s.pz * s.qy) + (ey - ay) * (s.pz * s.qx - s.px * s.qz) +
                           (ez - az) * (s.px * s.qy - s.py * s.qx);
        const Wide size = away(ex, ax) * (std::abs(s.py * s.qz) + std::abs(s.pz * s.qy)) +
                          away(ey, ay) * (std::abs(s.pz * s.qx) + std::abs(s.px * s.qz)) +
                          away(ez, az) * (std::abs(s.px * s.qy) + std::abs(s.py * s.qx));
        if (std::abs(value) > kWideBound * size) return value > 0 ? 1 : -1;
    }
    const Rational3 origin = rational(a);
    Rational3 to_eye = eye.exact;
    if (eye.w != 0) to_eye = minus(to_eye, origin);
    return sgn(dot(cross(minus(rational(b), origin), minus(rational(c), origin)), to_eye));
}

std::vector<OracleEdge> SilhouetteOracle::silhouettes(const glm::dvec3& eye, double w) const
{
    return silhouettes_from({{mpq_class(eye.x), mpq_class(eye.y), mpq_class(eye.z)}, w != 0.0});
}

std::vector<OracleEdge> SilhouetteOracle::silhouettes_in_world(const glm::dvec3& eye_world,
                                                               const glm::dmat4& world_from_object, double w) const
{
    return silhouettes_from(eye_in_object(eye_world, world_from_object, w));
}

std::vector<OracleEdge> SilhouetteOracle::edge_on_in_world(const glm::dvec3& eye_world,
                                                           const glm::dmat4& world_from_object, double w) const
{
    const std::vector<signed char> side = sides_from(eye_in_object(eye_world, world_from_object, w));
    std::vector<OracleEdge> edge_on;
    for (const Pair& pair : pairs_)
        if (side[pair.face_a] == 0 || side[pair.face_b] == 0) edge_on.push_back(pair.edge);
    return edge_on;
}

SilhouetteOracle::Eye SilhouetteOracle::eye_in_object(const glm::dvec3& eye_world, const glm::dmat4& world_from_object,
                                                      double w)
{
    std::array<Rational3, 3> axes;  // columns of the matrix
    Rational3 to_eye;
    for (int axis = 0; axis < 3; ++axis) {
        for (int row = 0; row < 3; ++row) axes[axis][row] = mpq_class(world_from_object[axis][row]);
        to_eye[axis] = mpq_class(eye_world[axis]);
        if (w != 0.0) to_eye[axis] -= mpq_class(world_from_object[3][axis]);
    }
    // Cramer's rule. A mirroring matrix turns no face over: facing belongs to the object's own winding.
    const mpq_class volume = dot(axes[0], cross(axes[1], axes[2]));
    const Rational3 eye_object{dot(to_eye, cross(axes[1], axes[2])) / volume,
                               dot(to_eye, cross(axes[2], axes[0])) / volume,
                               dot(to_eye, cross(axes[0], axes[1])) / volume};
    return {eye_object, w != 0.0};
}

std::vector<signed char> SilhouetteOracle::sides_from(const Eye& eye) const
{
    std::vector<signed char> side(faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) side[f] = static_cast<signed char>(sign(f, eye));
    for (const auto& [face, source] : inherits_) side[face] = source < faces_.size() ? side[source] : 0;
    return side;
}

std::vector<OracleEdge> SilhouetteOracle::silhouettes_from(const Eye& eye) const
{
    const std::vector<signed char> side = sides_from(eye);
    std::vector<OracleEdge> found;
    for (const Pair& pair : pairs_) {
        const bool is_open = side[pair.face_a] == 0 || side[pair.face_b] == 0;
        if (is_open && winding_ == Winding::says_nothing) continue;
        const int side_b = pair.is_turned ? -side[pair.face_b] : side[pair.face_b];
        if ((side[pair.face_a] > 0) != (side_b > 0)) found.push_back(pair.edge);
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
        for (const std::uint32_t position : edge)
            if (position < count.size()) ++count[position];
    }
    for (std::size_t i = 0; i < count.size(); ++i) errors.odd_vertices += is_closed_[i] && count[i] % 2 == 1;
    return errors;
}

}  // namespace hw
