#include "full_screen.glsl"

// Source: Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 4.1.2.
// The C1 sum of the paper is 0 where there is no edge; it is stored as 1 - sum, so that 1 means no edge everywhere.

uniform sampler2D normal_depth;  // xyz unit normal, w depth along the view in metres, 0 where nothing was drawn
uniform float depth_scale;
uniform float width_px;

// Steps in depth count by the share of the distance that they make. The slope of 1/z is constant on planes, so comparing
// with the mean of both sides leaves floors at grazing angles without edges.
float depth_step(float near_side, float middle, float far_side)
{
    float unit = hw_is_parallel ? 1.0 : max(middle, 1e-9);
    return min(abs(near_side + far_side - 2.0 * middle) / unit * depth_scale, 2.0);
}

// In a parallel projection depth itself is straight on planes; a step counts by its share of the picture's height.
vec4 comparable(vec4 depth_m)
{
    if (hw_is_parallel) return -mix(vec4(1e6), depth_m * hw_focal_px / hw_size_px.y, greaterThan(depth_m, vec4(0.0)));
    return 1.0 / max(depth_m, vec4(1e-3));
}

void main()
{
    vec2 step_uv = width_px * hw_px_scale / hw_size_px;
    vec4 x = texture(normal_depth, hw_v_uv);
    vec4 a = texture(normal_depth, hw_v_uv + step_uv * vec2(-1.0, 1.0));
    vec4 c = texture(normal_depth, hw_v_uv + step_uv * vec2(1.0, 1.0));
    vec4 f = texture(normal_depth, hw_v_uv + step_uv * vec2(-1.0, -1.0));
    vec4 h = texture(normal_depth, hw_v_uv + step_uv * vec2(1.0, -1.0));
    float i_n = 0.5 * (dot(a.xyz, h.xyz) + dot(c.xyz, f.xyz));
    vec4 inverse = comparable(vec4(a.w, c.w, f.w, h.w));
    float middle = comparable(x.wwww).x;
#ifdef OPERATOR_C1
    vec4 b = texture(normal_depth, hw_v_uv + step_uv * vec2(0.0, 1.0));
    vec4 d = texture(normal_depth, hw_v_uv + step_uv * vec2(-1.0, 0.0));
    vec4 e = texture(normal_depth, hw_v_uv + step_uv * vec2(1.0, 0.0));
    vec4 g = texture(normal_depth, hw_v_uv + step_uv * vec2(0.0, -1.0));
    vec4 straight = comparable(vec4(b.w, d.w, e.w, g.w));
    float sum = 0.125 * (depth_step(inverse.x, middle, inverse.w) + depth_step(inverse.y, middle, inverse.z)) +
                0.25 * (depth_step(straight.x, middle, straight.w) + depth_step(straight.y, middle, straight.z));
    float i_z = 1.0 - sum;
#else
    float one = 1.0 - 0.5 * depth_step(inverse.x, middle, inverse.w);
    float two = 1.0 - 0.5 * depth_step(inverse.y, middle, inverse.z);
    float i_z = one * one * two * two;
#endif
    hw_fragment = vec4(clamp(i_n, 0.0, 1.0), clamp(i_z, 0.0, 1.0), 0.0, 1.0);
}
