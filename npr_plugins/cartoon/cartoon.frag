#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"
#include "lines_look.glsl"

#ifdef FROM_CARTOON_MAP
uniform sampler2D cartoon_map;
#else
uniform vec3 bands;          // how many; light up to which the darkest goes, and from which the lightest begins
uniform vec3 shadow_colour;  // linear
uniform float texture_share;

// The band of a tone, 0 to 1.
float band_of(float tone)
{
    float count = bands.x;
    // The darkest band ends at bands.y, the lightest begins at bands.z; the others share what lies between.
    float at = 1.0 + (tone - bands.y) / max(bands.z - bands.y, 1e-3) * (count - 2.0);
    if (count < 2.5) at = 1.0 + 4.0 * (tone - 0.5 * (bands.y + bands.z));
#ifdef SMOOTH_STEPS
    float step_at = floor(at + 0.5);
    float width = clamp(0.75 * fwidth(at), 1.0 / 255.0, 0.5);
    float band = step_at - 1.0 + smoothstep(-width, width, at - step_at);
#else
    float band = floor(at);
#endif
    return clamp(band, 0.0, count - 1.0) / (count - 1.0);
}

vec3 shade_of(HwSurface surface, HwMaterial material)
{
    float band = band_of(hw_light_tone(surface, material.normal_world));
#ifdef HW_RAMP_MAP
    return hw_ramp(band);
#else
    vec3 colour = mix(hw_mean_colour, material.base_colour, texture_share);
    return colour * mix(shadow_colour, vec3(1.0), band);
#endif
}
#endif

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
#if defined(FROM_CARTOON_MAP)
    vec4 smooth_shade = texelFetch(cartoon_map, ivec2(gl_FragCoord.xy), 0);
    vec3 colour = smooth_shade.rgb * smooth_shade.rgb;
#else
    vec3 colour = shade_of(surface, material);
#endif
#ifdef INTO_CARTOON_MAP
    hw_fragment = vec4(sqrt(colour), 1.0);
#else
    hw_output(hw_with_lines(colour, 1.0), material.alpha * hw_presence(surface));
#endif
}
