// Depth alone; an alpha mask cuts holes into the shadow.
#include "surface.glsl"

void main()
{
#ifdef HW_ALPHA_MASK
    hw_material(hw_surface());
#endif
    hw_output(vec3(0.0), 1.0);
}
