#include "surface.glsl"
#include "lines_look.glsl"

uniform vec4 paper;  // linear; share of the material

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    vec3 colour = mix(paper.rgb, material.base_colour, paper.a);
    hw_output(hw_with_lines(colour, 1.0), material.alpha * hw_presence(surface));
}
