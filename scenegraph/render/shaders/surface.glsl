// The fragment side of passes over objects' faces. A style's fragment shader includes this file, then:
//
//     void main()
//     {
//         HwSurface surface = hw_surface();
//         HwMaterial material = hw_material(surface);      // discards what an alpha mask cuts out
//         hw_output(material.base_colour, material.alpha * hw_presence(surface));
//     }
//
// For Pass::render() into several outputs or whole numbers, write #define HW_OWN_OUTPUTS before the include and declare
// `layout(location = 0) out ...` yourself.
//
// The host compiles a program once for each combination of material features that the scene has, by defines:
//   HW_HAS_UV0 HW_HAS_UV1 HW_HAS_TANGENTS HW_HAS_COLOURS          vertex streams of the mesh
//   HW_HAS_HATCH_UV HW_HAS_DIRECTION HW_HAS_TRIANGLE_ID           streams that the style asked for
//   HW_BASE_COLOUR_MAP HW_METALLIC_ROUGHNESS_MAP HW_NORMAL_MAP HW_OCCLUSION_MAP HW_EMISSIVE_MAP   textures of the material
//   HW_ALPHA_MASK HW_ALPHA_BLEND HW_DOUBLE_SIDED HW_UNLIT          other features of the material
//   HW_HATCH_MAP HW_INK_MAP HW_TONAL_MAP HW_RAMP_MAP HW_IMAGE_MAP  the object has a map of that kind: hw_hatch_map ...
//   HW_PRESENCE                                                    presence is not 1 everywhere
//   HW_SHADOW                                                      the main light has a shadow map (shadow.glsl)
//   HW_LIGHTMAP                                                    the object has baked light (baked.glsl)
//   HW_LIGHT_COUNT n HW_SUN_COUNT n                                always: lights of the scene, 0 to 8; suns are the first
//   HW_SPOT_LIGHTS HW_LIGHT_RANGES                                 some light has a cone, or a range
//   HW_PARALLEL                                                    the view is a parallel projection
#include "frame.glsl"
#include "fast_math.glsl"
#include "presence.glsl"

#ifndef HW_OWN_OUTPUTS
layout(location = 0) out vec4 hw_fragment;
#endif

in vec3 hw_v_position_object;
in vec3 hw_v_position_relative;
in vec3 hw_v_normal_object;
in vec3 hw_v_normal_world;
#ifdef HW_HAS_TANGENTS
in vec4 hw_v_tangent_world;
#endif
#ifdef HW_HAS_UV0
in vec2 hw_v_uv0;
#endif
#ifdef HW_HAS_UV1
in vec2 hw_v_uv1;
#endif
#ifdef HW_HAS_COLOURS
in vec4 hw_v_colour;
#endif
#ifdef HW_HAS_HATCH_UV
in vec2 hw_v_hatch_uv;
#endif
#ifdef HW_HAS_DIRECTION
in vec3 hw_v_direction_world;
#endif
#ifdef HW_HAS_TRIANGLE_ID
flat in highp uint hw_v_triangle_id;
#endif

