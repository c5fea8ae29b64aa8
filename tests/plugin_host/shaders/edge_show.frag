// Shows the edge map alone: R edges of normals, G edges of depth.
#include "surface.glsl"

uniform sampler2D edges;

void main()
{
    hw_output(texture(edges, gl_FragCoord.xy / hw_size_px).rgb, 1.0);
}
