// Light on a surface, shared by all styles. Include after surface.glsl and shadow.glsl. Illuminance is in lux, luminance in
// candela per square metre; hw_display() makes colours of the picture of it.
#include "baked.glsl"

const float kHwPi = 3.14159265;
const vec3 kHwLuminanceWeights = vec3(0.2126, 0.7152, 0.0722);

float hw_luminance(vec3 colour_linear) { return dot(colour_linear, kHwLuminanceWeights); }

// The main light, the one with a shadow: the host puts it first.
const int kHwMainLight = 0;

// What of a sun reaches a face with this normal, in the main light's shadow.
float hw_sun(HwSurface s, vec3 normal_world, const int i, out vec3 to_light)
{
    to_light = -hw_light_direction[i].xyz;
    float facing = max(dot(normal_world, to_light), 0.0);
    // No test of `facing` around the shadow: software renderers run both sides of a branch.
    if (i == kHwMainLight) facing *= hw_shadow(s);
    return facing;
}

// What of each candela of a point or spot light reaches a face with this normal: lux.
float hw_lamp(HwSurface s, vec3 normal_world, const int i, out vec3 to_light)
{
    vec3 d = hw_light_position[i].xyz - s.position_local;
    float distance_squared = max(dot(d, d), 1e-4);
    float near = hw_inverse_sqrt(min(distance_squared, 1e24));
    to_light = d * near;
    float share = max(dot(normal_world, to_light), 0.0) * near * near;
#ifdef HW_LIGHT_RANGES  // as KHR_lights_punctual recommends
    float range = hw_light_direction[i].w;
    float reached = distance_squared / max(range * range, 1e-6);
    if (range > 0.0) share *= clamp(1.0 - reached * reached, 0.0, 1.0);
#endif
#ifdef HW_SPOT_LIGHTS
    float cone = clamp(dot(hw_light_direction[i].xyz, -to_light) * hw_light_cone[i].x + hw_light_cone[i].y, 0.0, 1.0);
    if (hw_light_position[i].w > 1.5) share *= cone * cone;
#endif
    return share;
}

float hw_light(HwSurface s, vec3 n, const int i, out vec3 to_light)
{
    return i < HW_SUN_COUNT ? hw_sun(s, n, i, to_light) : hw_lamp(s, n, i, to_light);
}

// Lights with constant indices: a loop would fetch them anew for each pixel.
void hw_add_light(HwSurface s, vec3 n, const int i, inout vec3 sum, inout vec3 way)
{
    vec3 to_light;
    vec3 illuminance = hw_light_colour[i].rgb * hw_light(s, n, i, to_light);
    sum += illuminance;
    way += to_light * hw_luminance(illuminance);
}

// All lights on a face with this normal, lux, and the direction from which most of their light comes.
vec3 hw_direct(HwSurface s, vec3 n, out vec3 mean_to_light)
{
    vec3 sum = vec3(0.0);
    vec3 way = 1e-6 * n;
#if HW_LIGHT_COUNT > 0
    hw_add_light(s, n, 0, sum, way);
#endif
#if HW_LIGHT_COUNT > 1
    hw_add_light(s, n, 1, sum, way);
#endif
#if HW_LIGHT_COUNT > 2
    hw_add_light(s, n, 2, sum, way);
#endif
#if HW_LIGHT_COUNT > 3
    hw_add_light(s, n, 3, sum, way);
#endif
#if HW_LIGHT_COUNT > 4
    hw_add_light(s, n, 4, sum, way);
#endif
#if HW_LIGHT_COUNT > 5
    hw_add_light(s, n, 5, sum, way);
#endif
#if HW_LIGHT_COUNT > 6
    hw_add_light(s, n, 6, sum, way);
#endif
#if HW_LIGHT_COUNT > 7
    hw_add_light(s, n, 7, sum, way);
#endif
    mean_to_light = normalize(way);
    return sum;
}

// The luminance of hw_direct() alone, lux: all that hatching and shade go by, at a third of the work.
float hw_direct_gray(HwSurface s, vec3 n)
{
    vec3 to_light;
    float sum = 0.0;
#if HW_LIGHT_COUNT > 0
    sum += hw_light_colour[0].w * hw_light(s, n, 0, to_light);
#endif
#if HW_LIGHT_COUNT > 1
    sum += hw_light_colour[1].w * hw_light(s, n, 1, to_light);
#endif
#if HW_LIGHT_COUNT > 2
    sum += hw_light_colour[2].w * hw_light(s, n, 2, to_light);
#endif
#if HW_LIGHT_COUNT > 3
    sum += hw_light_colour[3].w * hw_light(s, n, 3, to_light);
#endif
#if HW_LIGHT_COUNT > 4
    sum += hw_light_colour[4].w * hw_light(s, n, 4, to_light);
#endif
#if HW_LIGHT_COUNT > 5
    sum += hw_light_colour[5].w * hw_light(s, n, 5, to_light);
#endif
#if HW_LIGHT_COUNT > 6
    sum += hw_light_colour[6].w * hw_light(s, n, 6, to_light);
#endif
#if HW_LIGHT_COUNT > 7
    sum += hw_light_colour[7].w * hw_light(s, n, 7, to_light);
#endif
    return sum;
}

