#version 330 core
// A body of revolution in the tool's frame: pivot at the origin, z towards the shank.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float cutting;  // 1 on the blades, 0 on neck and shank
uniform mat4 clip_from_world;
uniform mat4 world_from_tool;
out vec3 at;
out vec3 facing;
out vec3 tool;
out float blades;
void main() {
  vec4 world = world_from_tool * vec4(position, 1.0);
  at = world.xyz;
  facing = mat3(world_from_tool) * normal;
  tool = position;
  blades = cutting;
  gl_Position = clip_from_world * world;
}
