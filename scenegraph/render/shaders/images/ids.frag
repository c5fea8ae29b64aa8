// The images "object_ids" and, by IDS_OF_TRIANGLES, "triangle_ids": the number of the object, or that of the triangle through
// all objects, from 1 on; 0 where nothing is. IDS_WITH_PLANES: the plane of the triangle, too.
#define HW_OWN_OUTPUTS
#include "surface.glsl"

layout(location = 0) out uint id;
#ifdef IDS_WITH_PLANES
layout(location = 1) out vec4 plane;
#endif

void main()
{
    HwSurface surface = hw_surface();
#ifdef HW_ALPHA_MASK
    hw_material(surface);
#endif
#ifdef IDS_OF_TRIANGLES
    id = surface.triangle_id;
#else
    id = surface.object_id;
#endif
#ifdef IDS_WITH_PLANES
    float depth_m = -(mat3(hw_view_from_world) * hw_v_position_relative).z;
    // Both are straight on a triangle, so the differences to the next pixels hold for all of its plane.
    float nearness = hw_is_parallel ? -depth_m : gl_FragCoord.w;
    plane = vec4(nearness, dFdx(nearness), dFdy(nearness), depth_m);
#endif
}