// Light from all around, luminance: what a matte white face with this normal reflects of it. The brightest part of the sky
// is the sun's side, so that what lies in shadow still shows its form; ground light keeps faces from being black.
vec3 hw_ambient(vec3 normal_world)
{
#if HW_LIGHT_COUNT > 0
    vec3 brightest = vec3(0.0, 0.6, 0.0) - 0.8 * hw_light_direction[kHwMainLight].xyz;
#else
    vec3 brightest = vec3(0.0, 1.0, 0.0);
#endif
    float up = clamp(0.5 + 0.5 * dot(normal_world, brightest), 0.0, 1.0);
    return mix(hw_ambient_ground.rgb, hw_ambient_sky.rgb, up);
}

// The surroundings as a mirror of some roughness sees them: ground, a bright band at the horizon, sky. Luminance.
vec3 hw_surroundings(vec3 direction, float roughness)
{
    float blur = mix(0.06, 0.9, roughness);
    float sky = clamp(0.5 + 0.5 * direction.y / blur, 0.0, 1.0);
    float horizon = max(1.0 - 2.5 * abs(direction.y), 0.0) * (1.0 - roughness);
    return mix(hw_ambient_ground.rgb, hw_ambient_sky.rgb * (1.0 + 0.5 * horizon), sky);
}

// GGX with Smith's visibility in Hammon's approximation, and Schlick's Fresnel term.
vec3 hw_specular(vec3 n, vec3 to_eye, vec3 to_light, vec3 f0, float alpha)
{
    vec3 h = normalize(to_eye + to_light);
    float n_h = max(dot(n, h), 0.0);
    float n_l = max(dot(n, to_light), 0.0);
    float n_v = abs(dot(n, to_eye)) + 1e-4;
    float a2 = alpha * alpha;
    float d = n_h * n_h * (a2 - 1.0) + 1.0;
    float distribution = a2 / (kHwPi * d * d);
    float visibility = 0.5 / max(mix(2.0 * n_l * n_v, n_l + n_v, alpha), 1e-4);
    float away = clamp(1.0 - dot(to_eye, h), 0.0, 1.0);
    float away_squared = away * away;
    vec3 fresnel = f0 + (1.0 - f0) * (away_squared * away_squared * away);
    return fresnel * (distribution * visibility);
}

// What the material sends to the eye, luminance.
vec3 hw_lit(HwSurface s, HwMaterial m)
{
#ifdef HW_UNLIT
    return m.base_colour / hw_exposure;
#else
    vec3 n = m.normal_world;
    float roughness = clamp(m.roughness, 0.08, 1.0);
    float alpha = roughness * roughness;
    vec3 f0 = mix(vec3(0.04), m.base_colour, m.metallic);
    vec3 diffuse = m.base_colour * (1.0 - m.metallic);
    // One highlight for all lights, where most of the light comes from.
    vec3 to_light;
    vec3 illuminance = hw_direct(s, n, to_light);
    vec3 specular = hw_specular(n, s.to_eye_world, to_light, f0, alpha);
#ifdef HW_LIGHTMAP
    // What was baked knows the surface's own normal alone: a normal map turns it as it turns light that nothing hides.
    float around_lux = kHwPi * hw_luminance(hw_ambient(s.normal_world));
    float relief_lux = hw_luminance(illuminance);
    float flat_lux = relief_lux * max(dot(s.normal_world, to_light), 0.05) / max(dot(n, to_light), 0.05);
    vec3 baked = hw_baked_illuminance();
    float open = clamp(hw_luminance(baked) / max(around_lux + flat_lux, 1e-3), 0.0, 1.0);
    vec3 all_around = baked * ((around_lux + relief_lux) / (max(around_lux + flat_lux, 1e-3) * kHwPi));
    vec3 result = m.emissive / hw_exposure + illuminance * specular * open;
#else
    float open = 1.0;
    // Light around a coloured thing has met it, or its like, before: shade is richer in colour than light.
    vec3 all_around = hw_ambient(n) * (0.75 + 0.75 * m.base_colour);
    vec3 result = m.emissive / hw_exposure + illuminance * (diffuse / kHwPi + specular);
#endif
    float n_v = clamp(dot(n, s.to_eye_world), 0.0, 1.0);
    // Karis' fit of the split-sum table: reflection of an even surrounding by a rough surface.
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a004 = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
    vec2 ab = vec2(-1.04, 1.04) * a004 + r.zw;
    vec3 reflected = hw_surroundings(reflect(-s.to_eye_world, n), roughness) * (f0 * ab.x + ab.y);
    return result + m.occlusion * (diffuse * all_around + open * reflected);
#endif
}

// Luminance to a colour of the picture, linear, 1 is paper white: exposure, then the curve of a film that saturates, which
// rolls highlights off softly and lets them lose their colour, and keeps depth in shade.
vec3 hw_display(vec3 luminance)
{
#ifdef HW_UNLIT
    return luminance * hw_exposure;
#else
    vec3 density = 1.0 - exp2(luminance * (-4.2 * hw_exposure));
    return density * (0.5 + 0.5 * density);
#endif
}

// How light a matte white face would look here, 0 to 1, even to the eye (a gray of the picture, not linear light): what
// hatching, cartoon steps and shade go by.
float hw_light_tone(HwSurface s, vec3 normal_world)
{
#ifdef HW_LIGHTMAP
    float luminance = hw_luminance(hw_baked_illuminance()) * (1.0 / kHwPi);
#else
    float luminance = hw_luminance(hw_ambient(normal_world)) + hw_direct_gray(s, normal_world) * (1.0 / kHwPi);
#endif
    float x = luminance * hw_exposure;
    return sqrt(clamp(1.0 - exp2(-2.3 * x), 0.0, 1.0));
}
