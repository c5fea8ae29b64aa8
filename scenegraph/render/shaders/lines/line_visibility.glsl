// A line is seen where its middle is: all its width is drawn there, also where it lies on a face that comes nearer at one
// side, such as the floor before the foot of a wall. Included by line_pen.glsl and line_end.frag.

uniform highp sampler2D hw_line_depth;  // of the faces, behind them by the polygon offset

float hw_face_depth(vec2 at_px)
{
    return texelFetch(hw_line_depth, clamp(ivec2(floor(at_px)), ivec2(0), ivec2(hw_size_px) - 1), 0).r;
}

// `middle`: of the line at this fragment, pixels and depth in [0, 1]. `aside`: where a line at which the surface ends or
// turns away is looked for too: faces thinner than a pixel may come nearer in its own pixel, beyond it nothing does. Where
// it is not known which side is beyond, both are looked at.
bool hw_is_line_hidden(vec3 middle, vec2 aside, bool on_both_sides)
{
    if (middle.z <= hw_face_depth(middle.xy)) return false;
    if (aside == vec2(0.0) || middle.z > hw_face_depth(middle.xy + aside))
        return !on_both_sides || aside == vec2(0.0) || middle.z > hw_face_depth(middle.xy - aside);
    return false;
}
