// How a hand departs from a ruler. All of it is a function of the place on the object: of the length along the stroke and
// the stroke's seed, and for silhouettes, which are other edges in every view, of the place itself. Bends are as long as
// the look wants them on the screen, taken from the two nearest lengths in powers of two on the object, so that nothing
// slides over it when the eye moves. drawing/stroke_shape.cpp computes the same for vectors, and a test compares them.
// Included by line_pen.glsl.

uniform vec4 hw_stroke_px;    // x stray sideways, y length of a bend, z overshoot, w length of the thin ends
uniform vec2 hw_stroke_dash;  // x dash and gap in pixels, 0: unbroken; y share of the dash
uniform float hw_stroke_scale;  // metres for a unit of the object

float hw_stroke_hash(vec4 at)
{
    uvec4 bits = uvec4(ivec4(at));
    uint h = bits.x * 747796405u + bits.y * 2891336453u + bits.z * 1181783497u + bits.w * 374761393u;
    h ^= h >> 16;
    h *= 2246822519u;
    h ^= h >> 13;
    h *= 3266489917u;
    h ^= h >> 16;
    return float(h & 0xffffffu) / 8388607.5 - 1.0;
}

float hw_stroke_noise(float at, float seed)
{
    float cell = floor(at);
    float f = at - cell;
    vec4 key = vec4(cell, floor(seed * 65536.0), 0.0, 0.0);
    return mix(hw_stroke_hash(key), hw_stroke_hash(key + vec4(1.0, 0.0, 0.0, 0.0)), f * f * (3.0 - 2.0 * f));
}

float hw_stroke_noise(vec3 at, float seed)
{
    vec3 cell = floor(at);
    vec3 f = at - cell;
    f = f * f * (3.0 - 2.0 * f);
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        vec3 corner = vec3(float(i & 1), float((i >> 1) & 1), float(i >> 2));
        vec3 share = mix(1.0 - f, f, corner);
        sum += share.x * share.y * share.z * hw_stroke_hash(vec4(cell + corner, seed));
    }
    return 1.5 * sum;
}

// Share of the second of two lengths: x its logarithm's whole part, y what is left.
vec2 hw_stroke_octave(float px_per_unit)
{
    float octave = log2(max(hw_stroke_px.y, 1.0) / max(px_per_unit, 1e-20));
    return vec2(floor(octave), fract(octave));
}

// Pixels to the side at a length along a stroke.
float hw_stroke_stray(float arc, float seed, float px_per_unit)
{
    vec2 octave = hw_stroke_octave(px_per_unit);
    float fine = exp2(-octave.x);
    return hw_stroke_px.x * mix(hw_stroke_noise(arc * fine, seed), hw_stroke_noise(arc * 0.5 * fine, seed), octave.y);
}

// Pixels in the picture's plane at a place of the object.
vec2 hw_silhouette_stray(vec3 place, float px_per_unit)
{
    vec2 octave = hw_stroke_octave(px_per_unit);
    float fine = exp2(-octave.x);
    vec2 stray;
    for (int axis = 0; axis < 2; ++axis)
        stray[axis] = mix(hw_stroke_noise(place * fine, float(axis)), hw_stroke_noise(place * 0.5 * fine, float(axis)), octave.y);
    return hw_stroke_px.x * stray;
}

// The share of its width that a stroke has near its ends; closed ones have none.
float hw_stroke_taper(float arc, float whole, float px_per_unit)
{
    if (hw_stroke_px.w <= 0.0 || whole <= 0.0) return 1.0;
    float end_px = max(min(arc, whole - arc), 0.0) * px_per_unit;
    return mix(0.3, 1.0, smoothstep(0.0, hw_stroke_px.w, end_px));
}

// A dash with its gap, in the object's units: the power of two nearest to what the look wants on the screen.
float hw_stroke_dash_period(float px_per_unit)
{
    return exp2(floor(log2(hw_stroke_dash.x / max(px_per_unit, 1e-20)) + 0.5));
}

// Where in a dash a place is, in [0, 1).
float hw_stroke_dash_phase(float arc, float seed, float period) { return fract(arc / period + seed); }

// Coverage of a broken line.
float hw_stroke_dash_at(float arc, float seed, float px_per_unit)
{
    float period = hw_stroke_dash_period(px_per_unit);
    float phase = hw_stroke_dash_phase(arc, seed, period);
    float inside_px = min(phase, hw_stroke_dash.y - phase) * period * px_per_unit;
    return clamp(inside_px + 0.5, 0.0, 1.0);
}
