// Ink that keeps its width and its tone on the screen at any distance and angle, and stays on the object. Include after
// surface.glsl. "Ink" is coverage in linear light: 0 paper, 1 ink. Lengths ending in _px are logical pixels.
//
// One idea serves lines, strokes and maps: things stand at multiples of a power of two on the surface, and every octave of
// distance drops each second one. Those thin out while the octave passes, so that tone stays the same all the while.
// Source: Freudenberg, Masuch, Strothotte. Walk-Through Illustrations. Eurographics 2001, section 3.2.

// 0 to 1 from a number that names a line. Exact: positions are multiples of powers of two. Shifts and products that software
// renderers have as one instruction each.
float hw_hash(float key, uint salt)
{
    uint h = floatBitsToUint(key) + salt * 0x9e3779b9u;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    return float(int(h >> 8u)) * (1.0 / 16777216.0);
}

// A power of two from its inverse, another power of two: exact, without a division.
float hw_inverse_of_power(float power) { return uintBitsToFloat(0x7f000000u - floatBitsToUint(power)); }

// The inverse of the largest power of two not above 1 / inverse_wanted: of the distance between two things on the surface
// that suits the screen. `thinning` is what each second thing keeps of its size, from 1 to 0 over the octave:
// 2 cell / wanted - 1 keeps the sum constant, since the spacing on the screen shrinks as wanted / cell grows.
// From 1e-24 to 1e24.
float hw_inverse_octave(float inverse_wanted, out float thinning)
{
    float inverse_cell = uintBitsToFloat((floatBitsToUint(inverse_wanted) + 0x007fffffu) & 0x7f800000u);
    thinning = 2.0 * inverse_wanted * hw_inverse_of_power(inverse_cell) - 1.0;
    return inverse_cell;
}

