#include "hatchway/geometry/surface/outline_order.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "hatchway/core/box.hpp"

namespace hw {
namespace {

constexpr std::size_t kFewFaces = 1 << 14;   // halves below are not worth a thread
constexpr std::size_t kMostAsked = 1 << 10;  // faces that tell the spread of a part well enough

/// A face as a point: its unit normal, and its centre in radii of the mesh, in steps. An eye at a few radii makes both
/// count for about the same.
struct Place {
    std::array<std::int16_t, 6> at;
    std::uint32_t face;

    /// Orders places along an axis; no two are equal.
    std::int64_t key(std::size_t axis) const { return std::int64_t{at[axis]} << 32 | face; }
};

Place place_of(std::span<const glm::vec3> positions, const std::array<std::uint32_t, 3>& corners, std::uint32_t face,
               const Box& box)
{
    constexpr double kSteps = 32767.0;
    const glm::dvec3 a = positions[corners[0]], b = positions[corners[1]], c = positions[corners[2]];
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double size = glm::length(area), radius = 0.5 * glm::length(box.size());
    const glm::dvec3 normal = size > 0.0 ? area / size : glm::dvec3(0.0);
    const glm::dvec3 centre = radius > 0.0 ? ((a + b + c) / 3.0 - box.centre()) / radius : glm::dvec3(0.0);
    Place place{{}, face};
    for (int i = 0; i < 3; ++i) {
        place.at[i] = static_cast<std::int16_t>(kSteps * normal[i]);
        place.at[3 + i] = static_cast<std::int16_t>(kSteps * centre[i]);
    }
    return place;
}

std::size_t widest_axis(std::span<const Place> places)
{
    const std::size_t stride = 1 + places.size() / kMostAsked;
    std::array<double, 6> sum{}, square{};
    double count = 0.0;
    for (std::size_t i = 0; i < places.size(); i += stride, count += 1.0) {
        for (std::size_t axis = 0; axis < 6; ++axis) {
            const double at = places[i].at[axis];
            sum[axis] += at;
            square[axis] += at * at;
        }
    }
    std::array<double, 6> variance;
    for (std::size_t axis = 0; axis < 6; ++axis)
        variance[axis] = square[axis] / count - sum[axis] / count * (sum[axis] / count);
    return static_cast<std::size_t>(std::max_element(variance.begin(), variance.end()) - variance.begin());
}

/// About the key of which a share `first` of `count` is below.
std::int64_t pivot_of(std::span<const Place> places, std::size_t first, std::size_t axis)
{
    constexpr std::size_t kAsked = 63;
    std::array<std::int64_t, kAsked> asked;
    for (std::size_t i = 0; i < kAsked; ++i) asked[i] = places[i * places.size() / kAsked].key(axis);
    const auto at = asked.begin() + static_cast<std::ptrdiff_t>(kAsked * first / places.size());
    std::nth_element(asked.begin(), at, asked.end());
    return *at;
}

/// Brings places below the pivot to the front, without a branch that depends on them, and returns how many there are.
/// `room` is as large as `places`.
std::size_t part(std::span<Place> places, std::span<Place> room, std::int64_t pivot, std::size_t axis)
{
    std::size_t below = 0, above = 0;
    for (const Place place : places) {
        const bool is_below = place.key(axis) < pivot;
        places[below] = room[above] = place;
        below += is_below;
        above += !is_below;
    }
    std::copy_n(room.begin(), above, places.begin() + static_cast<std::ptrdiff_t>(below));
    return below;
}

/// Brings the `first` places that are first along an axis to the front.
void split(std::span<Place> places, std::span<Place> room, std::size_t first, std::size_t axis)
{
    constexpr std::size_t kFew = 128;
    while (places.size() > kFew) {
        const std::size_t below = part(places, room, pivot_of(places, first, axis), axis);
        if (below == first) return;
        if (below == 0) break;  // the pivot was the first
        if (first < below) {
            places = places.first(below);
        } else {
            places = places.subspan(below);
            first -= below;
        }
    }
    std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
                     [axis](const Place& a, const Place& b) { return a.key(axis) < b.key(axis); });
}

void sort_places(std::span<Place> places, std::span<Place> room)
{
    if (places.size() <= kClusterFaces) {
        std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.face < b.face; });
        return;
    }
    std::size_t unit = kClusterFaces;
    while (unit * kGroupClusters < places.size()) unit *= kGroupClusters;
    const std::size_t units = (places.size() + unit - 1) / unit, half = (units + 1) / 2 * unit;
    split(places, room, half, widest_axis(places));
    const auto sort_first = [&] { sort_places(places.first(half), room.first(half)); };
    const auto sort_second = [&] { sort_places(places.subspan(half), room.subspan(half)); };
    if (places.size() > kFewFaces) {
        tbb::parallel_invoke(sort_first, sort_second);
    } else {
        sort_first();
        sort_second();
    }
}

}  // namespace

std::vector<std::uint32_t> outline_order(std::span<const glm::vec3> positions,
                                         std::span<const std::array<std::uint32_t, 3>> faces)
{
    Box box;
    for (const glm::vec3& p : positions) box.add(glm::dvec3(p));
    std::vector<Place> places;
    places.reserve(faces.size());
    for (std::uint32_t face = 0; face < faces.size(); ++face)
        places.push_back(place_of(positions, faces[face], face, box));
    std::vector<Place> room(places.size());
    sort_places(places, room);
    std::vector<std::uint32_t> order(faces.size());
    std::transform(places.begin(), places.end(), order.begin(), [](const Place& place) { return place.face; });
    return order;
}

}  // namespace hw