uniform int hw_object_id;           // from 1 on
uniform float hw_certainty;         // of the level, in [0, 1]
uniform float hw_handedness;        // -1 where the transform mirrors, else 1
uniform vec2 hw_hatch_scale;        // metres per unit of uv0, and per unit of object space
uniform vec4 hw_base_colour_factor;
uniform vec3 hw_mean_colour;        // of the base colour and its map, linear
uniform vec4 hw_material_factors;   // metallic, roughness, alpha cutoff, occlusion strength
uniform vec4 hw_emissive_normal;    // emissive rgb, normal scale
#ifdef HW_BASE_COLOUR_MAP
uniform sampler2D hw_base_colour_map;
uniform mat3 hw_base_colour_uv;
#endif
#ifdef HW_METALLIC_ROUGHNESS_MAP
uniform sampler2D hw_metallic_roughness_map;
uniform mat3 hw_metallic_roughness_uv;
#endif
#ifdef HW_NORMAL_MAP
uniform sampler2D hw_normal_map;
uniform mat3 hw_normal_uv;
#endif
#ifdef HW_OCCLUSION_MAP
uniform sampler2D hw_occlusion_map;
uniform mat3 hw_occlusion_uv;
#endif
#ifdef HW_EMISSIVE_MAP
uniform sampler2D hw_emissive_map;
uniform mat3 hw_emissive_uv;
#endif
#ifdef HW_HATCH_MAP
uniform sampler2D hw_hatch_map;  // R: 0 ink, 1 paper, linear; levels as their maker drew them: use textureLod
uniform vec4 hw_hatch_info;      // x map widths per metre, y texels between lines, z texels of the width, w levels
#endif
#ifdef HW_INK_MAP
uniform sampler2D hw_ink_map;
uniform vec4 hw_ink_info;        // x map widths per metre, y height / width, z texels of the width, w levels
#endif
#ifdef HW_TONAL_MAP
uniform sampler2D hw_tonal_map;  // square tones side by side, darkest last
uniform vec4 hw_tonal_info;      // x tone widths per metre, y tones, z texels of the whole width, w levels
#endif
#ifdef HW_RAMP_MAP
uniform sampler2D hw_ramp_map;   // a strip of colours, dark tones first
uniform vec4 hw_ramp_info;       // z texels of the width
#endif
#ifdef HW_IMAGE_MAP
uniform sampler2D hw_image_map;
uniform vec4 hw_image_info;      // x map widths per metre, y height / width, z texels of the width, w levels
#endif

struct HwSurface {
    vec3 position_world;
    vec3 position_local;  // the same from an origin near the eye: what lights and shadows go by, far from the world's origin
    vec3 position_object;
    vec3 normal_world;    // unit, interpolated; looks towards the eye when the material is double-sided
    vec3 normal_object;   // unit
    vec3 face_normal_world;  // unit, of the triangle, towards the eye
    vec2 uv0;             // 0 where the mesh has none
    vec2 uv1;
    vec2 hatch_uv;        // about metres: where strokes are; uv0 scaled, or as Streams::hatch_source says
    vec2 hatch_uv_dx;     // derivatives of hatch_uv along the picture's x and y
    vec2 hatch_uv_dy;
    vec2 map_uv;          // about metres: where drawn maps are; uv0 scaled, else hatch_uv
    vec2 map_uv_dx;
    vec2 map_uv_dy;
    vec3 direction_world;  // unit, along the surface where u of hatch_uv rises; 0 where the style asks for none
    vec4 colour;          // of the vertex, linear; 1 where the mesh has none
    vec3 to_eye_world;    // unit
    float distance_m;     // from the eye; in a parallel projection along the view
    uint object_id;       // of the object, from 1 on: what the image object_ids holds
    uint triangle_id;     // through all objects, from 1 on, as in triangle_ids; 0 unless the style asks for it
};

struct HwMaterial {
    vec3 base_colour;     // linear
    float alpha;          // 1 unless blended
    float metallic;
    float roughness;      // perceptual, as the model states it
    vec3 emissive;        // linear
    float occlusion;      // 1: open
    vec3 normal_world;    // unit, with the normal map
};

