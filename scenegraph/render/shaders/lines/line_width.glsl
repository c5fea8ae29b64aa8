// How wide a line is at a place of it: by class, fold, distance and crowding. Includes nothing and reads nothing but these
// uniforms and arguments; drawing/line_width.cpp computes the same for vectors, and a test compares them.

uniform float hw_line_width_px[6];  // device pixels, by class
uniform vec2 hw_line_taper;         // x strength, y from metres
uniform vec3 hw_line_fold;          // x how much lesser folds thin creases, y the least fold, z from which on they are whole
// x width in pixels of the window that holds as many lines as are drawn in full, 0: lines never fade; y smallest window of the crowding,
// metres; z share of the width at which lines inside of an object are gone
uniform vec3 hw_line_fade;

// Silhouettes and borders: the surface ends or turns away there.
float hw_line_is_contour(int line_class) { return line_class == 0 || line_class == 3 ? 1.0 : 0.0; }

// The share of its width that a line keeps among others: crowded_share() of geometry/lines/line_crowding.hpp.
float hw_crowded_share(vec4 crowding, float windows)
{
    float scale = 0.5 * log2(max(windows, 1e-20));
    int upper = clamp(int(ceil(scale)), 0, 3);
    float least = upper > 0 ? crowding[upper - 1] : 0.0;
    float slope = upper > 0 ? max(crowding[upper] - least, 2.0) : 2.0;
    return exp2(-max(least, crowding[upper] + slope * (scale - float(upper))));
}

// 1 where both faces beside the line show the same side: it is drawn inside of the object. 0 where it is an outline now, or
// faces are not known. A line that turns from the one to the other does so over some degrees.
float hw_line_insideness(vec3 normal_a, vec3 normal_b, vec3 to_eye)
{
    float a = dot(normal_a, to_eye), b = dot(normal_b, to_eye);
    float facing = a * b > 0.0 ? min(abs(a), abs(b)) : 0.0;
    return smoothstep(0.0, 0.2, facing / max(length(to_eye), 1e-20));
}

// Far away, all lines in a window get as much ink as the most that are drawn in full; those inside of an object go first.
float hw_far_share(int line_class, float px_per_m, vec4 crowding, float inside)
{
    if (hw_line_fade.x <= 0.0) return 1.0;
    float share = hw_crowded_share(crowding, hw_line_fade.x / (px_per_m * hw_line_fade.y));
    if (hw_line_is_contour(line_class) > 0.5) return share;
    float shown = clamp((share - hw_line_fade.z) / (1.0 - hw_line_fade.z), 0.0, 1.0);
    return mix(share, shown, inside);
}

// Width in pixels before presence and taper of strokes: lines get thinner before they fade, so that the round ends of
// neighbours never show as dots.
float hw_line_width(int line_class, float fold, float distance_m, float px_per_m, vec4 crowding, float inside)
{
    float width = hw_line_width_px[line_class];
    if (line_class == 1 || line_class == 2) {
        float rise = clamp((fold - hw_line_fold.y) / max(hw_line_fold.z - hw_line_fold.y, 1e-6), 0.0, 1.0);
        width *= mix(1.0, mix(0.25, 1.0, rise), hw_line_fold.x);
    }
    if (hw_line_taper.x > 0.0 && distance_m > hw_line_taper.y)
        width *= mix(1.0, hw_line_taper.y / distance_m, hw_line_taper.x);
    width *= hw_far_share(line_class, px_per_m, crowding, inside);
    return width;
}
