// One of the first two passes of three: adds its part to what the pass before has stored, in eight bits as the paper's buffer.
#undef TO_BE_WIDENED  // what it leaves is no edge yet
#include "of_2003.glsl"

uniform int part;
uniform sampler2D sum_before;  // G

void main()
{
    float before = texture(sum_before, hw_v_uv).g;
    hw_fragment = vec4(0.0, before + depth_part(part), 0.0, 1.0);
}