HwSurface hw_surface()
{
    HwSurface s;
    s.position_object = hw_v_position_object;
    s.position_world = hw_v_position_relative + hw_eye_world;
    s.position_local = hw_v_position_relative + hw_eye_local.xyz;
#ifdef HW_PARALLEL
    s.distance_m = -dot(hw_v_position_relative, hw_to_viewer.xyz);
    s.to_eye_world = hw_to_viewer.xyz;
#else
    s.distance_m = length(hw_v_position_relative);
    s.to_eye_world = -hw_v_position_relative / max(s.distance_m, 1e-20);
#endif
    s.object_id = uint(hw_object_id);
#ifdef HW_HAS_TRIANGLE_ID
    s.triangle_id = hw_v_triangle_id;
#else
    s.triangle_id = 0u;
#endif
    float side = 1.0;
#ifdef HW_DOUBLE_SIDED
    side = gl_FrontFacing ? 1.0 : -1.0;
#endif
    s.normal_world = side * normalize(hw_v_normal_world);
    s.normal_object = normalize(hw_v_normal_object);
    vec3 face = cross(dFdx(hw_v_position_relative), dFdy(hw_v_position_relative));
#ifdef HW_PARALLEL
    s.face_normal_world = normalize(dot(face, hw_to_viewer.xyz) < 0.0 ? -face : face);
#else
    s.face_normal_world = normalize(dot(face, hw_v_position_relative) > 0.0 ? -face : face);
#endif
#ifdef HW_HAS_COLOURS
    s.colour = hw_v_colour;
#else
    s.colour = vec4(1.0);
#endif
#ifdef HW_HAS_UV1
    s.uv1 = hw_v_uv1;
#else
    s.uv1 = vec2(0.0);
#endif
#ifdef HW_HAS_UV0
    s.uv0 = hw_v_uv0;
    s.map_uv = hw_v_uv0 * hw_hatch_scale.x;
#else
    s.uv0 = vec2(0.0);
    s.map_uv = vec2(0.0);
#endif
#ifdef HW_HAS_HATCH_UV
    s.hatch_uv = hw_v_hatch_uv * hw_hatch_scale.y;
#else
    s.hatch_uv = s.map_uv;
#endif
#ifndef HW_HAS_UV0
    s.map_uv = s.hatch_uv;
#endif
    s.hatch_uv_dx = dFdx(s.hatch_uv);
    s.hatch_uv_dy = dFdy(s.hatch_uv);
    s.map_uv_dx = dFdx(s.map_uv);
    s.map_uv_dy = dFdy(s.map_uv);
#ifdef HW_HAS_DIRECTION
    s.direction_world = hw_v_direction_world * inversesqrt(max(dot(hw_v_direction_world, hw_v_direction_world), 1e-30));
#else
    s.direction_world = vec3(0.0);
#endif
    return s;
}

vec2 hw_uv_of(HwSurface s, mat3 transform, float set)
{
    return (transform * vec3(set > 0.5 ? s.uv1 : s.uv0, 1.0)).xy;
}

// HW_..._MAP is 1 for uv0 and 2 for uv1.
#define HW_MAP_UV(s, which, transform) hw_uv_of(s, transform, which == 2 ? 1.0 : 0.0)

vec3 hw_mapped_normal(HwSurface s)
{
#ifdef HW_NORMAL_MAP
    vec2 uv = HW_MAP_UV(s, HW_NORMAL_MAP, hw_normal_uv);
    vec3 n = texture(hw_normal_map, uv).xyz * 2.0 - 1.0;
    n.xy *= hw_emissive_normal.w;
#ifdef HW_HAS_TANGENTS
    // Interpolated, unorthogonal and not unit, as whoever baked the map will have done it (Mikkelsen 2008).
    float side = hw_v_tangent_world.w * hw_handedness;
    vec3 normal = hw_v_normal_world;
#ifdef HW_DOUBLE_SIDED
    normal *= gl_FrontFacing ? 1.0 : -1.0;
    side *= gl_FrontFacing ? 1.0 : -1.0;
#endif
    vec3 tangent = hw_v_tangent_world.xyz;
    return normalize(tangent * n.x + cross(normal, tangent) * (side * n.y) + normal * n.z);
#else
    // Without tangents of the model: from derivatives (Mikkelsen 2010).
    vec3 dpx = dFdx(hw_v_position_relative);
    vec3 dpy = dFdy(hw_v_position_relative);
    vec2 dux = dFdx(uv);
    vec2 duy = dFdy(uv);
    vec3 rx = cross(dpy, s.normal_world);
    vec3 ry = cross(s.normal_world, dpx);
    float facing = dot(dpx, rx) < 0.0 ? -1.0 : 1.0;
    vec3 tangent = facing * (rx * dux.x + ry * duy.x);
    vec3 bitangent = facing * (rx * dux.y + ry * duy.y);
    float longest = max(dot(tangent, tangent), dot(bitangent, bitangent));
    float scale = longest > 0.0 ? inversesqrt(longest) : 0.0;
    return normalize(tangent * scale * n.x + bitangent * scale * n.y + s.normal_world * n.z);
#endif
#else
    return s.normal_world;
#endif
}

