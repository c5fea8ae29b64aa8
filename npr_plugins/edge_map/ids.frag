// Edges by the numbers of triangles. IDS_OF_2011: between pixels whose triangles share no corner, as in the paper. Else the planes
// of the two triangles tell, too: one ends before the other, or they meet.
// Source: Diktas, Sahiner. ID-Based Rendering of Silhouettes on GPU. 2011, section 4.2.
#include "edges.glsl"
#include "triangle_ids.glsl"

uniform highp usampler2D triangle_ids;
uniform highp sampler2D planes;  // nearness, which is straight on a plane; what it grows to the right and upwards
uniform highp float gap;         // as in second_difference.frag, between triangles that are small
uniform highp float small_px;    // height of a triangle

const float kRounding = 1.0 / 65536.0;  // of nearness

struct Crack {
    float step;  // 1: this pixel's triangle ends before the other, -1: the other way round
    bool meets;
    bool is_border;  // the step lies within one object
};

ivec2 inside(ivec2 offset)
{
    return clamp(ivec2(gl_FragCoord.xy) + offset, ivec2(0), textureSize(triangle_ids, 0) - 1);
}

highp uint id_at(ivec2 offset) { return texelFetch(triangle_ids, inside(offset), 0).r; }

// Of a triangle, where its plane has that nearness.
float height_px(HwTriangle t, float nearness)
{
    float scale = hw_is_parallel ? hw_focal_px : hw_focal_px * nearness;
    return hw_least_height_m(t) * scale;
}

Crack crack_between(HwTriangle t, HwTriangle other, vec4 a, vec4 b, ivec2 way)
{
    float on_a = float(way.x) * a.y + float(way.y) * a.z, on_b = float(way.x) * b.y + float(way.y) * b.z;
    float bend_a = b.x - (a.x + on_a), bend_b = a.x - (b.x - on_b);  // the other, and this, against planes that go on
    float unit = max(abs(a.x), abs(b.x));
    bool is_one_object = hw_object_of(t) == hw_object_of(other);
    // Planes of triangles with a common edge meet there, unless one is folded over the other. Around a common corner, and where
    // triangles are so small that whole ones lie between two pixels, a smooth surface may lie beside its planes.
    int common_corners = hw_common_corners(t, other);
    bool is_dense = is_one_object && min(height_px(t, a.x), height_px(other, b.x)) < small_px;
    float least = unit * (is_dense || common_corners == 1 ? gap : kRounding);
    bool is_before = bend_a < -least && bend_b > least, is_behind = bend_a > least && bend_b < -least;
    bool meets = !is_before && !is_behind && !is_dense && common_corners == 0;
    return Crack(is_before ? 1.0 : is_behind ? -1.0 : 0.0, meets, is_one_object);
}

Crack crack_to(HwTriangle t, ivec2 way)
{
    highp uint id = id_at(way);
    if (id == t.id) return Crack(0.0, false, false);
    if (id == 0u || t.id == 0u) return Crack(t.id == 0u ? -1.0 : 1.0, false, false);
    HwTriangle other = hw_triangle(id);
#ifdef IDS_OF_2011
    return Crack(hw_is_adjacent(t, other) ? 0.0 : 1.0, false, false);
#else
    return crack_between(t, other, texelFetch(planes, inside(ivec2(0)), 0), texelFetch(planes, inside(way), 0), way);
#endif
}

void main()
{
    const ivec2 kRight = ivec2(1, 0), kUp = ivec2(0, 1);
    highp uint id = id_at(ivec2(0));
    bool is_alone = id_at(-kRight) == id && id_at(kRight) == id && id_at(-kUp) == id && id_at(kUp) == id;
    bool ends = false, is_outline = false, meets = false;
    vec2 steps = vec2(0.0);
    if (!is_alone) {
        HwTriangle t = hw_triangle(max(id, 1u));
        t.id = id;
        Crack cracks[4] = Crack[4](crack_to(t, -kRight), crack_to(t, kRight), crack_to(t, -kUp), crack_to(t, kUp));
        for (int i = 0; i < 4; ++i) {
            ends = ends || cracks[i].step > 0.0;
            is_outline = is_outline || (cracks[i].step > 0.0 && !cracks[i].is_border);
            meets = meets || cracks[i].meets;
        }
        steps = vec2(cracks[1].step, cracks[3].step);
    }
#ifdef IDS_OF_2011
    steps = vec2(0.0);  // both sides are edges
#endif
    leave_classes(meets && !ends ? 1.0 : 0.0, 0.5, ends ? 1.0 : 0.0, ends && !is_outline ? 1.0 : 0.0, steps);
}
