// Lines as quads in the plane of the picture, a pixel wider and longer than the line, so that the fragment stage can round
// the ends and smooth the sides. Four vertices a line: twice its one end, twice its other.
#include "line.glsl"

out vec3 hw_v_line;        // along and across the line, in pixels; z half the width
out vec2 hw_v_line_height; // world height over w, 1 over w: perspective by hand, since w is 1 below
flat out vec4 hw_v_line_way;  // x length in pixels, yz direction, w slope of depth along it
flat out highp vec2 hw_v_line_depth;  // x at its beginning, y 1 for contours
flat out vec3 hw_v_line_colour;

// Moves `from` along the line until it lies before the near plane. False where the whole line is behind.
bool hw_clip_near(inout vec4 from, vec4 to)
{
    float inside = from.z + from.w;
    float other = to.z + to.w;
    float margin = 1e-5 * abs(to.w);
    if (inside >= margin) return true;
    if (other <= margin) return false;
    from = mix(from, to, (margin - inside) / (other - inside));
    return true;
}

void main()
{
    hw_set_position(hw_in_position);
    vec4 own = gl_Position;
    vec4 other = hw_clip_from_object * vec4(hw_in_other.xyz, 1.0);
    vec4 own_unclipped = own;
    int line_class = int(hw_in_other.w + 0.5);
    hw_v_line_colour = hw_line_colour[line_class];
    hw_v_line = vec3(0.0);
    hw_v_line_height = vec2(0.0);
    hw_v_line_way = vec4(0.0);
    hw_v_line_depth = vec2(0.0);
    bool is_seen = hw_clip_near(own, other) && hw_clip_near(other, own);
    vec3 relative = (hw_relative_from_object * vec4(hw_in_position, 1.0)).xyz;
    if (own != own_unclipped) {
        float share = distance(own, own_unclipped) / max(distance(other, own_unclipped), 1e-20);
        relative = mix(relative, (hw_relative_from_object * vec4(hw_in_other.xyz, 1.0)).xyz, share);
    }
    float width = hw_line_width_at(line_class, relative);
    float widest = hw_line_width_px[line_class];
    if (!is_seen || widest <= 0.0 || hw_line_is_culled()) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    vec2 half_size = 0.5 * hw_size_px;
    vec2 own_px = own.xy / own.w * half_size;
    vec2 way = other.xy / other.w * half_size - own_px;
    float length_px = length(way);
    vec2 along = length_px > 1e-6 ? way / length_px : vec2(1.0, 0.0);
    // Seen from the other end, left is right: the second two vertices count it back.
    int corner = gl_VertexID & 3;
    float side = (corner & 1) == 0 ? 1.0 : -1.0;
    float is_end = corner < 2 ? 0.0 : 1.0;
    float reach = 0.5 * widest + 1.0;
    vec2 place = own_px - along * reach + vec2(-along.y, along.x) * (side * reach);
    hw_v_line = vec3(mix(-reach, length_px + reach, is_end), side * mix(reach, -reach, is_end), 0.5 * width);
    // Of the two ends, the first is the beginning.
    vec2 depth = 0.5 + 0.5 * vec2(own.z / own.w, other.z / other.w);
    if (corner >= 2) depth = depth.yx;
    hw_v_line_depth = vec2(depth.x, hw_line_is_contour(line_class));
    hw_v_line_way = vec4(length_px, corner < 2 ? along : -along, (depth.y - depth.x) / max(length_px, 1e-6));
    hw_v_line_height = vec2(relative.y + hw_eye_world.y, 1.0) / own.w;
    gl_Position = vec4(place / half_size, own.z / own.w, 1.0);
}
