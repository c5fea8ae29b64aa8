#include "measure/walk/walk_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>

namespace hw::measure {
namespace {

constexpr std::uint32_t kTrianglesOfLeaf = 8;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLevelEnough = 0.7;  // of a normal's height: what a place to stand lies on
constexpr double kClear_m = 1.5;
constexpr int kSides = 16;

using Corners = std::array<glm::dvec3, 3>;

double signed_volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    return glm::dot(glm::cross(b - a, c - a), d - a);
}

/// Whether the open segment passes through the inside of the triangle; touching is none.
bool passes(const glm::dvec3& from, const glm::dvec3& to, const Corners& t)
{
    const double before = signed_volume(t[0], t[1], t[2], from);
    const double after = signed_volume(t[0], t[1], t[2], to);
    if (!(before * after < 0.0)) return false;
    const double u = signed_volume(from, to, t[0], t[1]);
    const double v = signed_volume(from, to, t[1], t[2]);
    const double w = signed_volume(from, to, t[2], t[0]);
    return (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
}

/// An upright segment.
struct Axis {
    double x = 0.0, z = 0.0, low = 0.0, high = 0.0;

    double beyond(double y) const { return y < low ? low - y : y > high ? y - high : 0.0; }
};

/// Squared distance from the axis to a point.
double squared_distance(const Axis& axis, const glm::dvec3& p)
{
    const double x = p.x - axis.x, z = p.z - axis.z, y = axis.beyond(p.y);
    return x * x + y * y + z * z;
}

/// Squared distance from the axis to the segment from `p` to `q`. Along the segment it is convex and made of three
/// parabolas: below the axis, beside it, above it.
double squared_distance(const Axis& axis, const glm::dvec3& p, const glm::dvec3& q)
{
    const glm::dvec3 way = q - p;
    const double flat = way.x * way.x + way.z * way.z;
    const double across = (axis.x - p.x) * way.x + (axis.z - p.z) * way.z;
    double best = std::min(squared_distance(axis, p), squared_distance(axis, q));
    const auto offer = [&](double t) {
        if (t > 0.0 && t < 1.0) best = std::min(best, squared_distance(axis, p + t * way));
    };
    if (flat > 0.0) offer(across / flat);
    const double whole = flat + way.y * way.y;
    if (whole > 0.0)
        for (const double y : {axis.low, axis.high}) offer((across + (y - p.y) * way.y) / whole);
    if (way.y != 0.0)
        for (const double y : {axis.low, axis.high}) offer((y - p.y) / way.y);
    return best;
}

/// Distance from a point to the inside of a triangle along its normal; infinite where its foot lies outside.
double distance_to_inside(const glm::dvec3& p, const Corners& t, const glm::dvec3& normal)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0.0) return kInfinity;
    return std::abs(glm::dot(p - t[0], normal));
}

double distance(const Axis& axis, const Corners& t)
{
    const glm::dvec3 low(axis.x, axis.low, axis.z), high(axis.x, axis.high, axis.z);
    if (passes(low, high, t)) return 0.0;
    double squared = kInfinity;
    for (std::size_t i = 0; i < 3; ++i) squared = std::min(squared, squared_distance(axis, t[i], t[(i + 1) % 3]));
    const glm::dvec3 normal = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
    return std::min({std::sqrt(squared), distance_to_inside(low, t, normal), distance_to_inside(high, t, normal)});
}

/// Whether what the segment from `low` to `high` sweeps, moved by `way`, meets the triangle.
bool sweeps_through(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& way, const Corners& t)
{
    const Corners swept[2] = {{low, high, high + way}, {low, high + way, low + way}};
    for (const Corners& half : swept) {
        for (std::size_t i = 0; i < 3; ++i)
            if (passes(half[i], half[(i + 1) % 3], t) || passes(t[i], t[(i + 1) % 3], half)) return true;
    }
    return false;
}

Box box_of(const glm::dvec3& a, const glm::dvec3& b, double margin)
{
    Box box;
    box.add(glm::min(a, b) - margin);
    box.add(glm::max(a, b) + margin);
    return box;
}

}  // namespace

