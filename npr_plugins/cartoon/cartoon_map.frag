// Smooths the steps between bands by the diagonal neighbours. What is beside the objects is left out.
#include "full_screen.glsl"

uniform sampler2D hard;  // square roots of linear colours, 1 where an object is

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(hard, 0) - 1;
    vec4 sum = 4.0 * texelFetch(hard, here, 0);
    for (int y = -1; y <= 1; y += 2)
        for (int x = -1; x <= 1; x += 2) sum += texelFetch(hard, clamp(here + ivec2(x, y), ivec2(0), last), 0);
    hw_fragment = vec4(sum.rgb / max(sum.a, 1.0), 1.0);
}
