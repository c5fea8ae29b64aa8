// Lines from the image edge_map, mixed into a style's faces. Include after surface.glsl. Defines of the program, by LinesLook:
// LINES_FROM_EDGE_MAP; LINES_TELL_BORDERS where the map does; LINES_HALO where profile lines reach beyond their object
// (lines_halo.frag draws those parts).
// Inner edges first, then profile edges over them: Nienhaus, Doellner. Edge-Enhancement. Journal of WSCG 11, 2003, section 5.

#ifdef LINES_FROM_EDGE_MAP
uniform sampler2D edge_map;     // R 1 - inner edge, G 1 - profile edge, B 1 - what of that is a border
uniform sampler2D edge_source;  // w depth of what the edge map saw, metres, 0 where nothing is
uniform vec4 profile_pen;       // colour, linear; strength
uniform vec4 inner_pen;
#ifdef LINES_TELL_BORDERS
uniform vec4 border_pen;
#endif
#ifdef LINES_HALO
uniform sampler2D edge_owner;
#endif

// Inner edge, profile edge and border at this fragment. The edge map knows one surface a pixel, the one in its middle. Beside the border of an
// object there are fragments that cover a part of the pixel: of the object before, which the map has in the next pixel, or of
// what lies behind it, which has no part in its line.
vec3 hw_edges_here()
{
    const float kSame = 0.005;  // of the distance
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(edge_map, 0) - 1;
    float seen_m = texelFetch(edge_source, here, 0).w;
    float own_m = -(mat3(hw_view_from_world) * hw_v_position_relative).z;
    if (seen_m == 0.0 || own_m < seen_m * (1.0 - kSame)) {
        vec2 profile = vec2(1.0);
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                profile = min(profile, texelFetch(edge_map, clamp(here + ivec2(x, y), ivec2(0), last), 0).gb);
        return vec3(0.0, 1.0 - profile);
    }
    if (own_m > seen_m * (1.0 + kSame)) return vec3(0.0);
    vec3 edges = 1.0 - texelFetch(edge_map, here, 0).rgb;
#ifdef LINES_HALO
    if (any(greaterThan(abs(texelFetch(edge_owner, here, 0).rg - 128.0 / 255.0), vec2(1e-3)))) edges.gb = vec2(0.0);
#endif
    return edges;
}
#endif

// `share`: how much of the lines is there.
vec3 hw_with_lines(vec3 colour, float share)
{
#ifdef LINES_FROM_EDGE_MAP
    vec3 edges = hw_edges_here() * share;
    vec4 profile = profile_pen;
#ifdef LINES_TELL_BORDERS
    profile = mix(profile, border_pen, edges.b / max(edges.g, 1e-3));
#endif
    colour = mix(colour, inner_pen.rgb, inner_pen.a * edges.r);
    colour = mix(colour, profile.rgb, profile.a * edges.g);
#endif
    return colour;
}
