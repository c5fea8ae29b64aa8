// What the operators of the paper share. Its pixels around X are A B C above, D E beside and F G H below.
// Source: Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 4.1.2.
#include "edges.glsl"

uniform int radius_px;

// Normal, and depth as a share of the range of the objects; 1 where nothing is.
vec4 neighbour(int right, int up)
{
    vec4 p = pixel(radius_px * ivec2(right, up));
    float share = (p.w - depth_range_m.x) / (depth_range_m.y - depth_range_m.x);
    return vec4(p.xyz, p.w > 0.0 ? clamp(share, 0.0, 1.0) : 1.0);
}

// I_N: the mean cosine between opposite diagonal neighbours.
float normals_agree(vec4 a, vec4 c, vec4 f, vec4 h)
{
    return clamp(0.5 * (dot(a.xyz, h.xyz) + dot(c.xyz, f.xyz)), 0.0, 1.0);
}

// Of the C1 operator: what lies above (0), beside (1) and below (2).
float depth_part(int part)
{
    float x = neighbour(0, 0).w;
    int up = 1 - part;
    float side = abs(neighbour(-1, up).w - x) + abs(neighbour(1, up).w - x);
    return part == 1 ? 0.25 * side : 0.125 * side + 0.25 * abs(neighbour(0, up).w - x);
}

// Both intensities are 1 where no edge is.
void leave_intensities(float i_n, float i_z) { leave_edges(1.0 - i_n, 0.5, 1.0 - i_z, vec2(0.0)); }
