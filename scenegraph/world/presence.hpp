#pragma once

namespace hw {

/// How much of a style an object shows, at each place and time: a field with values in [0, 1].
/// value(p, t) = clamp(constant, 0, 1) * ramp over world height * ramp over time.
/// A style and its counterpart show presence and 1 - presence of the same field.
struct PresenceField {
    float constant = 1.0f;
    bool has_height = false;
    float from_m = 0.0f;  ///< World height y where the field is 0.
    float to_m = 1.0f;    ///< World height y where it is `constant`; below `from_m` for a field that falls upward.
    bool has_time = false;
    float from_s = 0.0f;  ///< Time of the view where the field starts to rise.
    float to_s = 1.0f;    ///< Time where it has risen.

    bool operator==(const PresenceField&) const = default;
};

/// The field at height `y_m` and time `t_s`. Ramps are smoothsteps; equal ends make a step.
float presence_at(const PresenceField& field, float y_m, double t_s);

}  // namespace hw
