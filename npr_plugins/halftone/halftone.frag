#include "surface.glsl"
#include "shadow.glsl"
#include "lighting.glsl"
#include "hatch.glsl"
#include "halftone.glsl"
#include "lines_look.glsl"

uniform vec3 tone_range;  // darkness, white from, share of the material
uniform vec4 paper;       // linear; share of the material
uniform vec3 ink_colour;
#ifdef SCREEN_OF_DOTS
uniform sampler2D priorities;
uniform vec3 rows;  // cosine and sine of their turn, logical pixels from dot to dot
#endif

float ink_here(HwSurface surface, float tone)
{
#if defined(SCREEN_OF_DOTS)
    float dot_px = rows.z * hw_px_scale;
    vec2 at = gl_FragCoord.xy / dot_px;
    at = vec2(rows.x * at.x + rows.y * at.y, rows.x * at.y - rows.y * at.x);
    // From dot to paper is half of the way from dot to dot: an edge about a pixel wide.
    return hw_smooth_threshold(textureLod(priorities, at, 0.0).r, tone, max(0.4 * dot_px, 1.0));
#elif defined(HW_TONAL_MAP)
    return hw_halftone_ink(hw_tonal_map, hw_tonal_info, surface.hatch_uv * kHwUp, surface.hatch_uv_dx * kHwUp,
                           surface.hatch_uv_dy * kHwUp, tone);
#else
    return tone;
#endif
}

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    float lit = clamp(hw_light_tone(surface, material.normal_world) / tone_range.y, 0.0, 1.0);
    float white = mix(1.0, sqrt(clamp(hw_luminance(material.base_colour), 0.0, 1.0)), tone_range.z);
    float ink = ink_here(surface, tone_range.x * (1.0 - lit * white));
    vec3 colour = mix(mix(paper.rgb, material.base_colour, paper.a), ink_colour, ink);
    hw_output(hw_with_lines(colour, 1.0), material.alpha * hw_presence(surface));
}
