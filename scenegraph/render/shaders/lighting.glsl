// Light on a surface, shared by all styles. Include after surface.glsl and shadow.glsl. Illuminance is in lux, luminance in
// candela per square metre; hw_display() makes colours of the picture of it.

const float kHwPi = 3.14159265;
const vec3 kHwLuminanceWeights = vec3(0.2126, 0.7152, 0.0722);

float hw_luminance(vec3 colour_linear) { return dot(colour_linear, kHwLuminanceWeights); }

// Light i at the surface: illuminance of a face that looks at it, lux. `to_light` is unit.
vec3 hw_illuminance(HwSurface s, int i, out vec3 to_light)
{
    float kind = hw_light_position[i].w;
    if (kind < 0.5) {
        to_light = -hw_light_direction[i].xyz;
        return hw_light_colour[i].rgb;
    }
    vec3 d = hw_light_position[i].xyz - s.position_world;
    float distance_squared = max(dot(d, d), 1e-4);
    to_light = d * inversesqrt(distance_squared);
    float falloff = 1.0 / distance_squared;
    float range = hw_light_direction[i].w;
    if (range > 0.0) {  // as KHR_lights_punctual recommends
        float share = distance_squared / (range * range);
        falloff *= clamp(1.0 - share * share, 0.0, 1.0);
    }
    if (kind > 1.5) {
        float cone = clamp(dot(hw_light_direction[i].xyz, -to_light) * hw_light_cone[i].x + hw_light_cone[i].y, 0.0, 1.0);
        falloff *= cone * cone;
    }
    return hw_light_colour[i].rgb * falloff;
}

// The index of the main light, the one with a shadow; 0 when there is none.
int hw_main_light() { return int(hw_shadow_params.z + 0.5); }

// Light from all around, luminance: what a matte white face with this normal reflects of it. The brightest part of the sky
// is the sun's side, so that what lies in shadow still shows its form; ground light keeps faces from being black.
vec3 hw_ambient(vec3 normal_world)
{
#if HW_LIGHT_COUNT > 0
    vec3 brightest = vec3(0.0, 0.75, 0.0) - 0.5 * hw_light_direction[hw_main_light()].xyz;
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

// Light i on a face with this normal, in the main light's shadow: lux.
vec3 hw_direct(HwSurface s, vec3 normal_world, int i, out vec3 to_light)
{
    vec3 illuminance = hw_illuminance(s, i, to_light) * max(dot(normal_world, to_light), 0.0);
    if (i == hw_main_light() && hw_shadow_params.w > 0.5 && illuminance.g > 0.0) illuminance *= hw_shadow(s);
    return illuminance;
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
    vec3 result = m.emissive / hw_exposure;
    for (int i = 0; i < HW_LIGHT_COUNT; ++i) {
        vec3 to_light;
        vec3 illuminance = hw_direct(s, n, i, to_light);
        if (hw_luminance(illuminance) > 0.0)
            result += illuminance * (diffuse / kHwPi + hw_specular(n, s.to_eye_world, to_light, f0, alpha));
    }
    float n_v = clamp(dot(n, s.to_eye_world), 0.0, 1.0);
    // Karis' fit of the split-sum table: reflection of an even surrounding by a rough surface.
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a004 = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
    vec2 ab = vec2(-1.04, 1.04) * a004 + r.zw;
    vec3 reflected = hw_surroundings(reflect(-s.to_eye_world, n), roughness) * (f0 * ab.x + ab.y);
    // Light around a coloured thing has met it, or its like, before: shade is richer in colour than light.
    vec3 around = hw_ambient(n) * (0.75 + 0.75 * m.base_colour);
    return result + m.occlusion * (diffuse * around + reflected);
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
    vec3 luminance = hw_ambient(normal_world);
    for (int i = 0; i < HW_LIGHT_COUNT; ++i) {
        vec3 to_light;
        luminance += hw_direct(s, normal_world, i, to_light) / kHwPi;
    }
    float x = hw_luminance(luminance) * hw_exposure;
    return sqrt(clamp(1.0 - exp2(-2.3 * x), 0.0, 1.0));
}
