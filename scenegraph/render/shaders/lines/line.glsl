// What both ways of drawing lines share: class, width and share of ink. Included by line_quad.vert and line_end.vert.
#include "frame.glsl"
#include "lines/line_width.glsl"
#include "position.glsl"
#include "presence.glsl"

in vec3 hw_in_position;
in vec4 hw_in_line_other;     // xyz the other end, w class
in vec3 hw_in_line_normal_a;  // of the faces beside the line; zero: drawn whatever they do
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

// Whether all faces beside the line look away and are not drawn. Near ties are drawn.
bool hw_line_is_culled()
{
    vec3 to_eye = hw_line_to_eye();
    float tie = -1e-4 * length(to_eye);
    return dot(hw_in_line_normal_a, to_eye) < tie && dot(hw_in_line_normal_b, to_eye) < tie;
}

// Width in pixels at this end of the line.
float hw_line_width_at(int line_class, vec3 relative)
{
    // In a parallel projection nothing is far away.
    float distance_m = hw_is_parallel ? 0.0 : length(relative);
    float px_per_m = hw_is_parallel ? hw_focal_px : hw_focal_px / max(distance_m, 1e-20);
    float inside = hw_line_insideness(hw_in_line_normal_a, hw_in_line_normal_b, hw_line_to_eye());
    return hw_line_width(line_class, hw_in_line_fold, distance_m, px_per_m, hw_in_line_crowding, inside);
}
