#include "frame.glsl"
#include "presence.glsl"
#include "lines/line_visibility.glsl"
#ifdef HW_STROKE
#include "lines/line_stroke.glsl"
#endif

layout(location = 0) out vec4 hw_fragment;
in vec3 hw_v_line;
in vec2 hw_v_line_height;
flat in vec4 hw_v_line_way;
flat in highp vec2 hw_v_line_depth;
flat in vec3 hw_v_line_colour;
uniform vec4 hw_line_share;  // of the style's own: see hw_share_at()
#ifdef HW_STROKE
flat in highp vec4 hw_v_stroke;  // length along the stroke over w, and 1 over w, at both ends
flat in highp vec4 hw_v_stroke_whole;  // x length, below zero closed, 0 a silhouette; y seed; zw overshoot at both ends
flat in highp vec3 hw_v_stroke_from;   // place on the object over w
flat in highp vec3 hw_v_stroke_to;
#endif

// Of the pixel around a place along the line, how much of its length lies between the line's ends.
float hw_length_in_pixel(float x, vec2 ends) { return clamp(min(x + 0.5, ends.y) - max(x - 0.5, ends.x), 0.0, 1.0); }

void main()
{
    float at = clamp(hw_v_line.x, 0.0, hw_v_line_way.x);
    vec2 off_middle = vec2(hw_v_line.x - at, hw_v_line.y);
    vec2 along = hw_v_line_way.yz;
    vec2 across = vec2(-along.y, along.x);
    vec2 middle = gl_FragCoord.xy - off_middle.x * along - off_middle.y * across;
    if (hw_is_line_hidden(vec3(middle, hw_v_line_depth.x + hw_v_line_way.w * at), hw_v_line_depth.y * 0.5 * across)) discard;
    float half_width = hw_v_line.z;
    float broken = 1.0;
    vec2 ends = vec2(0.0, hw_v_line_way.x);  // of the stroke, along the line
#ifdef HW_STROKE
    float share = hw_v_line_way.x > 1e-6 ? at / hw_v_line_way.x : 0.0;
    float inverse_w = mix(hw_v_stroke.z, hw_v_stroke.w, share);
    float px_per_unit = hw_focal_px * inverse_w * hw_stroke_scale;
    if (hw_v_stroke_whole.x == 0.0) {
        vec3 place = mix(hw_v_stroke_from, hw_v_stroke_to, share) / inverse_w;
        off_middle.y -= dot(hw_silhouette_stray(place, px_per_unit), across);
    } else {
        float arc = mix(hw_v_stroke.x, hw_v_stroke.y, share) / inverse_w;
        float forward = hw_v_stroke.y * hw_v_stroke.z >= hw_v_stroke.x * hw_v_stroke.w ? 1.0 : -1.0;
        off_middle.y -= forward * hw_stroke_stray(arc, hw_v_stroke_whole.y, px_per_unit);
        ends += vec2(-hw_v_stroke_whole.z, hw_v_stroke_whole.w);
        off_middle.x = hw_v_line.x - clamp(hw_v_line.x, ends.x, ends.y);
        half_width *= hw_stroke_taper(arc, hw_v_stroke_whole.x, px_per_unit);
        if (hw_stroke_dash.x > 0.0) broken = hw_stroke_dash_at(arc, hw_v_stroke_whole.y, px_per_unit);
    }
#endif
#ifdef HW_PRESENCE
    float height_m = hw_v_line_height.x / hw_v_line_height.y;
    half_width *= hw_presence_at(height_m) * hw_share_at(hw_line_share, height_m);
#endif
    // Thinner than a pixel a line becomes lighter instead.
    float drawn = max(half_width, 0.5);
    // The round ends lack the soft rim: where lines join, rims would lie upon each other and darken.
    float rim = off_middle.x == 0.0 ? 0.5 : 0.0;
    float round_pen = clamp(rim + drawn - length(off_middle), 0.0, 1.0);
    // Light lines would darken wherever their ends lie on each other, and far away they are nothing but ends: such a line
    // leaves in each pixel what it has of length there, so that pieces of a line add up to the line.
    float hair = clamp(0.5 + drawn - abs(off_middle.y), 0.0, 1.0) * hw_length_in_pixel(hw_v_line.x, ends);
    float coverage = mix(hair, round_pen, smoothstep(0.35, 0.5, half_width)) * min(2.0 * half_width, 1.0) * broken;
    if (coverage <= 0.0) discard;
    hw_fragment = vec4(hw_v_line_colour, coverage);
}
