// Ink that keeps its width and its tone on the screen at any distance and angle, and stays on the object. Include after
// surface.glsl. "Ink" is coverage in linear light: 0 paper, 1 ink. Lengths ending in _px are logical pixels.
//
// One idea serves lines, strokes and maps: things stand at multiples of a power of two on the surface, and every octave of
// distance drops each second one. Those thin out while the octave passes, so that tone stays the same all the while.
// Source: Freudenberg, Masuch, Strothotte. Walk-Through Illustrations. Eurographics 2001, section 3.2.

// 0 to 1 from a number that names a line. Exact: positions are multiples of powers of two.
float hw_hash(float key, uint salt)
{
    uint h = (key == 0.0 ? 0u : floatBitsToUint(key)) + salt * 0x9e3779b9u;
    h = h * 747796405u + 2891336453u;
    h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
    return float(((h >> 22u) ^ h) >> 8u) * (1.0 / 16777216.0);
}

// The largest power of two not above `wanted`, the distance between two things on the surface that suits the screen.
// `thinning` is what each second thing keeps of its size, from 1 to 0 over the octave: 2 cell / wanted - 1 keeps the sum
// constant, since the spacing on the screen shrinks as wanted / cell grows.
float hw_octave(float wanted, out float thinning)
{
    float safe = clamp(wanted, 1e-12, 1e12);
    float cell = uintBitsToFloat(floatBitsToUint(safe) & 0x7f800000u);
    thinning = 2.0 * cell / safe - 1.0;
    return cell;
}

// Ink of a line `width` device pixels wide whose middle is `distance` device pixels away: a box filter one pixel wide.
float hw_line_ink(float width, float distance) { return clamp(0.5 * width + 0.5 - distance, 0.0, min(width, 1.0)); }

// How a hand draws strokes. All 0: ruled lines without end.
struct HwHand {
    float length_px;  // of a stroke; 0: endless
    float gap_px;     // between two strokes of a line
    float wobble_px;  // sideways
    float pressure;   // 0 to 1, change of width along the stroke
};

// A smooth wave of period 1 in [-1, 1], cheaper than a sine.
float hw_wave(float x)
{
    float t = 2.0 * fract(x) - 1.0;
    return 4.0 * t * (1.0 - abs(t));
}

// Ink of parallel strokes. `st`: across and along the strokes, on the surface, metres; st_dx and st_dy its derivatives in the
// picture. `tone` is the ink coverage that is wanted, at most 1.
float hw_strokes(vec2 st, vec2 st_dx, vec2 st_dy, float spacing_px, float tone, HwHand hand)
{
    float across = max(length(vec2(st_dx.x, st_dy.x)), 1e-12);  // metres per device pixel
    float thinning;
    float cell = hw_octave(spacing_px * hw_px_scale * across, thinning);
    float index = floor(st.x / cell + 0.5);
    float line = index * cell;
    float width = tone * spacing_px * hw_px_scale * (fract(index * 0.5) > 0.25 ? thinning : 1.0);
    float offset = 0.0;
    if (hand.length_px > 0.0) {
        float along = max(length(vec2(st_dx.y, st_dy.y)), 1e-12);
        float end_thinning;
        float piece = hw_octave(hand.length_px * hw_px_scale * along, end_thinning);
        float random = hw_hash(line, 1u);
        float t = st.y / piece + 64.0 * random / piece;
        float end_index = floor(t + 0.5);
        float to_end = abs(t - end_index) * piece / (along * hw_px_scale * hand.gap_px);
        float taper = clamp(to_end * 0.4 - 0.2, 0.0, 1.0);
        taper = fract(end_index * 0.5) > 0.25 ? mix(1.0, taper, end_thinning) : taper;
        float wave = mix(hw_wave(0.35 * t + random), hw_wave(0.7 * t + random), end_thinning);
        // Tapers take away three gaps of each stroke; as width they are given back, so that tone stays what was asked.
        width *= taper * (1.0 + min(3.0 * hand.gap_px / hand.length_px, 0.5)) * (1.0 + hand.pressure * wave);
        offset = hand.wobble_px * hw_px_scale * wave;
    }
    return hw_line_ink(width, abs((st.x - line) / across + offset));
}

