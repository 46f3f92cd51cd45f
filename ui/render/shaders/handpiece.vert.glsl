#version 330 core
// The handpiece in its own frame, lit by vertex: it is large in the picture, and turned metal needs no more.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_world;
uniform mat4 world_from_tool;
uniform vec3 eye;
uniform vec3 key_light, up;
out vec3 lit;
void main() {
  vec4 world = world_from_tool * vec4(position, 1.0);
  vec3 n = mat3(world_from_tool) * normal;
  vec3 to_eye = normalize(eye - world.xyz);
  float key = max(dot(n, key_light), 0.0);
  float sky = 0.5 + 0.5 * dot(n, up);
  float s = max(dot(n, normalize(key_light + to_eye)), 0.0);
  float s4 = s * s * s * s;
  vec3 metal = vec3(0.66, 0.68, 0.72) * (0.34 + 0.26 * sky + 0.55 * key) + vec3(0.35) * s4 * s4 * s4;
  lit = sqrt(clamp(metal, 0.0, 1.0));
  gl_Position = clip_from_world * world;
}
