// Halftone hatching by a smooth threshold over a map of priorities. Include after hatch.glsl.
// Source: Freudenberg, Masuch, Strothotte. Real-Time Halftoning: A Primitive For Non-Photorealistic Shading. Eurographics
// Workshop on Rendering 2002.

// Ink where a stroke's priority (0 to 1) lies above what the tone leaves white, with an edge 1 / sharpness wide. Over priorities
// that are spread evenly the mean is the tone, also at its ends, where half of the edge finds no priorities: tone 0 has no ink
// at all, tone 1 no paper.
float hw_smooth_threshold(float priority, float tone, float sharpness)
{
    float edge = 0.5 / sharpness;
    float ink = clamp(tone, 0.0, 1.0);
    float threshold = 1.0 - ink;
    if (ink < edge) threshold = 1.0 + edge - 2.0 * sqrt(edge * ink);
    if (ink > 1.0 - edge) threshold = 2.0 * sqrt(edge * (1.0 - ink)) - edge;
    return clamp((priority - threshold) * sharpness + 0.5, 0.0, 1.0);
}

// Ink of a priority map at `uv` metres, right and up; dx and dy its derivatives in the picture; `info`: hw_tonal_info of a map
// with one tone. The inks of the two levels beside the screen's scale are blended, never their priorities, which would no
// longer be spread evenly. Farther than where levels still have room for strokes the map is scaled by octaves.
float hw_halftone_ink(sampler2D map, vec4 info, vec2 uv, vec2 dx, vec2 dy, float tone)
{
    const float kSharpness = 8.0;
    const float kSpread = 1.1;      // blending neighbouring texels draws priorities together
    const float kRoomTexels = 6.0;  // log2 of the narrowest level whose strokes look like strokes
    float texels = sqrt(max(dot(dx, dx), dot(dy, dy))) * info.x * info.z * hw_px_scale;
    float level = max(log2(clamp(texels, 1e-12, 1e12)), 0.0);
    float near_level = floor(level);
    float coarsest = floor(max(log2(info.z) - kRoomTexels, 0.0));
    float near_octave = max(near_level - coarsest, 0.0);
    float far_octave = max(near_level + 1.0 - coarsest, 0.0);
    vec2 at = uv * info.x * vec2(1.0, -1.0);
    vec2 priorities = vec2(hw_map_ink(map, at * exp2(-near_octave), near_level - near_octave),
                           hw_map_ink(map, at * exp2(-far_octave), near_level + 1.0 - far_octave));
    priorities = clamp(0.5 + kSpread * (priorities - 0.5), 0.0, 1.0);
    return mix(hw_smooth_threshold(priorities.x, tone, kSharpness), hw_smooth_threshold(priorities.y, tone, kSharpness),
               level - near_level);
}
