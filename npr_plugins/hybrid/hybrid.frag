#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"
#include "hatch.glsl"
#include "halftone.glsl"
#include "ink.glsl"
#include "lines_look.glsl"

uniform vec4 ink_share;  // see hw_share_at()
uniform float line_presence;

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    float ink = hw_share_at(ink_share, surface.position_world.y);
    vec3 colour = vec3(0.0);
    if (ink < 1.0) colour = hw_display(hw_lit(surface, material));
    if (ink > 0.0) colour = mix(colour, hw_pen_and_ink(surface, material), ink);
    // Lines are there from where ink begins.
    colour = hw_with_lines(colour, mix(line_presence, 1.0, min(2.0 * ink, 1.0)));
    hw_output(colour, material.alpha * hw_presence(surface));
}
