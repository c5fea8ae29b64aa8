// The image "normal_depth": unit normal towards the eye (world space), depth along the view in metres; 0 where nothing is.
#include "surface.glsl"

void main()
{
    HwSurface surface = hw_surface();
#ifdef HW_ALPHA_MASK
    hw_material(surface);
#endif
    float depth_m = -(mat3(hw_view_from_world) * hw_v_position_relative).z;
    vec3 normal = dot(surface.normal_world, surface.to_eye_world) < 0.0 ? -surface.normal_world : surface.normal_world;
    hw_fragment = vec4(normal, depth_m);
}
