// The engine's pen.
#include "line_pen.glsl"

void main()
{
    HwLine line = hw_line();
    hw_output(line.colour, line.coverage);
}
