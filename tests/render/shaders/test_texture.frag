#include "surface.glsl"

uniform sampler2D own;

void main()
{
    HwSurface surface = hw_surface();
    hw_output(texture(own, surface.position_world.xy + 0.5).rgb, hw_presence(surface));
}
