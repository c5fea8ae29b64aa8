// The C1 operator for depth. The paper's sum is 0 where no edge is; it is kept as 1 - sum. With IN_THREE_PASSES c1_part.frag has
// stored what lies above and beside.
#include "of_2003.glsl"

#ifdef IN_THREE_PASSES
uniform sampler2D sum_before;  // G
uniform int part;
#endif

void main()
{
#ifdef IN_THREE_PASSES
    float sum = texture(sum_before, hw_v_uv).g + depth_part(part);
#else
    float sum = depth_part(0) + depth_part(1) + depth_part(2);
#endif
    float i_n = normals_agree(neighbour(-1, 1), neighbour(1, 1), neighbour(-1, -1), neighbour(1, -1));
    leave_intensities(i_n, 1.0 - clamp(sum, 0.0, 1.0));
}
