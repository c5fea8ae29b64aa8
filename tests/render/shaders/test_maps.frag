#include "surface.glsl"

uniform vec3 tones;  // where the ramp is looked up; all below zero: the image is shown

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    vec3 colour = hw_image(surface);
    if (tones.x >= 0.0) colour = vec3(hw_ramp(tones.x).r, hw_ramp(tones.y).g, hw_ramp(tones.z).b);
    hw_output(colour, material.alpha * hw_presence(surface));
}
