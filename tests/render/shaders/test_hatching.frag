#include "surface.glsl"
#include "hatch.glsl"
#include "halftone.glsl"

// Ink alone, in one kind of hatching: SHOWS_STROKES, or what map the object has. With CHECKS_RANGE: white where the ink is a
// number from 0 to 1, black elsewhere.
uniform vec4 probe;      // tone, spacing, stroke width, stroke length: logical pixels
uniform vec4 directions;  // the first and the crossing one

float ink_of(HwSurface s)
{
#if defined(SHOWS_STROKES)
    HwHand hand = HwHand(probe.w, 5.0, probe.w > 0.0 ? 0.5 : 0.0, 0.18);
    return hw_tonal_hatching(s, HwHatching(probe.y, probe.z, directions.xy, directions.zw, hand), probe.x);
#elif defined(HW_HATCH_MAP)
    vec2 across = vec2(-directions.y, directions.x) * kHwUp;
    return hw_hatch_map_ink(hw_hatch_map, hw_hatch_info, dot(s.hatch_uv, across),
                            vec2(dot(s.hatch_uv_dx, across), dot(s.hatch_uv_dy, across)), probe.y);
#elif defined(HW_INK_MAP)
    return hw_ink_map_ink(hw_ink_map, hw_ink_info, s.map_uv * kHwMapUp, s.map_uv_dx * kHwMapUp,
                          s.map_uv_dy * kHwMapUp, 0.0);
#elif defined(HW_TONAL_MAP) && defined(SHOWS_HALFTONE)
    return hw_halftone_ink(hw_tonal_map, hw_tonal_info, s.hatch_uv * kHwUp, s.hatch_uv_dx * kHwUp, s.hatch_uv_dy * kHwUp,
                           probe.x);
#elif defined(HW_TONAL_MAP)
    return hw_tonal_map_ink(hw_tonal_map, hw_tonal_info, s.hatch_uv * kHwUp, s.hatch_uv_dx * kHwUp,
                            s.hatch_uv_dy * kHwUp, probe.x);
#else
    return 0.0;
#endif
}

void main()
{
    HwSurface surface = hw_surface();
    float ink = ink_of(surface);
#ifdef CHECKS_RANGE
    hw_output(vec3(ink >= 0.0 && ink <= 1.0 ? 1.0 : 0.0), 1.0);
#else
    hw_output(vec3(1.0 - ink), 1.0);
#endif
}
