// Halftone hatching by a smooth threshold over a map of priorities. Include after hatch.glsl.
// Source: Freudenberg, Masuch, Strothotte. Real-Time Halftoning: A Primitive For Non-Photorealistic Shading. Eurographics
// Workshop on Rendering 2002.

// Ink where a stroke's priority (0 to 1) lies above what the tone leaves white, with an edge 1 / sharpness wide. Tone 0 has no
// ink at all, tone 1 no paper. Priorities that are spread evenly over 0 to 1 give the tone as their mean.
float hw_smooth_threshold(float priority, float tone, float sharpness)
{
    float edge = 0.5 / sharpness;
    float threshold = mix(1.0 + edge, -edge, clamp(tone, 0.0, 1.0));
    return clamp((priority - threshold) * sharpness + 0.5, 0.0, 1.0);
}

// Ink of a priority map at `uv` metres, right and up; dx and dy its derivatives in the picture; `info`: hw_tonal_info of a map
// with one tone. Levels whose strokes would run together are even: there the tone itself is shown.
float hw_halftone_ink(sampler2D map, vec4 info, vec2 uv, vec2 dx, vec2 dy, float tone)
{
    const float kSharpness = 8.0;
    const float kSmallestTexels = 4.0;  // log2 of the narrowest level that has strokes
    float texels = sqrt(max(dot(dx, dx), dot(dy, dy))) * info.x * info.z * hw_px_scale;
    float level = clamp(log2(clamp(texels, 1e-12, 1e12)), 0.0, info.w - 1.0);
    float priority = hw_map_ink(map, uv * info.x * vec2(1.0, -1.0), level);
    float is_even = clamp(level - log2(info.z) + kSmallestTexels + 1.0, 0.0, 1.0);
    return mix(hw_smooth_threshold(priority, tone, kSharpness), clamp(tone, 0.0, 1.0), is_even);
}
