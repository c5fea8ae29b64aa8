// What the image "normal_depth" of format rgba8 holds: normals as bytes, and depth as a share of Pass::depth_range(); nothing is
// (0.5, 0.5, 0.5, 1). The same as in the other formats: unit normal, metres, 0 where nothing is.
vec4 hw_normal_depth_of_bytes(vec4 texel, vec2 range_m)
{
    vec3 normal = 2.0 * texel.rgb - 1.0;
    if (dot(normal, normal) < 0.1) return vec4(0.0);
    return vec4(normalize(normal), mix(range_m.x, range_m.y, texel.a));
}
