// An intermediate image in place of the picture, stretched over it. Whole numbers get colours that differ between
// neighbours; negative values show as positive.
#include "full_screen.glsl"

#ifdef HW_WHOLE_NUMBERS
uniform usampler2D shown;
#else
uniform sampler2D shown;
#endif

void main()
{
#ifdef HW_WHOLE_NUMBERS
    ivec2 size = textureSize(shown, 0);
    uint id = texelFetch(shown, min(ivec2(hw_v_uv * vec2(size)), size - 1), 0).r;
    uint h = id * 747796405u + 2891336453u;
    h = (h >> ((h >> 28u) + 4u) ^ h) * 277803737u;
    vec3 colour = id == 0u ? vec3(0.0) : 0.1 + 0.9 * vec3(uvec3(h, h >> 8, h >> 16) & 255u) / 255.0;
#else
    vec3 colour = abs(texture(shown, hw_v_uv).rgb);
#endif
    // The picture is sRGB: what is in the image comes out as it is.
    vec3 low = colour / 12.92;
    vec3 high = pow((colour + 0.055) / 1.055, vec3(2.4));
    hw_fragment = vec4(mix(high, low, vec3(lessThanEqual(colour, vec3(0.04045)))), 1.0);
}
