// Triangles with vertices of their own, so that three vertices make one number: gl_PrimitiveID is not in ES.
#include "position.glsl"

in vec3 hw_in_position;
uniform int hw_first_triangle;
flat out uint hw_v_triangle;

void main()
{
    hw_set_position(hw_in_position);
    hw_v_triangle = uint(hw_first_triangle + gl_VertexID / 3) + 1u;
}
