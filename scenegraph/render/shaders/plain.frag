// What the host draws when a style fails: neutral gray, lit from the eye, so that shapes stay readable.
#include "surface.glsl"

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    float facing = abs(dot(surface.normal_world, surface.to_eye_world));
    hw_output(vec3(mix(0.18, 0.55, facing)), material.alpha * hw_presence(surface));
}
