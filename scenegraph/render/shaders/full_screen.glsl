// The fragment side of full-screen passes: hw_v_uv is 0..1 from the bottom left. Images given by Uniforms are sampler2D, those
// of whole numbers usampler2D. For several outputs or whole numbers, write #define HW_OWN_OUTPUTS before the include and
// declare `layout(location = 0) out ...` yourself.
#include "frame.glsl"

#ifndef HW_OWN_OUTPUTS
layout(location = 0) out vec4 hw_fragment;
#endif
in vec2 hw_v_uv;
