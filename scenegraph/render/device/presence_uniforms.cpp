#include "hatchway/render/device/presence_uniforms.hpp"

#include <glm/vec4.hpp>

#include "hatchway/gl/gpu_program.hpp"

namespace hw {
namespace {

/// The part of the field that does not depend on the place.
float constant_at(const PresenceField& field, double time_s)
{
    PresenceField without_height = field;
    without_height.has_height = false;
    return presence_at(without_height, 0.0f, time_s);
}

}  // namespace

bool has_presence(const DrawItem& item)
{
    const PresenceField& field = item.presence;
    return item.is_presence_inverted || field.has_height || field.has_time || field.constant < 1.0f;
}

bool shows_at_all(const DrawItem& item, double time_s)
{
    const float constant = constant_at(item.presence, time_s);
    if (item.is_presence_inverted) return item.presence.has_height || constant < 1.0f;
    return constant > 0.0f;
}

void set_presence(int height_location, int inverted_location, const DrawItem& item, double time_s)
{
    const PresenceField& field = item.presence;
    GpuProgram::set(height_location,
                    glm::vec4(constant_at(field, time_s), field.from_m, field.to_m, field.has_height ? 1.0f : 0.0f));
    GpuProgram::set(inverted_location, item.is_presence_inverted ? 1.0f : 0.0f);
}

}  // namespace hw