WalkOracle::WalkOracle(const Scene& scene, std::span<const ObjectLook> looks)
{
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        const bool is_moved = scene.nodes[static_cast<std::size_t>(scene.objects[id].node)].is_animated;
        if (!is_moved && (looks.empty() || looks[id].collides)) add_object(scene, id);
    }
    if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

void WalkOracle::add_object(const Scene& scene, ObjectId id)
{
    const Object& object = scene.objects[id];
    const MeshData& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    const glm::dmat4& matrix = scene.world_from_object(id);
    const bool is_mirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
    const bool is_double_sided = scene.materials[static_cast<std::size_t>(object.material)].is_double_sided;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Triangle triangle{.is_double_sided = is_double_sided};
        glm::dvec3* const corners[3] = {&triangle.a, &triangle.b, &triangle.c};
        for (std::size_t k = 0; k < 3; ++k)
            *corners[is_mirrored ? 2 - k : k] =
                glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
        const double doubled_area = glm::length(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
        if (!(doubled_area > 0.0) || !std::isfinite(doubled_area)) continue;
        for (const glm::dvec3* corner : corners) bounds_.add(*corner);
        triangles_.push_back(triangle);
    }
}

void WalkOracle::build(std::uint32_t first, std::uint32_t last)
{
    const std::size_t index = nodes_.size();
    nodes_.push_back({.first = first, .last = last});
    Box bounds;
    for (std::uint32_t i = first; i < last; ++i)
        for (const glm::dvec3& corner : {triangles_[i].a, triangles_[i].b, triangles_[i].c}) bounds.add(corner);
    nodes_[index].bounds = bounds;
    if (last - first <= kTrianglesOfLeaf) return;
    const glm::dvec3 size = bounds.size();
    const int axis = size.y > size.x && size.y > size.z ? 1 : size.x > size.z ? 0 : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    const auto low = [axis](const Triangle& t) { return std::min({t.a[axis], t.b[axis], t.c[axis]}); };
    std::stable_sort(triangles_.begin() + first, triangles_.begin() + last,
                     [&](const Triangle& s, const Triangle& t) { return low(s) < low(t); });
    build(first, middle);
    nodes_[index].second_child = static_cast<std::uint32_t>(nodes_.size());
    build(middle, last);
}

template <typename Visit>
void WalkOracle::visit(const Box& box, Visit&& visit) const
{
    std::size_t at = nodes_.empty() ? 1 : 0;
    std::array<std::uint32_t, 64> later{};
    std::size_t waiting = 0;
    while (at < nodes_.size()) {
        const Node& node = nodes_[at];
        if (node.bounds.overlaps(box)) {
            if (node.second_child > 0) {
                later[waiting++] = node.second_child;
                ++at;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i) {
                const Triangle& t = triangles_[i];
                Box bounds = box_of(t.a, t.b, 0.0);
                bounds.add(t.c);
                if (bounds.overlaps(box)) visit(t);
            }
        }
        if (waiting == 0) return;
        at = later[--waiting];
    }
}

double WalkOracle::depth(const glm::dvec3& foot, const JudgedBody& body) const
{
    const Axis axis{foot.x, foot.z, foot.y + body.radius_m,
                    foot.y + std::max(body.height_m - body.radius_m, body.radius_m)};
    const glm::dvec3 crown = foot + glm::dvec3(0.0, body.height_m, 0.0);
    double nearest = body.radius_m;
    visit(box_of(foot, crown, body.radius_m), [&](const Triangle& t) {
        nearest = std::min(nearest, distance(axis, {t.a, t.b, t.c}));
    });
    return body.radius_m - nearest;
}

std::optional<glm::dvec3> WalkOracle::crossed(const glm::dvec3& from, const glm::dvec3& to,
                                              const JudgedBody& body) const
{
    const double top = body.height_m - body.radius_m;
    const glm::dvec3 low = from + glm::dvec3(0.0, std::min(std::max(body.radius_m, body.step_m), top), 0.0);
    const glm::dvec3 high = from + glm::dvec3(0.0, top, 0.0);
    Box box = box_of(low, high, 0.0);
    box.add(box_of(low + (to - from), high + (to - from), 0.0));
    if (is_parted(low, high)) return std::nullopt;
    std::optional<glm::dvec3> normal;
    visit(box, [&](const Triangle& t) {
        if (!normal && sweeps_through(low, high, to - from, {t.a, t.b, t.c}))
            normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
    });
    return normal;
}

