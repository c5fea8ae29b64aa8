// Text over the picture: pixels from the top left corner, texels of the font's atlas.
in vec3 hw_in_position;
in vec2 hw_in_uv0;
in vec4 hw_in_colour;
uniform vec2 hw_target_size_px;
uniform vec2 hw_atlas_size;
out vec2 hw_v_uv;
out vec4 hw_v_colour;

void main()
{
    vec2 place = hw_in_position.xy / hw_target_size_px;
    gl_Position = vec4(place.x * 2.0 - 1.0, 1.0 - place.y * 2.0, 0.0, 1.0);
    hw_v_uv = hw_in_uv0 / hw_atlas_size;
    hw_v_colour = hw_in_colour;
}
