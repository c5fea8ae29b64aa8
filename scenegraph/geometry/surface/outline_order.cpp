#include "hatchway/geometry/surface/outline_order.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "hatchway/core/box.hpp"

namespace hw {
namespace {

constexpr std::size_t kFewFaces = 1 << 14;  // halves below are not worth a thread

/// A face as a point: its unit normal, and its centre in radii of the mesh. An eye at a few radii makes both count for
/// about the same.
struct Place {
    std::array<float, 6> at;
    std::uint32_t face;
};

Place place_of(std::span<const glm::vec3> positions, const std::array<std::uint32_t, 3>& corners, std::uint32_t face,
               const Box& box)
{
    const glm::dvec3 a = positions[corners[0]], b = positions[corners[1]], c = positions[corners[2]];
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double size = glm::length(area), radius = 0.5 * glm::length(box.size());
    const glm::dvec3 normal = size > 0.0 ? area / size : glm::dvec3(0.0);
    const glm::dvec3 centre = radius > 0.0 ? ((a + b + c) / 3.0 - box.centre()) / radius : glm::dvec3(0.0);
    Place place{{}, face};
    for (int i = 0; i < 3; ++i) {
        place.at[i] = static_cast<float>(normal[i]);
        place.at[3 + i] = static_cast<float>(centre[i]);
    }
    return place;
}

std::size_t widest_axis(std::span<const Place> places)
{
    std::array<double, 6> sum{}, square{};
    for (const Place& place : places) {
        for (std::size_t i = 0; i < 6; ++i) {
            sum[i] += place.at[i];
            square[i] += static_cast<double>(place.at[i]) * place.at[i];
        }
    }
    std::array<double, 6> variance;
    const auto count = static_cast<double>(places.size());
    for (std::size_t i = 0; i < 6; ++i) variance[i] = square[i] / count - sum[i] / count * (sum[i] / count);
    return static_cast<std::size_t>(std::max_element(variance.begin(), variance.end()) - variance.begin());
}

void sort_places(std::span<Place> places)
{
    if (places.size() <= kClusterFaces) {
        std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.face < b.face; });
        return;
    }
    std::size_t unit = kClusterFaces;
    while (unit * kGroupClusters < places.size()) unit *= kGroupClusters;
    const std::size_t units = (places.size() + unit - 1) / unit, half = (units + 1) / 2 * unit;
    const std::size_t axis = widest_axis(places);
    std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(half), places.end(),
                     [axis](const Place& a, const Place& b) {
                         return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.face < b.face;
                     });
    const auto sort_first = [&] { sort_places(places.first(half)); };
    const auto sort_second = [&] { sort_places(places.subspan(half)); };
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
    sort_places(places);
    std::vector<std::uint32_t> order(faces.size());
    std::transform(places.begin(), places.end(), order.begin(), [](const Place& place) { return place.face; });
    return order;
}

}  // namespace hw
