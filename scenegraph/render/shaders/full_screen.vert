// One triangle over the whole target. full_screen.glsl is the fragment side.
out vec2 hw_v_uv;

void main()
{
    hw_v_uv = vec2((gl_VertexID & 1) * 2, gl_VertexID & 2);
    gl_Position = vec4(hw_v_uv * 2.0 - 1.0, 0.0, 1.0);
}
