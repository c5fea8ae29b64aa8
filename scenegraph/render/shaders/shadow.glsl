// The shadow of the main light, which is light 0. Include after surface.glsl.

#ifdef HW_SHADOW
uniform mediump sampler2DShadow hw_shadow_map;
#endif

// How much of the main light reaches the surface: 0 shadow, 1 light. The sampler compares and blends four texels.
float hw_shadow(HwSurface s)
{
#ifdef HW_SHADOW
    vec3 to_light = -hw_light_direction[0].xyz;
    // Leaves the surface along its normal, further at grazing light: less acne than a bias in depth, no gap at contacts.
    float cosine = dot(s.normal_world, to_light);
    float sine = sqrt(clamp(1.0 - cosine * cosine, 0.0, 1.0));
    vec3 from = s.position_local + s.normal_world * (hw_shadow_params.y * (0.6 + 1.6 * sine));
    return texture(hw_shadow_map, (hw_shadow_from_local * vec4(from, 1.0)).xyz);
#else
    return 1.0;
#endif
}
