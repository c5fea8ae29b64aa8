layout(location = 0) out vec4 hw_fragment;
in vec2 hw_v_uv;
in vec4 hw_v_colour;
uniform sampler2D hw_atlas;

void main() { hw_fragment = vec4(hw_v_colour.rgb, hw_v_colour.a * texture(hw_atlas, hw_v_uv).r); }