// The largest power of two not above `wanted`, and the same thinning.
float hw_octave(float wanted, out float thinning)
{
    return hw_inverse_of_power(hw_inverse_octave(1.0 / clamp(wanted, 1e-12, 1e12), thinning));
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

// The hand in inverses of device pixels: x of a stroke's length, y of a gap, z by how much strokes are widened for their
// tapers, which take away three gaps of each, so that tone stays what was asked.
vec3 hw_inverse_hand(HwHand hand)
{
    float inverse_length = 1.0 / max(hand.length_px, 1e-6);
    float inverse_scale = 1.0 / hw_px_scale;
    return vec3(inverse_length * inverse_scale, inverse_scale / max(hand.gap_px, 1e-6),
                1.0 + min(3.0 * hand.gap_px * inverse_length, 0.5));
}

// What strokes of one direction need at a place of the surface.
struct HwStrokes {
    vec2 st;                // across and along the strokes, on the surface, metres
    vec2 squared_m_per_px;  // squared gradients of the two in the picture
    float inverse_spacing;  // of device pixels between two strokes
    float width;            // of a stroke, device pixels, at most the spacing
};

// Ink of parallel strokes; `inverse_hand`: hw_inverse_hand(). What a wide stroke covers of its neighbours' cells counts there,
// so that strokes as wide as their spacing leave no paper; there the hand closes its gaps, too.
float hw_stroke_ink(HwStrokes s, HwHand hand, vec3 inverse_hand)
{
    vec2 px_per_m = vec2(hw_inverse_sqrt(clamp(s.squared_m_per_px.x, 1e-24, 1e24)),
                         hw_inverse_sqrt(clamp(s.squared_m_per_px.y, 1e-24, 1e24)));
    float thinning;
    float inverse_cell = hw_inverse_octave(px_per_m.x * s.inverse_spacing, thinning);
    float cell = hw_inverse_of_power(inverse_cell);
    float index = floor(s.st.x * inverse_cell + 0.5);
    float line = index * cell;
    bool is_thinned = fract(index * 0.5) > 0.25;
    float width = is_thinned ? s.width * thinning : s.width;
    float neighbour_width = is_thinned ? s.width : s.width * thinning;
    float offset = 0.0;
    if (hand.length_px > 0.0) {
        float end_thinning;
        float inverse_piece = hw_inverse_octave(px_per_m.y * inverse_hand.x, end_thinning);
        float random = hw_hash(line, 1u);
        float t = (s.st.y + 64.0 * random) * inverse_piece;
        float end_index = floor(t + 0.5);
        float piece_px = hw_inverse_of_power(inverse_piece) * px_per_m.y;
        float to_end = abs(t - end_index) * piece_px * inverse_hand.y;
        float taper = clamp(to_end * 0.4 - 0.2, 0.0, 1.0);
        taper = fract(end_index * 0.5) > 0.25 ? mix(1.0, taper, end_thinning) : taper;
        float wave = mix(hw_wave(0.35 * t + random), hw_wave(0.7 * t + random), end_thinning);
        float open = clamp(3.0 - 4.0 * s.width * s.inverse_spacing, 0.0, 1.0);
        width *= mix(1.0, taper * inverse_hand.z * (1.0 + hand.pressure * wave), open);
        offset = open * hand.wobble_px * hw_px_scale * wave;
    }
    float away = abs((s.st.x - line) * px_per_m.x + offset);
    return min(hw_line_ink(width, away) + hw_line_ink(neighbour_width, cell * px_per_m.x - away), 1.0);
}

// The same for logical pixels between strokes and the ink coverage `tone`, at most 1.
float hw_strokes(vec2 st, vec2 st_dx, vec2 st_dy, float spacing_px, float tone, HwHand hand)
{
    float spacing = spacing_px * hw_px_scale;
    vec2 squared = st_dx * st_dx + st_dy * st_dy;
    return hw_stroke_ink(HwStrokes(st, squared, 1.0 / spacing, tone * spacing), hand, hw_inverse_hand(hand));
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

// Across and along strokes of this `direction` (unit, right and up on the surface), from coordinates on the surface.
mat2 hw_to_strokes(vec2 direction)
{
    vec2 along = direction * kHwUp;
    vec2 across = vec2(-direction.y, direction.x) * kHwUp;
    return mat2(across.x, along.x, across.y, along.y);
}

// Ink of strokes along `direction` (unit, right and up on the surface).
float hw_strokes_along(HwSurface s, vec2 direction, float spacing_px, float tone, HwHand hand)
{
    mat2 turn = hw_to_strokes(direction);
    return hw_strokes(turn * s.hatch_uv, turn * s.hatch_uv_dx, turn * s.hatch_uv_dy, spacing_px, tone, hand);
}

struct HwHatching {
    float spacing_px;      // between strokes of one direction where it is full
    float width_px;        // of a stroke
    vec2 direction;        // unit, right and up on the surface
    vec2 cross_direction;  // unit
    HwHand hand;
};

// Tonal hatching: `tone` is ink coverage. The first direction carries light tones and half-tones, its strokes wide apart,
// then closer, then twice as wide; the second crosses it in shade, a third in the dark, where strokes grow wider at last.
// So six tones, with everything between them, and a darker tone keeps all strokes of a lighter one.
// A loop that ends when the tone is reached, at the latest with the third direction, which takes all that is left: software
// renderers run both sides of a branch, and the rest of a loop after its condition, but leave a loop at its end when all of
// its pixels have. So the condition stands there, and the count of directions is not in it: such a loop is unrolled.
float hw_tonal_hatching(HwSurface s, HwHatching h, float tone)
{
    float full = clamp(h.width_px / h.spacing_px, 0.02, 0.48);  // ink of a direction whose strokes are closest
    float inverse_full = 1.0 / full;
    float spacing = h.spacing_px * hw_px_scale;
    float inverse_spacing = 1.0 / spacing;
    vec3 inverse_hand = hw_inverse_hand(h.hand);
    vec2 third = h.direction + h.cross_direction;
    third *= hw_inverse_sqrt(max(dot(third, third), 1e-12));
    vec2 squared = s.hatch_uv_dx * s.hatch_uv_dx + s.hatch_uv_dy * s.hatch_uv_dy;
    float mixed = 2.0 * (s.hatch_uv_dx.x * s.hatch_uv_dx.y + s.hatch_uv_dy.x * s.hatch_uv_dy.y);
    float ink = clamp(tone, 0.0, 1.0);  // that is wanted still, of the paper that earlier directions left
    float paper = 1.0;
    vec2 direction = h.direction;
    float most = 2.0 * full;
    float widest = 2.5;
    do {
        float part = min(ink, most);
        float closeness = clamp(part * inverse_full, 1.0 / widest, 1.0);
        float width = spacing * max(min(full, part * widest), part);
        vec2 along = direction * kHwUp;
        vec2 across = vec2(-direction.y, direction.x) * kHwUp;
        float squared_across = dot(across * across, squared) + across.x * across.y * mixed;
        HwStrokes strokes = HwStrokes(vec2(dot(across, s.hatch_uv), dot(along, s.hatch_uv)),
                                      vec2(squared_across, squared.x + squared.y - squared_across),
                                      closeness * inverse_spacing, width);
        float drawn = hw_stroke_ink(strokes, h.hand, inverse_hand);
        paper *= part < 0.004 ? 1.0 : 1.0 - drawn;
        ink = part < most ? 0.0 : (ink - part) / (1.0 - part);
        direction = widest > 2.0 ? h.cross_direction : third;
        most = widest > 2.0 ? full : 2.0;
        widest = 2.0;
    } while (ink >= 0.004);
    return 1.0 - paper;
}

// Ink of a map whose levels its maker drew. The level is chosen here: what the hardware would take depends on its
// filters. Neighbouring levels are blended by the hardware.
float hw_map_ink(sampler2D map, vec2 at, float level) { return 1.0 - textureLod(map, at, level).r; }

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
// follows the direction in which the map is seen shortest, so that strokes never run together; a second sample along that
// direction lets it be one level finer where the map is seen at an angle. `detail` takes levels finer by that much: more and
// thinner strokes. Edges of strokes are one pixel wide, however large a texel is. Nearer than the finest level the drawing
// grows with the object and pales, farther than the coarsest it is an even tone.
float hw_ink_map_ink(sampler2D map, vec4 info, vec2 uv, vec2 dx, vec2 dy, float detail)
{
    vec2 to_map = info.x * vec2(1.0, -1.0 / info.y);
    float texels_per_m = info.x * info.z * hw_px_scale;
    float long_x = dot(dx, dx);
    float long_y = dot(dy, dy);
    vec2 longest = long_x > long_y ? dx : dy;
    float most = clamp(max(long_x, long_y), 1e-24, 1e24);
    float least = clamp(min(long_x, long_y), 1e-24, 1e24);
    float angle = most * hw_inverse_sqrt(most) * hw_inverse_sqrt(least);  // texels seen shortest, of those seen longest
    float finer = clamp(angle, 1.0, 2.0);
    float texels = most * hw_inverse_sqrt(most) * texels_per_m;
    float level = log2(clamp(texels / finer, 1e-12, 1e12)) - detail;
    float grown = clamp(-0.5 * level, 0.0, 1.0);  // 1 where a texel of the finest level covers four pixels
    level = clamp(level, 0.0, info.w - 1.0);
    vec2 at = uv * to_map;
    float ink = 0.0;
    float count = finer > 1.25 ? 2.0 : 1.0;
    vec2 apart = clamp(angle - 1.25, 0.0, 0.25) * longest * to_map;
    for (float i = 0.0; i < count; i += 1.0) ink += hw_map_ink(map, at + (2.0 * i - 1.0) * apart, level);
    ink /= count;
    float texel_px = exp2(level) * sqrt(angle) * hw_px_scale / max(texels, 1e-12);
    float edge = mix(0.5 / clamp(texel_px, 1.0, 32.0), 0.5, clamp(level - info.w + 5.0, 0.0, 1.0));
    return (1.0 - 0.5 * grown) * clamp((ink - 0.5 - 0.23 * grown) / (2.0 * edge) + 0.5, 0.0, 1.0);
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
