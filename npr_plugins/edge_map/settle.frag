// Where the border runs through pixels that hold profile edges, from its stairs: pixels of one height follow each other until the
// border turns down at one end and up at the other; between the two it runs straight. Where it turns the same way at both ends,
// or farther away than is looked, nothing is known: half a pixel.
#include "full_screen.glsl"

uniform sampler2D edges;  // as they were found
uniform sampler2D steps;

const int kFarthestPx = 32;

// Whether a pixel lies before the next one `way`, by how much.
float before(ivec2 place, ivec2 way)
{
    ivec2 last = textureSize(steps, 0) - 1;
    bool is_back = way.x + way.y < 0;
    vec2 step = 2.0 * texelFetch(steps, clamp(is_back ? place + way : place, ivec2(0), last), 0).rg - 1.0;
    float along = way.x != 0 ? step.x : step.y;
    return is_back ? -along : along;
}

// Where the stair that lies `out_way` of this pixel ends: x how far away, y 0.5 where the border rises there, -0.5 where it falls,
// each by one pixel, 0 where that is not known. By more it turns a corner.
vec2 stair_end(ivec2 here, ivec2 out_way, ivec2 along)
{
    for (int i = 1; i <= kFarthestPx; ++i) {
        ivec2 last = here + (i - 1) * along, next = last + along;
        float side = before(last, along);
        if (side > 0.5) return vec2(float(i) - 0.5, before(next - out_way, out_way) > 0.5 ? -0.5 : 0.0);
        if (side < -0.5) return vec2(0.0);
        if (before(next, out_way) <= 0.5) {
            bool rises = before(next + out_way, -along) > 0.5 && before(next + out_way, out_way) > 0.5;
            return vec2(float(i) - 0.5, rises ? 0.5 : 0.0);
        }
    }
    return vec2(0.0);
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    float at_px = 0.5, longest_px = 0.0;
    if (texelFetch(edges, here, 0).b > 0.0) {
        for (int i = 0; i < 4; ++i) {
            ivec2 out_way = i == 0 ? ivec2(1, 0) : i == 1 ? ivec2(-1, 0) : i == 2 ? ivec2(0, 1) : ivec2(0, -1);
            if (before(here, out_way) <= 0.5) continue;
            vec2 one = stair_end(here, out_way, out_way.yx), two = stair_end(here, out_way, -out_way.yx);
            float length_px = one.x + two.x;
            if (one.y * two.y >= 0.0 || length_px <= longest_px) continue;
            longest_px = length_px;
            float slope = (one.y - two.y) / length_px;
            at_px = (0.5 + two.y + slope * two.x) * inversesqrt(1.0 + slope * slope);
        }
    }
    hw_fragment = vec4(at_px);
}
