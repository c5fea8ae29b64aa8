#pragma once

#include <optional>

namespace hw {

/// A share that rises smoothly from 0 at `from` to 1 at `to`, which may be the lower one; equal ends make a step. Over
/// a height in the world, in metres, or over time, in seconds.
struct Ramp {
    float from = 0.0f;
    float to = 1.0f;

    bool operator==(const Ramp&) const = default;
};

/// The ramp's share at `x`.
double share_at(const Ramp& ramp, double x);

/// How much of something shows, at each place and time: a field with values in [0, 1].
/// value(p, t) = clamp(constant, 0, 1) * ramp over world height * ramp over time.
/// A style and its counterpart show presence and 1 - presence of the same field.
struct PresenceField {
    float constant = 1.0f;
    std::optional<Ramp> height = {};  ///< Over world height y.
    std::optional<Ramp> time = {};    ///< Over the time of the view.

    bool operator==(const PresenceField&) const = default;
};

/// The field at height `y_m` and time `t_s`.
float presence_at(const PresenceField& field, float y_m, double t_s);

/// Whether the field has other values at a time after `t_s`.
bool changes_after(const PresenceField& field, double t_s);

}  // namespace hw
