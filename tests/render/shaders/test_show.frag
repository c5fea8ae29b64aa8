#include "surface.glsl"

uniform sampler2D shown;

void main()
{
    HwSurface surface = hw_surface();
    hw_output(texture(shown, gl_FragCoord.xy / hw_size_px).rgb, hw_presence(surface));
}
