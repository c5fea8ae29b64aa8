#include "hatchway/drawing/line_width.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "hatchway/geometry/lines/line_crowding.hpp"

namespace hw {
namespace {

constexpr float kInsideFrom = 0.2f;  // sine of the angle from which on a face is seen for good
constexpr double kFlattest = 0.25;   // share of its width that the flattest crease keeps where folds count whole
constexpr double kWholeFold = 0.5 * std::numbers::pi;

double far_share(const FarPolicy& far, const PenPlace& place)
{
    if (!far.is_on) return 1.0;
    const double window_px = far.full_spacing_px / kFullSpacingInWindows;
    const double windows = window_px / (static_cast<double>(place.px_per_m) * place.window_m);
    const double share = crowded_share(place.crowding, static_cast<float>(windows));
    if (is_contour(place.line_class)) return share;
    const double gone = FarPolicy::kInnerGone;
    const double inside = std::clamp((share - gone) / (1.0 - gone), 0.0, 1.0);
    return glm::mix(share, inside, static_cast<double>(place.inside));
}

}  // namespace

float insideness(const glm::vec3& normal_a, const glm::vec3& normal_b, const glm::vec3& to_eye)
{
    const float a = glm::dot(normal_a, to_eye), b = glm::dot(normal_b, to_eye);
    const float facing = a * b > 0.0f ? std::min(std::abs(a), std::abs(b)) : 0.0f;
    const float t = std::clamp(facing / std::max(glm::length(to_eye), 1e-20f) / kInsideFrom, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

double line_width_px(const LineLook& look, float crease_rad, const PenPlace& place)
{
    const Pen& pen = look[place.line_class];
    if (!pen.is_drawn) return 0.0;
    double width = std::max(pen.width_px, 0.0f);
    if (is_crease(place.line_class)) {
        const double span = std::max(kWholeFold - crease_rad, 1e-6);
        const double fold = std::clamp((static_cast<double>(place.fold_rad) - crease_rad) / span, 0.0, 1.0);
        width *= glm::mix(1.0, glm::mix(kFlattest, 1.0, fold), static_cast<double>(look.fold_weight));
    }
    if (look.depth_taper > 0.0f && place.distance_m > look.taper_from_m)
        width *= glm::mix(1.0, static_cast<double>(look.taper_from_m) / place.distance_m,
                          static_cast<double>(look.depth_taper));
    return width * far_share(look.far, place);
}

}  // namespace hw
