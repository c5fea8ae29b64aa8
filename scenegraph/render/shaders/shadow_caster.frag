// Depth alone: shadow maps, and faces before they are shaded. An alpha mask cuts holes.
#include "surface.glsl"

void main()
{
#ifdef HW_ALPHA_MASK
    hw_material(hw_surface());
#endif
    hw_output(vec3(0.0), 1.0);
}
