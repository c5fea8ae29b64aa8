#pragma once

#include "hatchway/world/light/lightmap.hpp"
#include "measure/light/light_scenes.hpp"

namespace hw {

/// Baked light against a reference, at points spread over the drawn surface, as a renderer would show it.
struct LightError {
    double rms = 0.0;        ///< Of the differences, as a share of the reference's mean.
    double worst = 0.0;      ///< The largest difference, as a share of the same.
    double local_p95 = 0.0;  ///< 95th percentile of the differences, each as a share of the reference at its place.
    double bias = 0.0;       ///< The mean of the differences, below 0 where too dark, as a share of the mean.
};

/// A place of the surface with its light.
struct ComparedPoint {
    SurfacePoint point;
    glm::dvec3 place_world{0.0};
    glm::dvec3 normal_world{0.0};
};

/// Points evenly spread over the fronts of an object's triangles, always the same; about `per_m2` on a square metre.
std::vector<ComparedPoint> compared_points(const Scene& scene, ObjectId object, double per_m2);

LightError light_error(const Lightmap& lightmap, const LightCase& light_case);
/// Against another bake of the same layout.
LightError light_difference(const Lightmap& lightmap, const Lightmap& reference, const LightCase& light_case);

/// Luxels of which a picture from inside the room shows anything, and those of them that are not dark.
struct LeakCount {
    std::uint64_t seen = 0;
    std::uint64_t leaked = 0;  ///< Over a thousandth of a lux; outside there are hundred thousand.
    double brightest_lux = 0.0;
};
LeakCount count_leaks(const Lightmap& lightmap, const DarkRoom& room);

}  // namespace hw
