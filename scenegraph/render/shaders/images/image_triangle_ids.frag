// The engine's image "triangle_ids": 32 bits in four bytes, low first.

layout(location = 0) out vec4 hw_fragment;
flat in uint hw_v_triangle;

void main()
{
    uvec4 bytes = uvec4(hw_v_triangle, hw_v_triangle >> 8, hw_v_triangle >> 16, hw_v_triangle >> 24) & 255u;
    hw_fragment = vec4(bytes) / 255.0;
}
