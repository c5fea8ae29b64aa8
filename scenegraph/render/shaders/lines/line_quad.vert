// Lines as quads in the plane of the picture, a pixel wider and longer than the line, so that the fragment stage can round
// the ends and smooth the sides. Four vertices a line: twice its one end, twice its other.
#include "lines/line.glsl"

out vec3 hw_v_line;        // along and across the line, in pixels; z half the width
out vec2 hw_v_line_height; // world height over w, 1 over w: perspective by hand, since w is 1 below
flat out vec4 hw_v_line_way;  // x length in pixels, yz direction, w slope of depth along it
flat out highp vec2 hw_v_line_depth;  // x at its beginning, y on which side of a contour nothing is: 1 or -1, 2 either; 0 for others
flat out vec3 hw_v_line_colour;
#ifdef HW_STROKE
flat out int hw_v_line_class;
in vec4 hw_in_line_stroke;  // length along the stroke at this end and at the other, of the stroke, seed
uniform vec4 hw_stroke_px;  // as in line_stroke.glsl
flat out highp vec4 hw_v_stroke;
flat out highp vec4 hw_v_stroke_whole;
flat out highp vec3 hw_v_stroke_from;
flat out highp vec3 hw_v_stroke_to;

// Lengths along the stroke, places and overshoot at both ends of what the near plane leaves; x and y of `kept`: how much of
// the line is cut away at this end and at the other.
void hw_set_stroke(vec2 cut, float own_w, float other_w, bool is_begin)
{
    vec2 arc = mix(hw_in_line_stroke.xy, hw_in_line_stroke.yx, cut) / vec2(own_w, other_w);
    vec3 own = mix(hw_in_position, hw_in_line_other.xyz, cut.x) / own_w;
    vec3 other = mix(hw_in_line_other.xyz, hw_in_position, cut.y) / other_w;
    float whole = hw_in_line_stroke.z;
    // Some ends run on farther than others.
    vec2 spread = 0.4 + 0.6 * fract(hw_in_line_stroke.w * vec2(7.31, 3.17) + hw_in_line_stroke.xy * 1.618);
    vec2 is_end = whole > 0.0 ? vec2(lessThan(min(hw_in_line_stroke.xy, whole - hw_in_line_stroke.xy), vec2(1e-5 * whole))) : vec2(0.0);
    vec2 beyond = hw_stroke_px.z * spread * is_end * vec2(equal(cut, vec2(0.0)));
    hw_v_stroke = is_begin ? vec4(arc, 1.0 / own_w, 1.0 / other_w) : vec4(arc.yx, 1.0 / other_w, 1.0 / own_w);
    hw_v_stroke_whole = vec4(whole, hw_in_line_stroke.w, is_begin ? beyond : beyond.yx);
    hw_v_stroke_from = is_begin ? own : other;
    hw_v_stroke_to = is_begin ? other : own;
}
#endif

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
    vec4 other = hw_clip_from_object * vec4(hw_in_line_other.xyz, 1.0);
    vec4 own_unclipped = own;
    vec4 other_unclipped = other;
    int line_class = hw_line_class();
    hw_v_line_colour = hw_line_colour[line_class];
    hw_v_line = vec3(0.0);
    hw_v_line_height = vec2(0.0);
    hw_v_line_way = vec4(0.0);
    hw_v_line_depth = vec2(0.0);
#ifdef HW_STROKE
    hw_v_line_class = line_class;
    hw_v_stroke = hw_v_stroke_whole = vec4(0.0);
    hw_v_stroke_from = hw_v_stroke_to = vec3(0.0);
#endif
    bool is_seen = hw_clip_near(own, other) && hw_clip_near(other, own);
    vec3 relative = (hw_relative_from_object * vec4(hw_in_position, 1.0)).xyz;
    if (own != own_unclipped) {
        float share = distance(own, own_unclipped) / max(distance(other, own_unclipped), 1e-20);
        relative = mix(relative, (hw_relative_from_object * vec4(hw_in_line_other.xyz, 1.0)).xyz, share);
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
    vec2 reach = vec2(0.5 * max(width, 1.0) + 1.0);  // along and across
#ifdef HW_STROKE
    vec2 cut = vec2(distance(own, own_unclipped), distance(other, other_unclipped)) /
               max(distance(own_unclipped, other_unclipped), 1e-20);
    hw_set_stroke(cut, own.w, other.w, corner < 2);
    reach += vec2(hw_stroke_px.z, hw_stroke_px.x);
#endif
    vec2 place = own_px - along * reach.x + vec2(-along.y, along.x) * (side * reach.y);
    hw_v_line = vec3(mix(-reach.x, length_px + reach.x, is_end), side * mix(reach.y, -reach.y, is_end), 0.5 * width);
    // Of the two ends, the first is the beginning.
    vec2 depth = 0.5 + 0.5 * vec2(own.z / own.w, other.z / other.w);
    if (corner >= 2) depth = depth.yx;
    vec2 from_begin = corner < 2 ? along : -along;
    hw_v_line_depth = vec2(depth.x, hw_line_is_contour(line_class) * hw_line_beyond(own, vec2(-from_begin.y, from_begin.x)));
    hw_v_line_way = vec4(length_px, from_begin, (depth.y - depth.x) / max(length_px, 1e-6));
    hw_v_line_height = vec2(relative.y + hw_eye_world.y, 1.0) / own.w;
    gl_Position = vec4(place / half_size, own.z / own.w, 1.0);
}
