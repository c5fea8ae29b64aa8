#include "full_screen.glsl"

uniform sampler2D source;
uniform vec2 step_px;

void main()
{
    vec2 step_uv = step_px / hw_size_px;
    vec4 sum = vec4(0.0);
    for (int i = -4; i <= 4; ++i) sum += (5.0 - abs(float(i))) * texture(source, hw_v_uv + float(i) * step_uv);
    hw_fragment = sum / 25.0;
}
