#include "measure/light/light_error.hpp"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <set>

#include "measure/hatching/hatch_profile.hpp"

namespace hw {
namespace {

constexpr double kPointsPerM2 = 400.0;
constexpr double kLeakPointsPerM2 = 4000.0;
constexpr float kLeastShare = 1e-4f;  // of a luxel in a point's blend
constexpr double kLeakLux = 1e-3;
constexpr double kAboveM = 1e-3;  // where the eye would be, above the surface

double gray(const glm::vec3& lux)
{
    return (static_cast<double>(lux.r) + lux.g + lux.b) / 3.0;
}

LightError error_over(const std::vector<ComparedPoint>& points,
                      const std::function<double(const ComparedPoint&)>& found,
                      const std::function<double(const ComparedPoint&)>& reference)
{
    std::vector<double> local;
    double squares = 0.0, worst = 0.0, sum = 0.0, differences = 0.0, count = 0.0;
    for (const ComparedPoint& point : points) {
        const double wanted = reference(point);
        if (!std::isfinite(wanted)) continue;
        const double difference = found(point) - wanted;
        squares += difference * difference;
        worst = std::max(worst, std::abs(difference));
        sum += wanted;
        differences += difference;
        count += 1.0;
        if (wanted > 0.0) local.push_back(std::abs(difference) / wanted);
    }
    const double mean = sum / count;
    return {.rms = std::sqrt(squares / count) / mean,
            .worst = worst / mean,
            .local_p95 = absolute_quantile(local, 0.95),
            .bias = differences / sum};
}

}  // namespace

std::vector<ComparedPoint> compared_points(const Scene& scene, ObjectId object, double per_m2)
{
    std::vector<ComparedPoint> points;
    const MeshData& mesh = scene.meshes[scene.objects[object].mesh];
    const glm::dmat4& matrix = scene.world_from_object(object);
    for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        glm::dvec3 corner[3];
        for (int k = 0; k < 3; ++k)
            corner[k] = glm::dvec3(matrix * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[t * 3 + k]]), 1.0));
        const glm::dvec3 cross = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const int count = static_cast<int>(std::ceil(0.5 * glm::length(cross) * per_m2));
        for (int i = 0; i < count; ++i) {
            // A Kronecker sequence over the triangle; the fractions are powers of the inverse plastic number.
            const double a = std::sqrt(std::fmod(0.5 + 0.7548776662466927 * i, 1.0));
            const double b = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
            const glm::dvec3 weights(1.0 - a, a * (1.0 - b), a * b);
            points.push_back({{object, t, glm::vec3(weights)},
                              weights.x * corner[0] + weights.y * corner[1] + weights.z * corner[2],
                              glm::normalize(cross)});
        }
    }
    return points;
}

LightError light_error(const Lightmap& lightmap, const LightCase& light_case)
{
    return error_over(
        compared_points(light_case.scene, light_case.measured, kPointsPerM2),
        [&](const ComparedPoint& p) { return gray(baked_illuminance(lightmap, light_case.scene, p.point)); },
        [&](const ComparedPoint& p) { return light_case.reference(p.place_world, p.normal_world); });
}

LightError light_difference(const Lightmap& lightmap, const Lightmap& reference, const LightCase& light_case)
{
    return error_over(
        compared_points(light_case.scene, light_case.measured, kPointsPerM2),
        [&](const ComparedPoint& p) { return gray(baked_illuminance(lightmap, light_case.scene, p.point)); },
        [&](const ComparedPoint& p) { return gray(baked_illuminance(reference, light_case.scene, p.point)); });
}

LeakCount count_leaks(const Lightmap& lightmap, const DarkRoom& room)
{
    std::set<std::uint32_t> seen;
    for (ObjectId id = 0; id < room.scene.objects.size(); ++id)
        for (const ComparedPoint& p : compared_points(room.scene, id, kLeakPointsPerM2)) {
            const glm::dvec3 above(room.room_from_world * glm::dvec4(p.place_world + kAboveM * p.normal_world, 1.0));
            const bool is_inside = above.x > room.inside.min.x && above.y > room.inside.min.y &&
                                   above.z > room.inside.min.z && above.x < room.inside.max.x &&
                                   above.y < room.inside.max.y && above.z < room.inside.max.z;
            if (!is_inside) continue;
            for (const BlendedLuxel& blended : blended_luxels(lightmap, room.scene, p.point))
                if (blended.share > kLeastShare) seen.insert(blended.luxel);
        }
    LeakCount count{.seen = seen.size()};
    for (const std::uint32_t luxel : seen) {
        const double lux = gray(luxel_illuminance(lightmap, luxel));
        if (lux > kLeakLux) ++count.leaked;
        count.brightest_lux = std::max(count.brightest_lux, lux);
    }
    return count;
}

}  // namespace hw
