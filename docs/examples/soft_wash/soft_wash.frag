#include "surface.glsl"

uniform sampler2D shade;

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    vec2 light = texture(shade, gl_FragCoord.xy / hw_size_px).rg;
    float tone = light.r / max(light.g, 1.0 / 255.0);
    hw_output(material.base_colour * mix(0.25, 1.0, tone), material.alpha * hw_presence(surface));
}
