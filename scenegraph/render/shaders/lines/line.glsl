// What both ways of drawing lines share: class, width and share of ink. Included by line_quad.vert and line_end.vert.
#include "frame.glsl"
#include "position.glsl"
#include "presence.glsl"

in vec3 hw_in_position;
in vec4 hw_in_line_other;     // xyz the other end, w class
in vec3 hw_in_line_normal_a;  // of the faces beside the line; zero: drawn whatever they do
in vec3 hw_in_line_normal_b;
in float hw_in_line_fold;     // at the line, radians
in vec4 hw_in_line_crowding;  // how crowded lines are here: LineCrowding

uniform mat4 hw_relative_from_object;
uniform vec3 hw_line_eye_object;
uniform float hw_line_width_px[6];  // device pixels, by class
uniform vec3 hw_line_colour[6];     // linear
// x width in pixels of the window that holds as many lines as are drawn in full, 0: lines never fade; y smallest window of the crowding,
// metres; z share of the width at which lines inside of an object are gone
uniform vec3 hw_line_fade;
uniform vec3 hw_line_fold;          // x how much lesser folds thin creases, y the least fold, z from which on they are whole
uniform vec2 hw_line_taper;         // x strength, y from metres

// Whether all faces beside the line look away and are not drawn. The middle of the line stands for it, so that both ends
// agree; near ties are drawn.
bool hw_line_is_culled()
{
    vec3 to_eye = hw_line_eye_object - 0.5 * (hw_in_position + hw_in_line_other.xyz);
    float tie = -1e-4 * length(to_eye);
    return dot(hw_in_line_normal_a, to_eye) < tie && dot(hw_in_line_normal_b, to_eye) < tie;
}

// Silhouettes and borders: the surface ends or turns away there.
float hw_line_is_contour(int line_class) { return line_class == 0 || line_class == 3 ? 1.0 : 0.0; }

// The share of its width that a line keeps among others: crowded_share() of geometry/line_crowding.hpp.
float hw_crowded_share(float windows)
{
    float scale = 0.5 * log2(max(windows, 1e-20));
    int upper = clamp(int(ceil(scale)), 0, 3);
    float least = upper > 0 ? hw_in_line_crowding[upper - 1] : 0.0;
    float slope = upper > 0 ? max(hw_in_line_crowding[upper] - least, 2.0) : 2.0;
    return exp2(-max(least, hw_in_line_crowding[upper] + slope * (scale - float(upper))));
}

// 1 where both faces beside the line look at the eye: it is drawn inside of the object. 0 where it is an outline now, or
// faces are not known. A line that turns from the one to the other does so over some degrees.
float hw_line_is_inside()
{
    vec3 to_eye = hw_line_eye_object - 0.5 * (hw_in_position + hw_in_line_other.xyz);
    float facing = min(dot(hw_in_line_normal_a, to_eye), dot(hw_in_line_normal_b, to_eye)) / max(length(to_eye), 1e-20);
    return smoothstep(0.0, 0.2, facing);
}

// Far away, all lines in a window get as much ink as the most that are drawn in full; those inside of an object go first.
float hw_far_share(int line_class, float distance_m)
{
    if (hw_line_fade.x <= 0.0) return 1.0;
    float px_per_m = hw_exposure_near_far.w > 0.5 ? hw_focal_px : hw_focal_px / max(distance_m, 1e-20);
    float share = hw_crowded_share(hw_line_fade.x / (px_per_m * hw_line_fade.y));
    if (hw_line_is_contour(line_class) > 0.5) return share;
    float inside = clamp((share - hw_line_fade.z) / (1.0 - hw_line_fade.z), 0.0, 1.0);
    return mix(share, inside, hw_line_is_inside());
}

// Width in pixels at a point of the line: the presence and the far policy thin lines before they fade, so that the round
// ends of neighbours never show as dots.
float hw_line_width_at(int line_class, vec3 relative)
{
    float distance_m = length(relative);
    float width = hw_line_width_px[line_class];
    if (line_class == 1 || line_class == 2) {
        float fold = clamp((hw_in_line_fold - hw_line_fold.y) / max(hw_line_fold.z - hw_line_fold.y, 1e-6), 0.0, 1.0);
        width *= mix(1.0, mix(0.25, 1.0, fold), hw_line_fold.x);
    }
    if (hw_line_taper.x > 0.0 && distance_m > hw_line_taper.y)
        width *= mix(1.0, hw_line_taper.y / distance_m, hw_line_taper.x);
    width *= hw_far_share(line_class, distance_m);
    return width;
}
