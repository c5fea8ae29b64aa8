#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"

uniform vec3 flat_colour;

void main()
{
    HwSurface surface = hw_surface();
#ifdef HW_LIGHTMAP
    vec3 kilolux = hw_baked_illuminance() * 1e-3;
#else
    vec3 kilolux = vec3(1.0, 0.0, 1.0);
#endif
    float tone = hw_light_tone(surface, surface.normal_world);
    hw_output(flat_colour.r > 0.5 ? kilolux : vec3(tone), 1.0);
}
