// What both ways of drawing lines share: class, width and share of ink. Included by line_quad.vert and line_end.vert.
#include "frame.glsl"
#include "position.glsl"
#include "presence.glsl"

in vec3 hw_in_position;
in vec4 hw_in_other;  // xyz the other end, w class
in vec3 hw_in_normal;   // of the faces beside the line; zero: drawn whatever they do
in vec3 hw_in_tangent;
in float hw_in_uv1;  // the fold at the line, radians

uniform mat4 hw_relative_from_object;
uniform vec3 hw_line_eye_object;
uniform float hw_line_width_px[6];  // device pixels, by class
uniform vec3 hw_line_colour[6];     // linear
uniform vec4 hw_line_fade;          // x mean length of the object's lines (metres), y none and z full spacing (px), w on
uniform vec3 hw_line_fold;          // x how much lesser folds thin creases, y the least fold, z from which on they are whole
uniform vec2 hw_line_taper;         // x strength, y from metres

// Whether all faces beside the line look away and are not drawn. The middle of the line stands for it, so that both ends
// agree; near ties are drawn.
bool hw_line_is_culled()
{
    vec3 to_eye = hw_line_eye_object - 0.5 * (hw_in_position + hw_in_other.xyz);
    float tie = -1e-4 * length(to_eye);
    return dot(hw_in_normal, to_eye) < tie && dot(hw_in_tangent, to_eye) < tie;
}

// Silhouettes and borders: the surface ends or turns away there.
float hw_line_is_contour(int line_class) { return line_class == 0 || line_class == 3 ? 1.0 : 0.0; }

// Width in pixels at a point of the line: the presence and the far policy thin lines before they fade, so that the round
// ends of neighbours never show as dots.
float hw_line_width_at(int line_class, vec3 relative)
{
    float distance_m = length(relative);
    float width = hw_line_width_px[line_class];
    if (line_class == 1 || line_class == 2) {
        float fold = clamp((hw_in_uv1 - hw_line_fold.y) / max(hw_line_fold.z - hw_line_fold.y, 1e-6), 0.0, 1.0);
        width *= mix(1.0, mix(0.25, 1.0, fold), hw_line_fold.x);
    }
    if (hw_line_taper.x > 0.0 && distance_m > hw_line_taper.y)
        width *= mix(1.0, hw_line_taper.y / distance_m, hw_line_taper.x);
    if (hw_line_fade.w > 0.5 && line_class != 0) {
        float spacing_px = hw_line_fade.x * hw_focal_px / max(distance_m, 1e-20);
        width *= smoothstep(hw_line_fade.y, hw_line_fade.z, spacing_px);
    }
    return width;
}
