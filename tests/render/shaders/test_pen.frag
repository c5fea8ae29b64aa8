#include "line_pen.glsl"

#ifdef PEN_IN_COLOUR
uniform vec3 pen_colour;
#endif

void main()
{
    HwLine line = hw_line();
#ifdef PEN_IN_COLOUR
    // Which class, how far along, and which side.
    float green = line.line_class == 3 ? 1.0 : 0.0;
    hw_output(vec3(pen_colour.r, green, fract(line.length_object_m)), line.coverage);
#else
    hw_output(line.colour, line.coverage);
#endif
}
