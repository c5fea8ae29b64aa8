// The engine's image "object_ids": see shared_images.hpp.
#include "surface.glsl"

uniform vec4 hw_object_id;

void main()
{
#ifdef HW_ALPHA_MASK
    hw_material(hw_surface());
#endif
    hw_fragment = hw_object_id;
}
