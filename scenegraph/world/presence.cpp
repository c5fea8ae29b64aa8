#include "hatchway/world/presence.hpp"

#include <algorithm>

namespace hw {
namespace {

double smooth_ramp(double from, double to, double x)
{
    if (from == to) return x < from ? 0.0 : 1.0;
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

float presence_at(const PresenceField& field, float y_m, double t_s)
{
    double value = std::clamp(field.constant, 0.0f, 1.0f);
    if (field.has_height) value *= smooth_ramp(field.from_m, field.to_m, y_m);
    if (field.has_time) value *= smooth_ramp(field.from_s, field.to_s, t_s);
    return static_cast<float>(value);
}

}  // namespace hw
