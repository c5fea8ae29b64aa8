// The engine's image "object_ids": see shared_images.hpp. image_ids.glsl reads it.
#include "surface.glsl"

uniform vec4 hw_object_id;

void main()
{
#ifdef HW_ALPHA_MASK
    hw_material(hw_surface());
#endif
    hw_fragment = hw_object_id;
}
