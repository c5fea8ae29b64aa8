// The image "triangle_ids": the number of the triangle through all objects, from 1 on; 0 where nothing is.
#define HW_OWN_OUTPUTS
#include "surface.glsl"

layout(location = 0) out uint id;

void main()
{
    HwSurface surface = hw_surface();
#ifdef HW_ALPHA_MASK
    hw_material(surface);
#endif
    id = surface.triangle_id;
}
