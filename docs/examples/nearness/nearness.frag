#include "surface.glsl"

uniform float far_m;

void main()
{
    HwSurface surface = hw_surface();
    hw_material(surface);  // for the holes of alpha masks
    hw_fragment = vec4(1.0 - clamp(surface.distance_m / far_m, 0.0, 1.0));
}
