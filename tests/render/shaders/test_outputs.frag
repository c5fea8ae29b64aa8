// The object's number, and a colour.
#define HW_OWN_OUTPUTS
#include "surface.glsl"

layout(location = 0) out uvec2 ids;
layout(location = 1) out vec4 colour;

void main()
{
    HwSurface surface = hw_surface();
    ids = uvec2(surface.object_id, surface.triangle_id);
    colour = vec4(0.0, 1.0, 0.0, 1.0);
}
