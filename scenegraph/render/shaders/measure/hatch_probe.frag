// For `hatchway measure hatch`: nothing but a hatch map along the second hatch coordinate, its level chosen in one of the
// ways that are compared. Defines: PROBE_OURS, PROBE_TRILINEAR, PROBE_ANISOTROPIC or PROBE_FINEST.
#include "surface.glsl"
#include "hatch.glsl"

uniform float probe_spacing_px;

float probe_ink(HwSurface s)
{
#ifndef HW_HATCH_MAP
    return 0.0;
#else
    vec2 at = s.hatch_uv.yx * hw_hatch_info.x;
#if defined(PROBE_OURS)
    return hw_hatch_map_ink(hw_hatch_map, hw_hatch_info, s.hatch_uv.y, vec2(s.hatch_uv_dx.y, s.hatch_uv_dy.y),
                            probe_spacing_px);
#elif defined(PROBE_TRILINEAR)
    return 1.0 - texture(hw_hatch_map, at).r;
#elif defined(PROBE_FINEST)
    return 1.0 - textureLod(hw_hatch_map, at, 0.0).r;
#else  // PROBE_ANISOTROPIC
    // The formula of EXT_texture_filter_anisotropic with 16 samples.
    vec2 size = vec2(hw_hatch_info.z, 1.0);
    vec2 dx = dFdx(at);
    vec2 dy = dFdy(at);
    float along_x = length(dx * size);
    float along_y = length(dy * size);
    float most = max(max(along_x, along_y), 1e-12);
    float count = min(ceil(most / max(min(along_x, along_y), 1e-12)), 16.0);
    float level = log2(most / count);
    vec2 way = along_x > along_y ? dx : dy;
    float paper = 0.0;
    for (float i = 1.0; i <= count; i += 1.0)
        paper += textureLod(hw_hatch_map, at + way * (i / (count + 1.0) - 0.5), level).r;
    return 1.0 - paper / count;
#endif
#endif
}

void main()
{
    HwSurface surface = hw_surface();
    hw_output(vec3(1.0 - probe_ink(surface)), 1.0);
}
