// The image "object_ids": the number of the object, from 1 on; 0 where nothing is.
#define HW_OWN_OUTPUTS
#include "surface.glsl"

layout(location = 0) out uint id;

void main()
{
    HwSurface surface = hw_surface();
#ifdef HW_ALPHA_MASK
    hw_material(surface);
#endif
    id = surface.object_id;
}