// The material here, its textures applied. Discards what an alpha mask cuts out.
HwMaterial hw_material(HwSurface s)
{
    HwMaterial m;
    vec4 base = hw_base_colour_factor * s.colour;
#ifdef HW_BASE_COLOUR_MAP
    base *= texture(hw_base_colour_map, HW_MAP_UV(s, HW_BASE_COLOUR_MAP, hw_base_colour_uv));
#endif
    m.alpha = 1.0;
#ifdef HW_ALPHA_MASK
    if (base.a < hw_material_factors.z) discard;
#endif
#ifdef HW_ALPHA_BLEND
    m.alpha = base.a;
#endif
    m.base_colour = base.rgb;
    m.metallic = hw_material_factors.x;
    m.roughness = hw_material_factors.y;
#ifdef HW_METALLIC_ROUGHNESS_MAP
    vec4 mr = texture(hw_metallic_roughness_map, HW_MAP_UV(s, HW_METALLIC_ROUGHNESS_MAP, hw_metallic_roughness_uv));
    m.metallic *= mr.b;
    m.roughness *= mr.g;
#endif
    m.emissive = hw_emissive_normal.rgb;
#ifdef HW_EMISSIVE_MAP
    m.emissive *= texture(hw_emissive_map, HW_MAP_UV(s, HW_EMISSIVE_MAP, hw_emissive_uv)).rgb;
#endif
    m.occlusion = 1.0;
#ifdef HW_OCCLUSION_MAP
    float open = texture(hw_occlusion_map, HW_MAP_UV(s, HW_OCCLUSION_MAP, hw_occlusion_uv)).r;
    m.occlusion = 1.0 + hw_material_factors.w * (open - 1.0);
#endif
    m.normal_world = hw_mapped_normal(s);
    return m;
}

// The colour that the object's ramp gives a tone in [0, 1], linear: from the middle of its first texel to that of its last.
// The tone itself where the object has no ramp.
vec3 hw_ramp(float tone)
{
#ifdef HW_RAMP_MAP
    float at = (clamp(tone, 0.0, 1.0) * (hw_ramp_info.z - 1.0) + 0.5) / hw_ramp_info.z;
    return textureLod(hw_ramp_map, vec2(at, 0.5), 0.0).rgb;
#else
    return vec3(tone);
#endif
}

// The object's image map here, linear. White where the object has none.
vec3 hw_image(HwSurface s)
{
#ifdef HW_IMAGE_MAP
    vec2 per_metre = hw_image_info.x * vec2(1.0, 1.0 / hw_image_info.y);
#ifndef HW_HAS_UV0
    per_metre.y = -per_metre.y;  // hatch_uv points up, pictures go down
#endif
    return textureGrad(hw_image_map, s.map_uv * per_metre, s.map_uv_dx * per_metre, s.map_uv_dy * per_metre).rgb;
#else
    return vec3(1.0);
#endif
}

// How much this style shows here, in [0, 1]. Two styles of one object show presence and 1 - presence.
float hw_presence(HwSurface s)
{
#ifdef HW_PRESENCE
    return hw_presence_at(s.position_world.y);
#else
    return 1.0;
#endif
}

// The colour of this fragment, linear, 1 is paper white. Multiply hw_presence() into alpha: the host mixes blended
// materials, and a style that lies over another, by it.
#ifndef HW_OWN_OUTPUTS
void hw_output(vec3 colour_linear, float alpha) { hw_fragment = vec4(colour_linear, alpha); }
#endif