// The model's texture coordinates run downwards, made ones upwards.
#ifdef HW_HAS_UV0
const vec2 kHwMapUp = vec2(1.0, -1.0);
#else
const vec2 kHwMapUp = vec2(1.0, 1.0);
#endif
#ifdef HW_HAS_HATCH_UV
const vec2 kHwUp = vec2(1.0, 1.0);
#else
const vec2 kHwUp = kHwMapUp;
#endif

// Ink of strokes along `direction` (unit, right and up on the surface).
float hw_strokes_along(HwSurface s, vec2 direction, float spacing_px, float tone, HwHand hand)
{
    vec2 along = direction * kHwUp;
    vec2 across = vec2(-direction.y, direction.x) * kHwUp;
    return hw_strokes(vec2(dot(s.hatch_uv, across), dot(s.hatch_uv, along)),
                      vec2(dot(s.hatch_uv_dx, across), dot(s.hatch_uv_dx, along)),
                      vec2(dot(s.hatch_uv_dy, across), dot(s.hatch_uv_dy, along)), spacing_px, tone, hand);
}

struct HwHatching {
    float spacing_px;      // between strokes of one direction where it is full
    float width_px;        // of a stroke
    vec2 direction;        // unit, right and up on the surface
    vec2 cross_direction;  // unit
    HwHand hand;
};

// Tonal hatching: `tone` is ink coverage. The first direction carries light tones, its strokes wide apart, then closer; the
// second crosses it in half-tones, a third in the dark, where strokes grow wider at last. So six tones, with everything
// between them, and a darker tone keeps all strokes of a lighter one.
float hw_tonal_hatching(HwSurface s, HwHatching h, float tone)
{
    float full = clamp(h.width_px / h.spacing_px, 0.02, 0.9);  // ink of a direction whose strokes are closest
    float wanted = 1.0 - clamp(tone, 0.0, 0.98);               // paper that stays
    float ink = 1.0 - wanted;
    if (ink < 0.004) return 0.0;
    float first = min(ink, full);
    float paper = 1.0 - hw_strokes_along(s, h.direction, h.spacing_px * clamp(full / first, 1.0, 2.5), first, h.hand);
    float mean = 1.0 - first;
    ink = 1.0 - wanted / mean;
    if (ink < 0.004) return 1.0 - paper;
    float second = min(ink, full);
    float spacing = h.spacing_px * clamp(full / second, 1.0, 2.0);
    paper *= 1.0 - hw_strokes_along(s, h.cross_direction, spacing, second, h.hand);
    mean *= 1.0 - second;
    ink = 1.0 - wanted / mean;
    if (ink < 0.004) return 1.0 - paper;
    spacing = h.spacing_px * clamp(full / ink, 1.0, 2.0);
    return 1.0 - paper * (1.0 - hw_strokes_along(s, normalize(h.direction + h.cross_direction), spacing, ink, h.hand));
}

// Ink of a map, blended between the two levels nearest to `level`. Each level was drawn by its maker, so levels are chosen
// here: what the hardware would take depends on its filters.
float hw_map_ink(sampler2D map, vec2 at, float level)
{
    float finer = floor(level);
    float paper = mix(textureLod(map, at, finer).r, textureLod(map, at, finer + 1.0).r, level - finer);
    return 1.0 - paper;
}

// Ink of a hatch map along `u` metres; `u_d`: its derivatives in the picture; `info`: hw_hatch_info. Every level holds lines
// equally many texels apart. Nearer than the finest level and farther than the coarsest that still separates lines, the
// map is scaled by octaves: lines of the next octave lie exactly on each second one, so that nothing shows.
float hw_hatch_map_ink(sampler2D map, vec4 info, float u, vec2 u_d, float spacing_px)
{
    float texel_px = spacing_px * hw_px_scale / info.y;
    float level = log2(clamp(length(u_d), 1e-12, 1e12) * texel_px * info.z * info.x);
    float coarsest = clamp(log2(info.z / info.y) - 2.0, 0.0, max(info.w - 2.0, 0.0));
    float shift = floor(level) - clamp(floor(level), 0.0, floor(coarsest));
    return hw_map_ink(map, vec2(fract(u * exp2(-shift) * info.x), 0.5), level - shift);
}

