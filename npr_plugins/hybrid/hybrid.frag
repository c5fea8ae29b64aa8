#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"
#include "hatch.glsl"
#include "halftone.glsl"
#include "ink.glsl"

uniform vec3 ink_range;    // height where ink begins, where it has risen, 1 when there is a gradient
uniform float ink_weight;

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    float ink = ink_weight;
    if (ink_range.z > 0.5) {
        float width = ink_range.y - ink_range.x;
        float at = clamp((surface.position_world.y - ink_range.x) / (abs(width) < 1e-6 ? 1e-6 : width), 0.0, 1.0);
        ink *= at * at * (3.0 - 2.0 * at);
    }
    vec3 colour = vec3(0.0);
    if (ink < 1.0) colour = hw_display(hw_lit(surface, material));
    if (ink > 0.0) colour = mix(colour, hw_pen_and_ink(surface, material), ink);
    hw_output(colour, material.alpha * hw_presence(surface));
}
