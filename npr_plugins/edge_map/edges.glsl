// What the operators of the edge map share: the pixels that they compare, and what they leave.
#ifdef TO_BE_WIDENED
#define HW_OWN_OUTPUTS
#endif
#include "full_screen.glsl"
#include "normal_depth.glsl"

uniform sampler2D normal_depth;
uniform vec2 depth_range_m;
uniform vec3 reach_px;  // from the middle of an inner edge, from a profile edge on the nearer side, and on the other

#ifdef TO_BE_WIDENED
layout(location = 0) out vec4 edges;  // inner edge, how far from this pixel it lies, profile edge, border
layout(location = 1) out vec4 steps;  // 0.5 + half of the steps in depth to the right and upwards, positive where this pixel is nearer
#endif

// Unit normal and depth in metres, 0 where nothing is. Beyond the picture as at its border.
vec4 pixel(ivec2 offset)
{
    ivec2 last = textureSize(normal_depth, 0) - 1;
    vec4 texel = texelFetch(normal_depth, clamp(ivec2(gl_FragCoord.xy) + offset, ivec2(0), last), 0);
#ifdef NORMAL_DEPTH_BYTES
    texel = hw_normal_depth_of_bytes(texel, depth_range_m);
#endif
    return texel;
}

// Strengths in [0, 1]; inner_px: how far from the pixel's centre the inner edge lies; border: of the profile edge, where it lies
// within one object.
void leave_classes(float inner, float inner_px, float profile, float border, vec2 steps_right_up)
{
#ifdef TO_BE_WIDENED
    edges = vec4(inner, inner_px, profile, border);
    steps = vec4(0.5 + 0.5 * steps_right_up, 0.0, 1.0);
#else
    float covered = inner * clamp(reach_px.x + 0.5 - inner_px, 0.0, 1.0);
    float across = clamp(reach_px.y, 0.0, 1.0);
    hw_fragment = vec4(1.0 - covered, 1.0 - profile * across, 1.0 - border * across, 1.0);
#endif
}

// The same of operators that do not tell borders.
void leave_edges(float inner, float inner_px, float profile, vec2 steps_right_up)
{
    leave_classes(inner, inner_px, profile, 0.0, steps_right_up);
}
