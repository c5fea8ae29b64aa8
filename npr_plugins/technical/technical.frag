#include "surface.glsl"
#include "lines_look.glsl"

uniform vec4 cool;           // linear; share of the material
uniform vec4 warm;
uniform vec3 to_light_view;  // unit; +z towards the viewer
uniform vec2 highlight;      // strength, exponent

void main()
{
    HwSurface surface = hw_surface();
    HwMaterial material = hw_material(surface);
    vec3 to_light = to_light_view * mat3(hw_view_from_world);
    vec3 normal = material.normal_world;
    float warmth = 0.5 + 0.5 * dot(normal, to_light);
    vec3 colour = mix(mix(cool.rgb, material.base_colour, cool.a), mix(warm.rgb, material.base_colour, warm.a), warmth);
    float shine = max(dot(reflect(-to_light, normal), surface.to_eye_world), 0.0);
    colour = mix(colour, vec3(1.0), highlight.x * pow(shine, highlight.y));
    hw_output(hw_with_lines(colour, 1.0), material.alpha * hw_presence(surface));
}
