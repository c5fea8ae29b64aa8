#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"
#include "hatch.glsl"
#include "halftone.glsl"
#include "ink.glsl"
#include "lines_look.glsl"

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    hw_output(hw_with_lines(hw_pen_and_ink(surface, material), 1.0), material.alpha * hw_presence(surface));
}