bool WalkOracle::is_parted(const glm::dvec3& from, const glm::dvec3& to) const
{
    bool result = false;
    visit(box_of(from, to, 0.0), [&](const Triangle& t) { result = result || passes(from, to, {t.a, t.b, t.c}); });
    return result;
}

bool WalkOracle::has_ground_below(const glm::dvec3& point) const
{
    constexpr double kAside_m = 1e-3;  // one line might pass between two triangles
    for (const glm::dvec2& aside : {glm::dvec2(0.0), glm::dvec2(1.0, 0.3), glm::dvec2(-0.4, 1.0)}) {
        const glm::dvec3 from = point + kAside_m * glm::dvec3(aside.x, 0.0, aside.y);
        if (is_parted(from, {from.x, bounds_.min.y - 1.0, from.z})) return true;
    }
    return false;
}

std::vector<WalkOracle::Hit> WalkOracle::hits(const glm::dvec3& from, const glm::dvec3& to) const
{
    std::vector<Hit> result;
    visit(box_of(from, to, 0.0), [&](const Triangle& t) {
        if (!passes(from, to, {t.a, t.b, t.c})) return;
        const glm::dvec3 normal = glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
        const double down = glm::dot(to - from, normal);
        const double y = t.is_double_sided && down > 0.0 ? -normal.y : normal.y;
        result.push_back({glm::dot(t.a - from, normal) / down, y, down > 0.0 && !t.is_double_sided});
    });
    std::sort(result.begin(), result.end(), [](const Hit& a, const Hit& b) { return a.share < b.share; });
    return result;
}

/// Outside of solids nearly all that is seen is seen from its front.
bool WalkOracle::is_open_place(const glm::dvec3& foot, const JudgedBody& body) const
{
    const glm::dvec3 middle = foot + glm::dvec3(0.0, 0.5 * body.height_m, 0.0);
    const double far_m = glm::length(bounds_.size()) + 1.0;
    const double clear_m = kClear_m * body.height_m / JudgedBody{}.height_m;
    int clear = 0, backs = 0;
    for (int side = 0; side < kSides; ++side) {
        const double angle = (side + 0.37) * glm::two_pi<double>() / kSides;
        const std::vector<Hit> met = hits(middle, middle + far_m * glm::dvec3(std::cos(angle), 0.01, std::sin(angle)));
        clear += met.empty() || met.front().share * far_m > clear_m;
        backs += !met.empty() && met.front().is_back;
    }
    const std::vector<Hit> above = hits(middle, middle + glm::dvec3(0.01, far_m, 0.01));
    if (!above.empty() && above.front().is_back) return false;
    return 2 * clear >= kSides && 8 * backs <= kSides;
}

std::vector<glm::dvec3> WalkOracle::standing_places(const JudgedBody& body, std::size_t count, std::uint32_t seed) const
{
    constexpr int kTriesOfPlace = 400;
    constexpr double kOver_m = 0.003;
    std::vector<glm::dvec3> places;
    if (triangles_.empty()) return places;
    std::mt19937 random(seed);
    const auto share = [&] { return random() / 4294967296.0; };
    for (std::size_t i = 0; i < count * kTriesOfPlace && places.size() < count; ++i) {
        const double x = std::lerp(bounds_.min.x, bounds_.max.x, share());
        const double z = std::lerp(bounds_.min.z, bounds_.max.z, share());
        const glm::dvec3 top(x, bounds_.max.y + 1.0, z), bottom(x, bounds_.min.y - 1.0, z);
        std::vector<Hit> floors = hits(top, bottom);
        std::erase_if(floors, [](const Hit& hit) { return hit.is_back || hit.normal_y < kLevelEnough; });
        if (floors.empty()) continue;
        const Hit& floor = floors[random() % floors.size()];
        const double slope_m = body.radius_m * (1.0 / floor.normal_y - 1.0);
        const glm::dvec3 foot = glm::mix(top, bottom, floor.share) + glm::dvec3(0.0, slope_m + kOver_m, 0.0);
        if (depth(foot, body) <= 0.0 && is_open_place(foot, body)) places.push_back(foot);
    }
    return places;
}

}  // namespace hw::measure
