// Lines as GL_LINES, and as round GL_POINTS at their ends.
// Source: Freudenberg, Masuch, Strothotte. Walk-Through Illustrations. Eurographics 2001, section 3.1.
#include "lines/line.glsl"

out float hw_v_height;
out float hw_v_share;  // of the full width: what the far policy leaves
out highp vec4 hw_v_middle;    // clip space
flat out vec2 hw_v_aside;     // across contours, a pixel
flat out vec4 hw_v_line_colour;  // w: diameter of the end in pixels

void main()
{
    hw_set_position(hw_in_position);
    int line_class = hw_line_class();
    float widest = hw_line_width_px[line_class];
    vec3 relative = (hw_relative_from_object * vec4(hw_in_position, 1.0)).xyz;
    hw_v_height = relative.y + hw_eye_world.y;
    hw_v_share = widest > 0.0 ? hw_line_width_at(line_class, relative) / widest : 0.0;
    hw_v_line_colour = vec4(hw_line_colour[line_class], widest);
    gl_PointSize = widest + 1.0;
    hw_v_middle = gl_Position;
    vec4 other = hw_clip_from_object * vec4(hw_in_line_other.xyz, 1.0);
    vec2 way = (other.xy * gl_Position.w - gl_Position.xy * other.w) * hw_size_px;
    hw_v_aside = hw_line_is_contour(line_class) * vec2(-way.y, way.x) / max(length(way), 1e-20);
    if (hw_line_is_culled()) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
