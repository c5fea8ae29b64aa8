// The image "normal_depth": unit normal of the side that is seen (world space), depth along the view in metres; 0 where nothing
// is. As bytes: see normal_depth.glsl.
#include "surface.glsl"

#ifdef NORMAL_DEPTH_BYTES
uniform vec2 depth_range_m;
#endif

void main()
{
    HwSurface surface = hw_surface();
    vec3 normal = surface.normal_world;
#if defined(HW_ALPHA_MASK) || defined(NORMAL_SHADING)
    HwMaterial material = hw_material(surface);
#endif
#if defined(NORMAL_FACE)
    if (dot(surface.face_normal_world, surface.face_normal_world) > 0.0) normal = surface.face_normal_world;
#elif defined(NORMAL_SHADING)
    normal = material.normal_world;
#endif
    // By the face: beside a silhouette an interpolated normal may look away a little, and must not jump to the other side.
    if (dot(normal, surface.face_normal_world) < 0.0) normal = -normal;
    float depth_m = -(mat3(hw_view_from_world) * hw_v_position_relative).z;
#ifdef NORMAL_DEPTH_BYTES
    float depth = (depth_m - depth_range_m.x) / (depth_range_m.y - depth_range_m.x);
    hw_fragment = vec4(0.5 * normal + 0.5, depth);
#else
    hw_fragment = vec4(normal, depth_m);
#endif
}
