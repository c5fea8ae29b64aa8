#include "surface.glsl"
#include "shadow.glsl"

uniform vec3 flat_colour;

void main()
{
    HwSurface surface = hw_surface();
    hw_output(flat_colour * hw_shadow(surface), 1.0);
}