// Ink of a 2-D map at `uv` metres, right and up; dx and dy its derivatives in the picture; `info`: hw_ink_info. The level
// follows the direction in which the map is seen shortest, so that strokes never run together; two samples along that
// direction let it be one level finer. `detail` takes levels finer by that much: more and thinner strokes. Edges of strokes
// are one pixel wide, however large a texel is. Nearer than the finest level the drawing grows with the object and pales,
// farther than the coarsest it is an even tone.
float hw_ink_map_ink(sampler2D map, vec4 info, vec2 uv, vec2 dx, vec2 dy, float detail)
{
    vec2 to_map = info.x * vec2(1.0, -1.0 / info.y);
    float texels_per_m = info.x * info.z;
    float long_x = dot(dx, dx);
    float long_y = dot(dy, dy);
    vec2 longest = long_x > long_y ? dx : dy;
    float texels = sqrt(max(long_x, long_y)) * texels_per_m;
    float texels_across = sqrt(min(long_x, long_y)) * texels_per_m;
    float finer = clamp(texels / max(texels_across, 1e-12), 1.0, 2.0);  // 2 where the map is seen at an angle
    float level = log2(clamp(texels / finer * hw_px_scale, 1e-12, 1e12)) - detail;
    float grown = clamp(-0.5 * level, 0.0, 1.0);  // 1 where a texel of the finest level covers four pixels
    level = clamp(level, 0.0, info.w - 1.0);
    vec2 apart = 0.25 * longest * to_map;
    float ink = 0.5 * (hw_map_ink(map, uv * to_map - apart, level) + hw_map_ink(map, uv * to_map + apart, level));
    float texel_px = exp2(level) / max(sqrt(texels * texels_across), 1e-12);
    float edge = mix(0.5 / clamp(texel_px, 1.0, 4.0), 0.5, clamp(level - info.w + 5.0, 0.0, 1.0));
    return (1.0 - 0.5 * grown) * clamp((ink - 0.5 - 0.35 * grown) / (2.0 * edge) + 0.5, 0.0, 1.0);
}

// Ink of a tonal map at `uv` metres, right and up, for the ink coverage `tone`: the two tones beside it and the two levels
// nearest to the screen's scale are blended. `info`: hw_tonal_info. Darker tones hold all strokes of lighter ones, finer
// levels those of coarser ones, so that blending only adds strokes.
float hw_tonal_map_ink(sampler2D map, vec4 info, vec2 uv, vec2 dx, vec2 dy, float tone)
{
    float width = info.z / info.y;  // texels of one tone
    float texels = sqrt(max(dot(dx, dx), dot(dy, dy))) * info.x * width * hw_px_scale;
    float level = clamp(log2(clamp(texels, 1e-12, 1e12)), 0.0, info.w - 1.0);
    float inset = min(0.5 * exp2(ceil(level)) / width, 0.5);  // half a texel: neighbouring tones stay out of the filter
    vec2 at = clamp(fract(uv * info.x * vec2(1.0, -1.0)), inset, 1.0 - inset);
    float index = clamp(tone, 0.0, 1.0) * info.y - 1.0;
    float lighter = floor(index);
    float darker = min(lighter + 1.0, info.y - 1.0);
    float dark_ink = hw_map_ink(map, vec2((darker + at.x) / info.y, at.y), level);
    float light_ink = hw_map_ink(map, vec2((max(lighter, 0.0) + at.x) / info.y, at.y), level);
    return mix(lighter < 0.0 ? 0.0 : light_ink, dark_ink, index - lighter);
}
