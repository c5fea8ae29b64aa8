// Shares over height: see world/presence.hpp. Ramps over time are in the constants.

uniform vec4 hw_presence_height;     // of the level: see hw_share_at()
uniform float hw_presence_inverted;  // 1: this style shows 1 - presence

// `share`: a constant, from_m, to_m, 1 when the constant is ramped by height.
float hw_share_at(vec4 share, float height_m)
{
    float value = share.x;
    if (share.w > 0.5) {
        float width = share.z - share.y;
        float at = clamp((height_m - share.y) / (abs(width) < 1e-6 ? 1e-6 : width), 0.0, 1.0);
        value *= at * at * (3.0 - 2.0 * at);
    }
    return value;
}

float hw_presence_at(float height_m)
{
    float presence = hw_share_at(hw_presence_height, height_m);
    return hw_presence_inverted > 0.5 ? 1.0 - presence : presence;
}
