#include "of_2003.glsl"

void main()
{
    vec4 a = neighbour(-1, 1), c = neighbour(1, 1), f = neighbour(-1, -1), h = neighbour(1, -1);
    float one = 1.0 - 0.5 * abs(a.w - h.w), two = 1.0 - 0.5 * abs(c.w - f.w);
    leave_intensities(normals_agree(a, c, f, h), one * one * two * two);
}
