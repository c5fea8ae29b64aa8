#include "frame.glsl"
#include "presence.glsl"
#include "lines/line_visibility.glsl"

layout(location = 0) out vec4 hw_fragment;
in float hw_v_height;
in float hw_v_share;
in highp vec4 hw_v_middle;
flat in vec2 hw_v_aside;
flat in vec4 hw_v_line_colour;
uniform vec4 hw_line_share;  // of the style's own: see hw_share_at()

void main()
{
    vec3 middle = 0.5 + 0.5 * hw_v_middle.xyz / hw_v_middle.w;
    if (hw_is_line_hidden(vec3(middle.xy * hw_size_px, middle.z), hw_v_aside, true)) discard;
    float coverage = hw_v_share;
#ifdef HW_PRESENCE
    coverage *= hw_presence_at(hw_v_height) * hw_share_at(hw_line_share, hw_v_height);
#endif
#ifdef HW_ROUND_POINT
    float distance_px = length(gl_PointCoord - 0.5) * (hw_v_line_colour.w + 1.0);
    coverage *= clamp(0.5 + 0.5 * hw_v_line_colour.w - distance_px, 0.0, 1.0);
    coverage *= smoothstep(0.7, 1.0, hw_v_share);  // on light lines ends would be dark dots
#endif
    if (coverage <= 0.0) discard;
    hw_fragment = vec4(hw_v_line_colour.rgb, coverage);
}
