#include "surface.glsl"
#include "hatch.glsl"
#include "halftone.glsl"

// The red of the test's colour is the tone. Priorities rise evenly over the width of the picture.
uniform vec3 flat_colour;

void main()
{
    float priority = gl_FragCoord.x / hw_size_px.x;
    hw_output(vec3(hw_smooth_threshold(priority, flat_colour.r, 8.0)), 1.0);
}
