#include "frame.glsl"
#include "presence.glsl"

layout(location = 0) out vec4 hw_fragment;
in vec3 hw_v_line;
in vec2 hw_v_line_height;
flat in float hw_v_line_length;
flat in vec3 hw_v_line_colour;

void main()
{
    float beyond = max(max(-hw_v_line.x, hw_v_line.x - hw_v_line_length), 0.0);
    float distance_px = length(vec2(beyond, hw_v_line.y));
    float half_width = hw_v_line.z;
#ifdef HW_PRESENCE
    half_width *= hw_presence_at(hw_v_line_height.x / hw_v_line_height.y);
#endif
    // Thinner than a pixel a line becomes lighter instead.
    float drawn = max(half_width, 0.5);
    float coverage = clamp(0.5 + drawn - distance_px, 0.0, 1.0) * min(2.0 * half_width, 1.0);
    if (coverage <= 0.0) discard;
    hw_fragment = vec4(hw_v_line_colour, coverage);
}
