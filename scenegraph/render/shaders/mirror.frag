// What a mirror shows, laid over its own look: a picture of the view from the reflected eye, in which everything stands where
// it is seen in the mirror.
#include "surface.glsl"

uniform sampler2D reflection;
uniform vec3 tint;
uniform float reflectance;

void main()
{
    HwSurface surface = hw_surface();
#ifdef HW_ALPHA_MASK
    hw_material(surface);
#endif
    hw_output(texelFetch(reflection, ivec2(gl_FragCoord.xy), 0).rgb * tint, reflectance);
}
