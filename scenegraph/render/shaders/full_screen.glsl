// The fragment side of full-screen passes: hw_v_uv is 0..1 from the bottom left, images given by Uniforms are sampler2D.
#include "frame.glsl"

layout(location = 0) out vec4 hw_fragment;
in vec2 hw_v_uv;
