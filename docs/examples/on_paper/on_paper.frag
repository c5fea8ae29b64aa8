#include "surface.glsl"

uniform sampler2D paper;
uniform float grain;

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    // Fixed to the picture, as paper is, one texel for each logical pixel.
    vec2 at = gl_FragCoord.xy / (hw_px_scale * vec2(textureSize(paper, 0)));
    float white = mix(1.0, texture(paper, at).r, grain);
    hw_output(material.base_colour * white, material.alpha * hw_presence(surface));
}
