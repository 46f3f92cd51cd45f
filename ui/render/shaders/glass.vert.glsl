#version 330 core
// A fan about the middle of the mirror's glass.
uniform mat4 clip_from_world;
uniform vec3 middle, right, up;  // half axes, mm
uniform int sides;
out vec2 place;  // 1 at the edge
void main() {
  float angle = 6.2831853 * float(gl_VertexID - 1) / float(sides);
  place = gl_VertexID == 0 ? vec2(0.0) : vec2(cos(angle), sin(angle));
  gl_Position = clip_from_world * vec4(middle + place.x * right + place.y * up, 1.0);
}
