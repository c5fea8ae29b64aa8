// Shows the edge map alone: R edges of normals, G edges of depth.
#include "surface.glsl"

uniform sampler2D edges;

void main()
{
    hw_output(vec3(texture(edges, gl_FragCoord.xy / hw_size_px).rg, 1.0), 1.0);
}
