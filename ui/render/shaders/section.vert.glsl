#version 330 core
uniform mat4 clip_from_world;
uniform vec3 corner, right, up;  // upper left corner, and the picture's whole width and height
out vec2 place;
void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = clip_from_world * vec4(corner + place.x * right - place.y * up, 1.0);
}
