#include "full_screen.glsl"

uniform sampler2D source;

void main() { hw_fragment = vec4(1.0 - texture(source, hw_v_uv).rgb, 1.0); }
