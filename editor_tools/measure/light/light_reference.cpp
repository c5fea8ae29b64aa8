#include "measure/light/light_reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hw {
namespace {

double dot(const glm::dvec3& a, const glm::dvec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double length(const glm::dvec3& a)
{
    return std::sqrt(dot(a, a));
}

}  // namespace

double point_illuminance(double candela, const glm::dvec3& lamp, const glm::dvec3& place, const glm::dvec3& normal)
{
    const glm::dvec3 way = lamp - place;
    const double distance = length(way);
    return candela * std::max(0.0, dot(way, normal) / distance) / (distance * distance);
}

double polygon_illuminance(double luminance, std::span<const glm::dvec3> corners, const glm::dvec3& place,
                           const glm::dvec3& normal)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = corners[i] - place;
        const glm::dvec3 b = corners[(i + 1) % corners.size()] - place;
        const glm::dvec3 axis = cross(a, b);
        const double sine = length(axis);
        if (sine > 0.0) sum += std::atan2(sine, dot(a, b)) * dot(axis, normal) / sine;
    }
    return 0.5 * luminance * std::abs(sum);
}

double closed_room_illuminance(double luminance, double albedo)
{
    return std::numbers::pi * luminance / (1.0 - albedo);
}

}  // namespace hw
