// The fragment side of lines. A pen of a style's own (ProgramCache::line) includes this file, then:
//
//     void main()
//     {
//         HwLine line = hw_line();            // discards where the line is hidden
//         hw_output(line.colour, line.coverage);
//     }
//
// This is the engine's own pen, too. Defines: HW_PRESENCE, presence is not 1 everywhere; HW_STROKE, lines carry their place on
// the stroke: always for pens of styles.
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
flat in int hw_v_line_class;
flat in highp vec4 hw_v_stroke;  // length along the stroke over w, and 1 over w, at both ends
flat in highp vec4 hw_v_stroke_whole;  // x length, below zero closed, 0 a smooth silhouette; y seed; zw overshoot at both ends
flat in highp vec3 hw_v_stroke_from;   // place on the object over w
flat in highp vec3 hw_v_stroke_to;
#endif

// What a pen knows of a line at a fragment.
struct HwLine {
    float coverage;  // of the engine's pen, in [0, 1]: width, round ends, dashes, presence and thinning far away
    vec3 colour;     // of the look, linear
    float across;    // from the line's middle, in half widths: -1 and 1 at its sides, beyond them in the soft rim
    float width_px;  // of the line here, device pixels
    float presence;  // of the style here; the width has it already
#ifdef HW_STROKE
    float length_px;        // along the stroke, device pixels at this distance; 0 where there is none
    float length_object_m;  // the same on the object, metres: stays where it is when the eye moves
    float seed;             // in [0, 1), of the stroke: no two are drawn alike; 0 where there is none
    int line_class;         // 0 silhouette, 1 ridge, 2 valley, 3 border, 4 artist's, 5 intersection
    vec3 position_object;   // smooth silhouettes are other edges in every view, and no strokes: give them noise of this place
#endif
};

// Of the pixel around a place along the line, how much of its length lies between the line's ends.
float hw_length_in_pixel(float x, vec2 ends) { return clamp(min(x + 0.5, ends.y) - max(x - 0.5, ends.x), 0.0, 1.0); }

HwLine hw_line()
{
    HwLine line;
    float at = clamp(hw_v_line.x, 0.0, hw_v_line_way.x);
    vec2 off_middle = vec2(hw_v_line.x - at, hw_v_line.y);
    vec2 along = hw_v_line_way.yz;
    vec2 across = vec2(-along.y, along.x);
    vec2 middle = gl_FragCoord.xy - off_middle.x * along - off_middle.y * across;
    vec2 aside = sign(hw_v_line_depth.y) * 0.5 * across;
    bool on_both_sides = hw_v_line_depth.y > 1.5;
    if (hw_is_line_hidden(vec3(middle, hw_v_line_depth.x + hw_v_line_way.w * at), aside, on_both_sides)) discard;
    float half_width = hw_v_line.z;
    float broken = 1.0;
    vec2 ends = vec2(0.0, hw_v_line_way.x);  // of the stroke, along the line
#ifdef HW_STROKE
    float share = hw_v_line_way.x > 1e-6 ? at / hw_v_line_way.x : 0.0;
    float inverse_w = mix(hw_v_stroke.z, hw_v_stroke.w, share);
    float px_per_unit = hw_focal_px * inverse_w * hw_stroke_scale;
    float arc = 0.0;
    line.position_object = mix(hw_v_stroke_from, hw_v_stroke_to, share) / inverse_w;
    if (hw_v_stroke_whole.x == 0.0) {
        off_middle.y -= dot(hw_silhouette_stray(line.position_object, px_per_unit), across);
    } else {
        arc = mix(hw_v_stroke.x, hw_v_stroke.y, share) / inverse_w;
        float forward = hw_v_stroke.y * hw_v_stroke.z >= hw_v_stroke.x * hw_v_stroke.w ? 1.0 : -1.0;
        off_middle.y -= forward * hw_stroke_stray(arc, hw_v_stroke_whole.y, px_per_unit);
        ends += vec2(-hw_v_stroke_whole.z, hw_v_stroke_whole.w);
        off_middle.x = hw_v_line.x - clamp(hw_v_line.x, ends.x, ends.y);
        half_width *= hw_stroke_taper(arc, hw_v_stroke_whole.x, px_per_unit);
        if (hw_stroke_dash.x > 0.0) broken = hw_stroke_dash_at(arc, hw_v_stroke_whole.y, px_per_unit);
    }
    line.length_px = arc * px_per_unit;
    line.length_object_m = arc * hw_stroke_scale;
    line.seed = hw_v_stroke_whole.y;
    line.line_class = hw_v_line_class;
#endif
    line.presence = 1.0;
#ifdef HW_PRESENCE
    float height_m = hw_v_line_height.x / hw_v_line_height.y;
    line.presence = hw_presence_at(height_m) * hw_share_at(hw_line_share, height_m);
    half_width *= line.presence;
#endif
    // Thinner than a pixel a line becomes lighter instead.
    float drawn = max(half_width, 0.5);
    // The round ends lack the soft rim: where lines join, rims would lie upon each other and darken.
    float rim = off_middle.x == 0.0 ? 0.5 : 0.0;
    float round_pen = clamp(rim + drawn - length(off_middle), 0.0, 1.0);
    // Light lines would darken wherever their ends lie on each other, and far away they are nothing but ends: such a line
    // leaves in each pixel what it has of length there, so that pieces of a line add up to the line.
    float hair = clamp(0.5 + drawn - abs(off_middle.y), 0.0, 1.0) * hw_length_in_pixel(hw_v_line.x, ends);
    line.coverage = mix(hair, round_pen, smoothstep(0.35, 0.5, half_width)) * min(2.0 * half_width, 1.0) * broken;
    if (line.coverage <= 0.0) discard;
    line.colour = hw_v_line_colour;
    line.across = off_middle.y / drawn;
    line.width_px = 2.0 * half_width;
    return line;
}

// The colour of this fragment, linear, laid over the picture with that coverage.
void hw_output(vec3 colour_linear, float coverage) { hw_fragment = vec4(colour_linear, coverage); }
