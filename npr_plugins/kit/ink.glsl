// The drawing of one surface in pen and ink, shared by styles that draw in ink. Include after hatch.glsl and lighting.glsl.
// Defines of the program: TONE_PLAIN (even hatching by the hatch map) or TONE_SHADED (hatching by light and shadow),
// with TONE_HALFTONE by a priority map;
// MATERIAL_COLOUR (paper or ink take colour from the material).

uniform vec4 hatch_size_px;      // spacing, stroke width, stroke length, wobble: logical pixels
uniform vec4 hatch_directions;   // xy the first, zw the crossing direction: unit, right and up on the surface
uniform vec4 tone_range;         // darkness, white from, shadow below, share of the material's tone
uniform vec3 paper_colour;       // linear, as all colours here
uniform vec3 ink_colour;
uniform vec3 uncertain_colour;
uniform vec2 from_material;      // share of the material's colour in the paper's and in the ink's; with MATERIAL_COLOUR
uniform float shade;
uniform float light_response;    // 0: the mean tone everywhere, 1: as light falls
uniform vec4 ink_fade;           // how much hatching has faded: see hw_share_at()
uniform vec2 ink_map_look;         // strength, and how much finer than one texel a pixel

// Ink coverage that light of this tone (0 to 1) asks for on this material. Straight from the light: a curve that is flat at
// white would lose cast shadows on lit ground, the lightest shade there is. A hand leaves the lightest tones to the paper,
// and its first strokes are strokes at once: so light ends at an edge, and not in a haze of hairlines.
float hw_ink_of_light(float light)
{
    float lit = mix(0.5, clamp((light - tone_range.z) / max(tone_range.y - tone_range.z, 1e-3), 0.0, 1.0), light_response);
    float albedo = sqrt(clamp(hw_luminance(hw_mean_colour), 0.0, 1.0));
    float white = mix(1.0, min(albedo * 1.4, 1.0), tone_range.w);
    float ink = tone_range.x * (1.0 - lit * white);
    return ink * smoothstep(0.04, 0.085, ink);
}

float hw_hatching(HwSurface surface, float light)
{
#if defined(TONE_HALFTONE) && defined(HW_TONAL_MAP)
    mat2 turn_map = mat2(hatch_directions.x, -hatch_directions.y, hatch_directions.y, hatch_directions.x);
    return hw_halftone_ink(hw_tonal_map, hw_tonal_info, turn_map * (surface.hatch_uv * kHwUp),
                           turn_map * (surface.hatch_uv_dx * kHwUp), turn_map * (surface.hatch_uv_dy * kHwUp),
                           hw_ink_of_light(light));
#elif defined(TONE_SHADED) && defined(HW_TONAL_MAP)
    vec2 right = hatch_directions.xy;
    mat2 turn = mat2(right.x, -right.y, right.y, right.x);
    return hw_tonal_map_ink(hw_tonal_map, hw_tonal_info, turn * (surface.hatch_uv * kHwUp),
                            turn * (surface.hatch_uv_dx * kHwUp), turn * (surface.hatch_uv_dy * kHwUp),
                            hw_ink_of_light(light));
#elif defined(TONE_SHADED)
    HwHand hand = HwHand(hatch_size_px.z, 2.0, hatch_size_px.w, 0.18);
    HwHatching hatching = HwHatching(hatch_size_px.x, hatch_size_px.y, hatch_directions.xy, hatch_directions.zw, hand);
    return hw_tonal_hatching(surface, hatching, hw_ink_of_light(light));
#else
#if defined(TONE_PLAIN) && defined(HW_HATCH_MAP)
    vec2 across = vec2(-hatch_directions.y, hatch_directions.x) * kHwUp;
    float u = dot(surface.hatch_uv, across);
    vec2 u_d = vec2(dot(surface.hatch_uv_dx, across), dot(surface.hatch_uv_dy, across));
    return hw_hatch_map_ink(hw_hatch_map, hw_hatch_info, u, u_d, hatch_size_px.x);
#else
    return 0.0;
#endif
#endif
}

float hw_ink_map_detail(HwSurface surface)
{
#ifdef HW_INK_MAP
    return ink_map_look.x * hw_ink_map_ink(hw_ink_map, hw_ink_info, surface.map_uv * kHwMapUp,
                                             surface.map_uv_dx * kHwMapUp, surface.map_uv_dy * kHwMapUp, ink_map_look.y);
#else
    return 0.0;
#endif
}

// The colour of the drawing here, linear.
vec3 hw_pen_and_ink(HwSurface surface, HwMaterial material)
{
    float light = 1.0;
#ifdef TONE_SHADED
    light = hw_light_tone(surface, surface.normal_world);
#else
    if (shade > 0.0) light = hw_light_tone(surface, surface.normal_world);
#endif
    vec3 paper = mix(uncertain_colour, paper_colour, hw_certainty);
    vec3 ink = ink_colour;
    float unfaded = 1.0 - hw_share_at(ink_fade, surface.position_world.y);
#ifdef MATERIAL_COLOUR
    paper = mix(paper, material.base_colour, from_material.x * unfaded);
    ink = mix(ink, 0.35 * material.base_colour, from_material.y);
#endif
    paper *= mix(1.0, 0.25 + 0.75 * light * light, shade);
    float coverage = 1.0 - (1.0 - hw_hatching(surface, light)) * (1.0 - hw_ink_map_detail(surface));
    return mix(paper, ink, coverage * unfaded);
}
