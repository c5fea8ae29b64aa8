#include "surface.glsl"

uniform vec3 flat_colour;
#ifdef SHOWS_IMAGE
uniform sampler2D normal_depth;
#endif

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    vec3 colour = flat_colour * material.base_colour;
#ifdef SHOWS_IMAGE
    vec4 here = texture(normal_depth, gl_FragCoord.xy / hw_size_px);
    colour = vec3(0.5 + 0.5 * here.xyz);
#endif
    hw_output(colour, material.alpha * hw_presence(surface));
}
