// White where both images of test_outputs.frag hold what they should.
#include "full_screen.glsl"

uniform usampler2D ids;
uniform sampler2D colours;

void main()
{
    ivec2 size = textureSize(ids, 0);
    uvec2 id = texelFetch(ids, min(ivec2(hw_v_uv * vec2(size)), size - 1), 0).rg;
    bool is_right = id.r == 1u && id.g >= 1u && id.g <= 12u && texture(colours, hw_v_uv).g == 1.0;
    hw_fragment = is_right ? vec4(1.0) : vec4(0.0, 0.0, 0.0, 1.0);
}
