// The presence field: see world/presence.hpp. Its ramp over time is in the constant.

uniform vec4 hw_presence_height;     // constant, from_m, to_m, 1 when the constant is ramped by height
uniform float hw_presence_inverted;  // 1: this style shows 1 - presence

float hw_presence_at(float height_m)
{
    float presence = hw_presence_height.x;
    if (hw_presence_height.w > 0.5) {
        float width = hw_presence_height.z - hw_presence_height.y;
        float at = clamp((height_m - hw_presence_height.y) / (abs(width) < 1e-6 ? 1e-6 : width), 0.0, 1.0);
        presence *= at * at * (3.0 - 2.0 * at);
    }
    return hw_presence_inverted > 0.5 ? 1.0 - presence : presence;
}
