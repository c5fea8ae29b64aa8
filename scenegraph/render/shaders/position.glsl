// The one place where object-space positions become positions of the picture. Every vertex stage goes through it, so that
// passes over the same faces give equal depths.

invariant gl_Position;

uniform mat4 hw_clip_from_object;

void hw_set_position(vec3 position_object) { gl_Position = hw_clip_from_object * vec4(position_object, 1.0); }
