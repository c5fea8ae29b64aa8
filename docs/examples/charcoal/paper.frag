#include "surface.glsl"

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    hw_output(vec3(0.96), material.alpha * hw_presence(surface));
}
