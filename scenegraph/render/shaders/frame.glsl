// What one frame's shaders share. Filled by render/frame_block.cpp; the two must agree.

const int kHwMaxLights = 8;

layout(std140) uniform HwFrame {
    mat4 hw_view_from_world;
    mat4 hw_clip_from_view;
    mat4 hw_shadow_from_local;          // to [0, 1] coordinates of the shadow map
    vec4 hw_eye_world_time;             // xyz metres, w seconds
    vec4 hw_eye_local;                  // xyz metres from where local positions count: near the eye, where that is far away
    vec4 hw_to_viewer;                  // xyz unit, in a parallel projection: from the scene to the viewer
    vec4 hw_size_scale_focal;           // xy device pixels, z device pixels per logical pixel, w pixels per unit slope, or
                                        // in a parallel projection per metre
    vec4 hw_exposure_near_far;          // x exposure factor, y near, z far, w 1 when the view is orthographic
    vec4 hw_background_linear;          // rgb
    vec4 hw_ambient_sky;                // rgb, light from above, as luminance
    vec4 hw_ambient_ground;             // rgb, light from below
    vec4 hw_shadow_params;              // x 1/size, y world size of a texel; the light is number 0
    vec4 hw_light_position[kHwMaxLights];   // xyz local; w 0 sun, 1 point, 2 spot
    vec4 hw_light_direction[kHwMaxLights];  // xyz unit, from the light; w range in metres, 0 unlimited
    vec4 hw_light_colour[kHwMaxLights];     // rgb times lux or candela, w their luminance
    vec4 hw_light_cone[kHwMaxLights];       // x scale, y offset: falloff = clamp(cosine * x + y, 0, 1) squared
};

#define hw_eye_world (hw_eye_world_time.xyz)
#define hw_time_s (hw_eye_world_time.w)
#define hw_size_px (hw_size_scale_focal.xy)
#define hw_px_scale (hw_size_scale_focal.z)
#define hw_focal_px (hw_size_scale_focal.w)
#define hw_exposure (hw_exposure_near_far.x)
#define hw_is_parallel (hw_exposure_near_far.w > 0.5)
