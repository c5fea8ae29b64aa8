// Makes edges wider by what lies within their reach along the row, then along the column. The way to an edge crosses no step in
// depth, so the line stays on the nearer side; one step up to the nearer side leads to what reaches beyond it.
#define HW_OWN_OUTPUTS
#include "full_screen.glsl"

uniform sampler2D inner_edges;    // along rows: as they were found; then inner_found
uniform sampler2D profile_edges;  // along rows: the same image; then profile_found
uniform sampler2D steps;
uniform vec3 reach_px;
#ifdef IS_SETTLED
uniform sampler2D settled;  // along rows: how far from the pixel's centre its border is
#endif

#ifdef ALONG_ROWS
layout(location = 0) out vec4 inner_found;    // strength, at_px, pixels along the row / 255; at_px of the profile edge
layout(location = 1) out vec4 profile_found;  // strength, (pixels along the row + 128) / 255, 1 where it lies beyond, border
const ivec2 kWay = ivec2(1, 0);
#else
layout(location = 0) out vec4 edge_map;
layout(location = 1) out vec4 owner;  // (pixels to the object whose edge this is + 128) / 255
const ivec2 kWay = ivec2(0, 1);
#endif

struct Edge {
    float strength;
    float at_px;      // from the centre of its pixel, towards what lies behind
    vec2 away_px;
    bool is_beyond;  // of profile edges
    float border;    // of profile edges
};

float inner_cover(Edge e) { return e.strength * clamp(reach_px.x + 0.5 - length(e.away_px) - e.at_px, 0.0, 1.0); }

float profile_cover(Edge e)
{
    float beyond_px = length(e.away_px) - e.at_px, within_px = length(e.away_px) + e.at_px;
    return e.strength * clamp(0.5 + (e.is_beyond ? reach_px.z - beyond_px : reach_px.y - within_px), 0.0, 1.0);
}

Edge inner_at(ivec2 place, int along)
{
    vec4 e = texelFetch(inner_edges, place, 0);
#ifdef ALONG_ROWS
    return Edge(e.r, e.g, vec2(float(along), 0.0), false, 0.0);
#else
    return Edge(e.r, e.g, vec2(255.0 * e.b, float(along)), false, 0.0);
#endif
}

Edge profile_at(ivec2 place, int along)
{
    vec4 e = texelFetch(profile_edges, place, 0);
#ifdef ALONG_ROWS
    float at_px = 0.5;
#ifdef IS_SETTLED
    if (e.b > 0.0) at_px = texelFetch(settled, place, 0).r;
#endif
    return Edge(e.b, at_px, vec2(float(along), 0.0), false, e.a);
#else
    return Edge(e.r, texelFetch(inner_edges, place, 0).a, vec2(floor(255.0 * e.g + 0.5) - 128.0, float(along)), e.b > 0.5, e.a);
#endif
}

// Of the step from a pixel to the next in the direction `way`: positive where the pixel is nearer.
float step_between(ivec2 place, int way)
{
    vec2 step = 2.0 * texelFetch(steps, way > 0 ? place : place - kWay, 0).rg - 1.0;
    return float(way) * dot(step, vec2(kWay));
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), size = textureSize(steps, 0);
    Edge inner = inner_at(here, 0), profile = profile_at(here, 0);
    int reach = int(ceil(max(reach_px.x, max(reach_px.y, reach_px.z))));
    for (int way = -1; way <= 1; way += 2) {
        ivec2 place = here;
        for (int k = 1; k <= reach; ++k) {
            ivec2 next = place + way * kWay;
            if (any(lessThan(next, ivec2(0))) || any(greaterThanEqual(next, size))) break;
            float step = step_between(place, way);
            Edge other = profile_at(next, way * k);
            if (abs(step) > 0.5) {
                bool is_owner = step < 0.0 && !other.is_beyond;
                other.is_beyond = true;
                if (is_owner && profile_cover(other) > profile_cover(profile)) profile = other;
                break;
            }
            if (profile_cover(other) > profile_cover(profile)) profile = other;
            other = inner_at(next, way * k);
            if (inner_cover(other) > inner_cover(inner)) inner = other;
            place = next;
        }
    }
#ifdef ALONG_ROWS
    inner_found = vec4(inner.strength, inner.at_px, abs(inner.away_px.x) / 255.0, profile.at_px);
    profile_found = vec4(profile.strength, (profile.away_px.x + 128.0) / 255.0, profile.is_beyond ? 1.0 : 0.0, profile.border);
#else
    float covered = profile_cover(profile);
    edge_map = vec4(1.0 - inner_cover(inner), 1.0 - covered, 1.0 - profile.border * covered, 1.0);
    owner = vec4((vec2(profile.is_beyond ? profile.away_px : vec2(0.0)) + 128.0) / 255.0, 0.0, 1.0);
#endif
}
