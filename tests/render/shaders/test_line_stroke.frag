#include "full_screen.glsl"
#include "lines/line_stroke.glsl"
#include "test_inputs.glsl"

// Stray and taper of strokes; with SHOWS_DASHES period, phase and coverage of dashes.
void main()
{
    float px_per_unit = 2.0 + 400.0 * test_pick(0) * test_pick(1);
    float whole = 0.05 + 8.0 * test_pick(2);
    float arc = whole * test_pick(3);
    float seed = floor(65536.0 * test_pick(4)) / 65536.0;
#ifdef SHOWS_DASHES
    float period = hw_stroke_dash_period(px_per_unit);
    float coverage = hw_stroke_dash_at(arc, seed, px_per_unit);
    hw_fragment = vec4(period, hw_stroke_dash_phase(arc, seed, period), coverage, 0.0);
#else
    vec3 place = 20.0 * vec3(test_pick(5), test_pick(6), test_pick(7)) - 10.0;
    if (test_pick(8) < 0.2) whole = -whole;
    vec2 aside = hw_silhouette_stray(place, px_per_unit);
    hw_fragment = vec4(hw_stroke_stray(arc, seed, px_per_unit), aside, hw_stroke_taper(arc, whole, px_per_unit));
#endif
}
