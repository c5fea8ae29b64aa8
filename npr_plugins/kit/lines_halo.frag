// The parts of profile lines that reach beyond the style's own objects, over whatever lies behind them.
#include "full_screen.glsl"

uniform sampler2D edge_map;
uniform sampler2D edge_owner;  // where the object is whose edge reaches here, pixels: (x + 128) / 255
uniform sampler2D own_mask;
uniform vec4 profile_pen;

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 away = ivec2(floor(255.0 * texelFetch(edge_owner, here, 0).rg + 0.5)) - 128;
    float edge = away == ivec2(0) ? 0.0 : 1.0 - texelFetch(edge_map, here, 0).g;
    hw_fragment = vec4(profile_pen.rgb, profile_pen.a * edge * texelFetch(own_mask, here + away, 0).r);
}
