// The engine's vertex stage of every pass over objects' faces. Styles bring the fragment stage: see surface.glsl.
#include "frame.glsl"
#include "position.glsl"

in vec3 hw_in_position;
in vec3 hw_in_normal;
out vec3 hw_v_position_object;
out vec3 hw_v_position_relative;  // world, as seen from the eye: keeps its precision far from the origin
out vec3 hw_v_normal_object;
out vec3 hw_v_normal_world;
#ifdef HW_HAS_TANGENTS
in vec4 hw_in_tangent;
out vec4 hw_v_tangent_world;
#endif
#ifdef HW_HAS_UV0
in vec2 hw_in_uv0;
out vec2 hw_v_uv0;
#endif
#ifdef HW_HAS_UV1
in vec2 hw_in_uv1;
out vec2 hw_v_uv1;
#endif
#ifdef HW_HAS_COLOURS
in vec4 hw_in_colour;
out vec4 hw_v_colour;
#endif

#if defined(HW_HAS_HATCH_UV) || defined(HW_HAS_DIRECTION) || defined(HW_HAS_TRIANGLE_ID)
in vec3 hw_in_hatch;  // u, v, vertex of the model
#define HW_VERTEX int(hw_in_hatch.z + 0.5)
#else
#define HW_VERTEX gl_VertexID
#endif
#ifdef HW_HAS_HATCH_UV
out vec2 hw_v_hatch_uv;
#endif
#ifdef HW_HAS_DIRECTION
in vec3 hw_in_direction;
out vec3 hw_v_direction_world;
#endif

#ifdef HW_HAS_TRIANGLE_ID
uniform int hw_first_triangle;  // of the object, through all objects
flat out highp uint hw_v_triangle_id;
#endif

#ifdef HW_LIGHTMAP
#if HW_LIGHTMAP == 1
in vec2 hw_in_lightmap_uv;
out vec2 hw_v_lightmap_uv;
#else
uniform highp sampler2D hw_lightmap;
uniform vec4 hw_lightmap_place;  // luxels: xy the first one, z from the front's to the back's
out vec3 hw_v_baked;
#ifdef HW_DOUBLE_SIDED
out vec3 hw_v_baked_back;
#endif

vec3 hw_vertex_luxel(int further)
{
    int width = textureSize(hw_lightmap, 0).x;
    int at = int(hw_lightmap_place.y) * width + int(hw_lightmap_place.x) + HW_VERTEX + further;
    return texelFetch(hw_lightmap, ivec2(at % width, at / width), 0).rgb;
}
#endif
#endif

uniform mat4 hw_relative_from_object;  // world relative to the eye, from object
uniform mat3 hw_normal_from_object;

// Zero where the model states no direction that can be used.
vec3 hw_unit(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-30)); }

void main()
{
    hw_set_position(hw_in_position);
    hw_v_position_object = hw_in_position;
    hw_v_position_relative = (hw_relative_from_object * vec4(hw_in_position, 1.0)).xyz;
    hw_v_normal_object = hw_in_normal;
    hw_v_normal_world = hw_unit(hw_normal_from_object * hw_in_normal);
#ifdef HW_HAS_TANGENTS
    hw_v_tangent_world = vec4(hw_unit(mat3(hw_relative_from_object) * hw_in_tangent.xyz), hw_in_tangent.w);
#endif
#ifdef HW_HAS_UV0
    hw_v_uv0 = hw_in_uv0;
#endif
#ifdef HW_HAS_UV1
    hw_v_uv1 = hw_in_uv1;
#endif
#ifdef HW_HAS_COLOURS
    hw_v_colour = hw_in_colour;
#endif
#ifdef HW_HAS_HATCH_UV
    hw_v_hatch_uv = hw_in_hatch.xy;
#endif
#ifdef HW_HAS_DIRECTION
    hw_v_direction_world = mat3(hw_relative_from_object) * hw_in_direction;
#endif
#ifdef HW_HAS_TRIANGLE_ID
    hw_v_triangle_id = uint(hw_first_triangle + gl_VertexID / 3) + 1u;
#endif
#ifdef HW_LIGHTMAP
#if HW_LIGHTMAP == 1
    hw_v_lightmap_uv = hw_in_lightmap_uv;
#else
    hw_v_baked = hw_vertex_luxel(0);
#ifdef HW_DOUBLE_SIDED
    hw_v_baked_back = hw_vertex_luxel(int(hw_lightmap_place.z));
#endif
#endif
#endif
}
