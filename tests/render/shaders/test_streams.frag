#include "surface.glsl"

// Green where the direction is unit and lies in the surface, red elsewhere.
void main()
{
    HwSurface surface = hw_surface();
    float slant = abs(dot(surface.direction_world, surface.normal_world));
    bool is_good = abs(length(surface.direction_world) - 1.0) < 0.01 && slant < 0.15;
    hw_output(is_good ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), 1.0);
}
