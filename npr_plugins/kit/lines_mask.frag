// How much of a style is seen where: lines_halo.frag asks by it whose an edge is.
#include "surface.glsl"

void main()
{
    HwSurface surface = hw_surface();
    hw_material(surface);  // for the holes of alpha masks
    hw_fragment = vec4(hw_presence(surface));
}
