#include "surface.glsl"

#ifdef SHOWS_IDS
uniform usampler2D shown;
#else
uniform sampler2D shown;
#endif

void main()
{
    HwSurface surface = hw_surface();
#ifdef SHOWS_IDS
    uint id = texelFetch(shown, ivec2(gl_FragCoord.xy), 0).r;
    vec3 colour = vec3(uvec3(id, id >> 8, id >> 16) & 255u) / 255.0;
#else
    vec3 colour = texture(shown, gl_FragCoord.xy / hw_size_px).rgb;
#endif
    hw_output(colour, hw_presence(surface));
}
