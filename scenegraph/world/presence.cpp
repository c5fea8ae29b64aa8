#include "hatchway/world/presence.hpp"

#include <algorithm>

namespace hw {

double share_at(const Ramp& ramp, double x)
{
    const double from = ramp.from, to = ramp.to;
    if (from == to) return x < from ? 0.0 : 1.0;
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

float presence_at(const PresenceField& field, float y_m, double t_s)
{
    double value = std::clamp(field.constant, 0.0f, 1.0f);
    if (field.height) value *= share_at(*field.height, y_m);
    if (field.time) value *= share_at(*field.time, t_s);
    return static_cast<float>(value);
}

bool changes_after(const PresenceField& field, double t_s)
{
    return field.constant > 0.0f && field.time && t_s < std::max(field.time->from, field.time->to);
}

}  // namespace hw
