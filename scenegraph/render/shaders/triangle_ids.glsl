// What is known of the triangles that the image triangle_ids numbers. Two are adjacent where they share a corner. Either the
// corners are compared (vertex-storage), or with TRIANGLES_BY_STARS lists of the triangles around each corner are read, by a
// table of where each begins (id-list); the result is the same. Set the images triangle_corners and triangle_stars, which your
// needs name; triangle_stars has two outputs.
// Source: Diktas, Sahiner. ID-Based Rendering of Silhouettes on GPU. 2011, section 4.

uniform highp usampler2D triangle_corners;
#ifdef TRIANGLES_BY_STARS
uniform highp usampler2D triangle_stars;
uniform highp usampler2D star_triangles;
#endif

// Of entry `index` of a table: kTriangleTableWidth of triangle_tables.hpp.
ivec2 hw_table_texel(highp uint index) { return ivec2(int(index & 8191u), int(index >> 13u)); }

// Where a triangle's corners are, and in w what triangle_corners has beside.
struct HwTriangle {
    highp uint id;
    highp uvec4 a, b, c;
#ifdef TRIANGLES_BY_STARS
    highp uvec2 star_a, star_b, star_c;  // first, count
#endif
};

// Ids start at 1.
HwTriangle hw_triangle(highp uint id)
{
    highp uint first = 3u * (id - 1u);
    ivec2 a = hw_table_texel(first), b = hw_table_texel(first + 1u), c = hw_table_texel(first + 2u);
    HwTriangle t;
    t.id = id;
    t.a = texelFetch(triangle_corners, a, 0);
    t.b = texelFetch(triangle_corners, b, 0);
    t.c = texelFetch(triangle_corners, c, 0);
#ifdef TRIANGLES_BY_STARS
    t.star_a = texelFetch(triangle_stars, a, 0).rg;
    t.star_b = texelFetch(triangle_stars, b, 0).rg;
    t.star_c = texelFetch(triangle_stars, c, 0).rg;
#endif
    return t;
}

highp uint hw_object_of(HwTriangle t) { return t.a.w; }

highp float hw_least_height_m(HwTriangle t) { return uintBitsToFloat(t.b.w); }

#ifdef TRIANGLES_BY_STARS

bool hw_star_holds(highp uvec2 star, highp uint id)
{
    for (highp uint i = 0u; i < star.y; ++i)
        if (texelFetch(star_triangles, hw_table_texel(star.x + i), 0).r == id) return true;
    return false;
}

bool hw_has_a(HwTriangle t, HwTriangle other) { return hw_star_holds(t.star_a, other.id); }
bool hw_has_b(HwTriangle t, HwTriangle other) { return hw_star_holds(t.star_b, other.id); }
bool hw_has_c(HwTriangle t, HwTriangle other) { return hw_star_holds(t.star_c, other.id); }

#else

bool hw_is_corner(HwTriangle t, highp uvec4 p) { return p.xyz == t.a.xyz || p.xyz == t.b.xyz || p.xyz == t.c.xyz; }
bool hw_has_a(HwTriangle t, HwTriangle other) { return hw_is_corner(other, t.a); }
bool hw_has_b(HwTriangle t, HwTriangle other) { return hw_is_corner(other, t.b); }
bool hw_has_c(HwTriangle t, HwTriangle other) { return hw_is_corner(other, t.c); }

#endif

// How many corners of the one are corners of the other: 0 to 3.
int hw_common_corners(HwTriangle t, HwTriangle other)
{
    return int(hw_has_a(t, other)) + int(hw_has_b(t, other)) + int(hw_has_c(t, other));
}

// The paper's question: whether they share a corner.
bool hw_is_adjacent(HwTriangle t, HwTriangle other)
{
    return hw_has_a(t, other) || hw_has_b(t, other) || hw_has_c(t, other);
}
