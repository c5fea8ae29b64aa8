#include "frame.glsl"
#include "presence.glsl"
#include "line_visibility.glsl"

layout(location = 0) out vec4 hw_fragment;
in vec3 hw_v_line;
in vec2 hw_v_line_height;
flat in vec4 hw_v_line_way;
flat in highp vec2 hw_v_line_depth;
flat in vec3 hw_v_line_colour;

void main()
{
    float at = clamp(hw_v_line.x, 0.0, hw_v_line_way.x);
    vec2 off_middle = vec2(hw_v_line.x - at, hw_v_line.y);
    vec2 along = hw_v_line_way.yz;
    vec2 across = vec2(-along.y, along.x);
    vec2 middle = gl_FragCoord.xy - off_middle.x * along - off_middle.y * across;
    if (hw_is_line_hidden(vec3(middle, hw_v_line_depth.x + hw_v_line_way.w * at), hw_v_line_depth.y * 0.5 * across)) discard;
    float distance_px = length(off_middle);
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
