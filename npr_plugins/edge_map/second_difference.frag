// Edges by second differences of 1 / depth, which are 0 on planes however steeply they are seen. Between two pixels the plane
// before them and the plane behind them are compared. Where both second differences have the same sign the planes meet between
// the pixels: the surface folds there, and no step is left. Where they differ the lesser is the least gap between the planes.
#include "edges.glsl"

uniform vec2 crease_cosines;  // whole edges, and where they begin
uniform float gap;            // share of the distance that is a whole edge

struct Crack {
    float step;  // -1 to 1: positive where the first pixel is nearer
    float fold;  // 0 to 1
    float at_px;  // of the fold, from the first pixel: 0 to 1
};

// Straight on planes, greater where nearer. In a parallel projection depth itself, as a share of the picture's height.
float straight(float depth_m)
{
    if (hw_is_parallel) return depth_m > 0.0 ? -depth_m * hw_focal_px / hw_size_px.y : -1e6;
    return depth_m > 0.0 ? 1.0 / depth_m : 0.0;
}

// The surface at `a` extended by one pixel `way`: straight on from `before`, or where a fold lies between the two, along the
// plane of its normal. `at`: where a is, from this pixel.
float beyond(vec4 before, vec4 a, ivec2 at, ivec2 way)
{
    float w = straight(a.w);
    float straight_on = 2.0 * w - straight(before.w);
    if (dot(before.xyz, a.xyz) > crease_cosines.y) return straight_on;
    vec3 normal = mat3(hw_view_from_world) * a.xyz;
    if (hw_is_parallel) return normal.z > 1e-3 ? w - dot(normal.xy, vec2(way)) / (normal.z * hw_size_px.y) : straight_on;
    vec3 ray = vec3((gl_FragCoord.xy + vec2(at) - 0.5 * hw_size_px) / hw_focal_px, -1.0);
    float towards = dot(normal, ray);
    return towards < -1e-3 ? w * (1.0 + dot(normal.xy, vec2(way)) / (hw_focal_px * towards)) : straight_on;
}

// Between the pixel `a`, which is this one, and `b` one step `way` from it, of a row of four.
Crack crack_between(vec4 before, vec4 a, vec4 b, vec4 after, ivec2 way)
{
    float za = straight(a.w), zb = straight(b.w);
    float bend_a = zb - beyond(before, a, ivec2(0), way);
    float bend_b = za - beyond(after, b, way, -way);
    bool is_folded = bend_a * bend_b > 0.0;
    float unit = hw_is_parallel ? 1.0 : max(max(za, zb), 1e-20);
    float least = is_folded ? 0.0 : min(abs(bend_a), abs(bend_b)) / unit;
    Crack crack;
    crack.step = sign(bend_b - bend_a) * smoothstep(0.5 * gap, gap, least);
    crack.fold = a.w > 0.0 && b.w > 0.0
                     ? 1.0 - smoothstep(crease_cosines.x, crease_cosines.y, dot(a.xyz, b.xyz))
                     : 0.0;
    crack.at_px = is_folded ? bend_b / (bend_a + bend_b) : 0.5;
    return crack;
}

Crack stronger(Crack a, Crack b)
{
    if (a.fold == b.fold) return a.at_px < b.at_px ? a : b;
    return a.fold > b.fold ? a : b;
}

void main()
{
    vec4 here = pixel(ivec2(0));
    vec4 left = pixel(ivec2(-1, 0)), right = pixel(ivec2(1, 0)), down = pixel(ivec2(0, -1)), up = pixel(ivec2(0, 1));
    Crack to_left = crack_between(right, here, left, pixel(ivec2(-2, 0)), ivec2(-1, 0));
    Crack to_right = crack_between(left, here, right, pixel(ivec2(2, 0)), ivec2(1, 0));
    Crack to_down = crack_between(up, here, down, pixel(ivec2(0, -2)), ivec2(0, -1));
    Crack to_up = crack_between(down, here, up, pixel(ivec2(0, 2)), ivec2(0, 1));
    vec4 steps_away = vec4(to_left.step, to_right.step, to_down.step, to_up.step);
    vec4 nearer = max(steps_away, 0.0), any = abs(steps_away);
    float profile = max(max(nearer.x, nearer.y), max(nearer.z, nearer.w));
    float stepped = max(max(any.x, any.y), max(any.z, any.w));
    Crack in_row = stronger(to_left, to_right), in_column = stronger(to_down, to_up);
    // A line that cuts the row at one place and the column at another is nearer than both.
    Crack fold = stronger(in_row, in_column);
    if (min(in_row.fold, in_column.fold) > 0.5)
        fold.at_px = in_row.at_px * in_column.at_px / max(length(vec2(in_row.at_px, in_column.at_px)), 1e-6);
    leave_edges(fold.fold * (1.0 - stepped), fold.at_px, profile, vec2(to_right.step, to_up.step));
}
