#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"
#include "lines_look.glsl"

uniform float brightness;
uniform float saturation;
uniform vec3 tint;  // linear

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    vec3 colour = hw_display(brightness * hw_lit(surface, material));
    colour = max(mix(vec3(hw_luminance(colour)), colour, saturation), 0.0) * tint;
    hw_output(hw_with_lines(colour, 1.0), material.alpha * hw_presence(surface));
}
