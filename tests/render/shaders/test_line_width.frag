#include "full_screen.glsl"
#include "lines/line_width.glsl"
#include "test_inputs.glsl"

vec3 test_direction(int number) { return 2.0 * vec3(test_pick(number), test_pick(number + 1), test_pick(number + 2)) - 1.0; }

void main()
{
    int line_class = int(test_pick(0) * 6.0);
    float fold = 3.2 * test_pick(1);
    float distance_m = 0.05 + 300.0 * test_pick(2) * test_pick(3);
    float px_per_m = 700.0 / distance_m;
    vec4 crowding = vec4(3.0 * test_pick(4));
    crowding.yzw += vec3(2.5 * test_pick(5));
    crowding.zw += vec2(2.5 * test_pick(6));
    crowding.w += 2.5 * test_pick(7);
    float inside = hw_line_insideness(test_direction(8), test_direction(11), 40.0 * test_direction(14));
    hw_fragment = vec4(hw_line_width(line_class, fold, distance_m, px_per_m, crowding, inside));
}
