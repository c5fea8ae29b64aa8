// What both ways of drawing lines share: class, width and share of ink. Included by line_quad.vert and line_end.vert.
#include "frame.glsl"
#include "lines/line_width.glsl"
#include "position.glsl"
#include "presence.glsl"

in vec3 hw_in_position;
in vec4 hw_in_line_other;     // xyz the other end, w class, 8 more where the faces beside the line are culled
in vec3 hw_in_line_normal_a;  // of the faces beside the line; zero: not known
in vec3 hw_in_line_normal_b;
in float hw_in_line_fold;     // at the line, radians
in vec4 hw_in_line_crowding;  // how crowded lines are here: LineCrowding

uniform mat4 hw_relative_from_object;
uniform vec4 hw_line_eye_object;    // w 0: the direction to the viewer of a parallel projection
uniform vec3 hw_line_colour[6];     // linear

// From the middle of the line, which stands for it, so that both ends agree.
vec3 hw_line_to_eye() 
{
    return hw_line_eye_object.xyz - 0.5 * hw_line_eye_object.w * (hw_in_position + hw_in_line_other.xyz);
}

// The class in this view. An edge whose faces disagree about the eye is a silhouette, however folded; what only folds, or is
// the artist's, is so where both are seen.
int hw_line_class()
{
    int line_class = int(hw_in_line_other.w + 0.5) & 7;
    if (line_class == 0 || line_class == 3 || line_class == 5) return line_class;
    vec3 to_eye = hw_line_to_eye();
    return dot(hw_in_line_normal_a, to_eye) * dot(hw_in_line_normal_b, to_eye) < 0.0 ? 0 : line_class;
}

// On which side of a contour the surface is not: 1 where `across` points, -1 on the other, 2 not known. Of a fold the
// normals point there, those of a valley away from there. `own`: this end, clip space; `across`: pixels.
float hw_line_beyond(vec4 own, vec2 across)
{
    int folded = int(hw_in_line_other.w + 0.5) & 7;
    if (folded != 1 && folded != 2) return 2.0;
    vec4 way = hw_clip_from_object * vec4(hw_in_line_normal_a + hw_in_line_normal_b, 0.0);
    float side = dot((way.xy * own.w - own.xy * way.w) * hw_size_px, across);
    return (side < 0.0) == (folded == 1) ? -1.0 : 1.0;
}

// Whether all faces beside the line look away and are not drawn; of those that meet one is enough. Near ties are drawn.
bool hw_line_is_culled()
{
    if (hw_in_line_other.w < 7.5) return false;
    vec3 to_eye = hw_line_to_eye();
    float tie = -1e-4 * length(to_eye);
    bool a = dot(hw_in_line_normal_a, to_eye) < tie, b = dot(hw_in_line_normal_b, to_eye) < tie;
    return (int(hw_in_line_other.w + 0.5) & 7) == 5 ? a || b : a && b;
}

// Width in pixels at this end of the line.
float hw_line_width_at(int line_class, vec3 relative)
{
    // In a parallel projection nothing is far away.
    float distance_m = hw_is_parallel ? 0.0 : length(relative);
    float px_per_m = hw_is_parallel ? hw_focal_px : hw_focal_px / max(distance_m, 1e-20);
    float inside = line_class == 5 ? 0.0 : hw_line_insideness(hw_in_line_normal_a, hw_in_line_normal_b, hw_line_to_eye());
    return hw_line_width(line_class, hw_in_line_fold, distance_m, px_per_m, hw_in_line_crowding, inside);
}
