#include "hatchway/render/device/presence_uniforms.hpp"

#include "hatchway/gl/gpu_program.hpp"

namespace hw {
namespace {

/// The part of the field that does not depend on the place.
float constant_at(const PresenceField& field, double time_s)
{
    PresenceField without_height = field;
    without_height.height.reset();
    return presence_at(without_height, 0.0f, time_s);
}

}  // namespace

bool varies(const PresenceField& field)
{
    return field.height || field.time || field.constant < 1.0f;
}

glm::vec4 share_uniform(const PresenceField& field, double time_s)
{
    const Ramp ramp = field.height.value_or(Ramp());
    return {constant_at(field, time_s), ramp.from, ramp.to, field.height ? 1.0f : 0.0f};
}

bool has_presence(const DrawItem& item)
{
    return FrameItems::is_presence_inverted(item) || varies(FrameItems::presence(item));
}

bool shows_at_all(const DrawItem& item, double time_s)
{
    const PresenceField& field = FrameItems::presence(item);
    const float constant = constant_at(field, time_s);
    if (FrameItems::is_presence_inverted(item)) return field.height || constant < 1.0f;
    return constant > 0.0f;
}

void set_presence(int height_location, int inverted_location, const DrawItem& item, double time_s)
{
    GpuProgram::set(height_location, share_uniform(FrameItems::presence(item), time_s));
    GpuProgram::set(inverted_location, FrameItems::is_presence_inverted(item) ? 1.0f : 0.0f);
}

}  // namespace hw
