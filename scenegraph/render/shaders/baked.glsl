// Light that was baked into the level. Include after surface.glsl.
//   HW_LIGHTMAP 1: the object's charts lie in the atlas   2: a luxel for each vertex, read by the vertex stage

#ifdef HW_LIGHTMAP
const float kHwLuxPerLuxel = 1000.0;

#if HW_LIGHTMAP == 1
uniform highp sampler2D hw_lightmap;
uniform vec4 hw_lightmap_place;  // luxels: xy the corner of the object's rectangle, z from the front to the back
in vec2 hw_v_lightmap_uv;
#else
in vec3 hw_v_baked;
#ifdef HW_DOUBLE_SIDED
in vec3 hw_v_baked_back;
#endif
#endif

// Illuminance of the surface by all that reaches it: lux.
vec3 hw_baked_illuminance()
{
#if HW_LIGHTMAP == 1
    vec2 at = hw_v_lightmap_uv + hw_lightmap_place.xy;
#ifdef HW_DOUBLE_SIDED
    if (!gl_FrontFacing) at.x += hw_lightmap_place.z;
#endif
    return texture(hw_lightmap, at / vec2(textureSize(hw_lightmap, 0))).rgb * kHwLuxPerLuxel;
#else
    vec3 baked = hw_v_baked;
#ifdef HW_DOUBLE_SIDED
    if (!gl_FrontFacing) baked = hw_v_baked_back;
#endif
    return baked * kHwLuxPerLuxel;
#endif
}
#endif
