// The shadow of the main light. Include after surface.glsl.

#ifdef HW_SHADOW
uniform mediump sampler2DShadow hw_shadow_map;
#endif

// How much of the main light (index hw_shadow_params.z) reaches the surface: 0 shadow, 1 light.
float hw_shadow(HwSurface s)
{
#ifdef HW_SHADOW
    int light = int(hw_shadow_params.z + 0.5);
    vec3 to_light = -hw_light_direction[light].xyz;
    // Leaves the surface along its normal, further at grazing light: less acne than a bias in depth, no gap at contacts.
    float sine = length(cross(s.normal_world, to_light));
    vec3 from = s.position_world + s.normal_world * (hw_shadow_params.y * (0.6 + 1.6 * sine));
    vec4 at = hw_shadow_from_world * vec4(from, 1.0);
    vec3 p = at.xyz;
    if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;
    vec2 texel = vec2(hw_shadow_params.x);
    float lit = texture(hw_shadow_map, vec3(p.xy + texel * vec2(-0.5, -0.5), p.z));
    lit += texture(hw_shadow_map, vec3(p.xy + texel * vec2(0.5, -0.5), p.z));
    lit += texture(hw_shadow_map, vec3(p.xy + texel * vec2(-0.5, 0.5), p.z));
    lit += texture(hw_shadow_map, vec3(p.xy + texel * vec2(0.5, 0.5), p.z));
    return 0.25 * lit;
#else
    return 1.0;
#endif
}
