#include "line_pen.glsl"

uniform float grain_m;

float hash(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }

// Smooth noise in [0, 1].
float noise(vec2 p)
{
    vec2 cell = floor(p);
    vec2 f = smoothstep(0.0, 1.0, p - cell);
    vec2 low = vec2(hash(cell), hash(cell + vec2(1.0, 0.0)));
    vec2 high = vec2(hash(cell + vec2(0.0, 1.0)), hash(cell + vec2(1.0)));
    vec2 row = mix(low, high, f.y);
    return mix(row.x, row.y, f.x);
}

void main()
{
    HwLine line = hw_line();
    // Silhouettes have no length of their own: the place on the object stands for it.
    float along_m = line.line_class == 0 ? dot(line.position_object, vec3(1.0)) : line.length_object_m;
    float grain = noise(vec2(along_m / grain_m, 3.0 * line.across + 100.0 * line.seed));
    float pressure = 1.0 - line.across * line.across;
    hw_output(line.colour, line.coverage * smoothstep(0.1, 0.6, grain + 0.5 * pressure - 0.25));
}
