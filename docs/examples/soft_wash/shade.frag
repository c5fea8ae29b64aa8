// R: light times coverage, G: coverage, so that the blur does not mix in what is beside the objects.
#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    hw_fragment = vec4(hw_light_tone(surface, material.normal_world), 1.0, 0.0, 1.0);
}
