#version 330 core
// A ribbon of constant width in pixels, a little before the surface that it lies on.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 corner;    // along (0 or 1), across (-1 or 1), mm along the line at `from`

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform vec2 view_px;
uniform float half_px;
uniform float lift_mm;

out float across_px;
out float along_mm;

void main() {
  vec3 end = corner.x < 0.5 ? from : to;
  vec3 lifted_from = from + normalize(eye - from) * lift_mm;
  vec3 lifted_to = to + normalize(eye - to) * lift_mm;
  vec4 a = clip_from_world * vec4(lifted_from, 1.0);
  vec4 b = clip_from_world * vec4(lifted_to, 1.0);
  vec2 step_px = (b.xy / b.w - a.xy / a.w) * 0.5 * view_px;
  float size = length(step_px);
  vec2 along = size > 1e-4 ? step_px / size : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  float reach = half_px + 1.0;
  vec4 p = corner.x < 0.5 ? a : b;
  vec2 shift = side * corner.y * reach + along * (corner.x < 0.5 ? -0.35 : 0.35) * half_px;
  p.xy += shift / (0.5 * view_px) * p.w;
  gl_Position = p;
  across_px = corner.y * reach;
  along_mm = corner.z + length(end - from);
}
