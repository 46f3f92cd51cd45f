#version 330 core
// One triangle over the whole view.
out vec2 place;  // -1 to 1
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  place = corner;
  gl_Position = vec4(corner, 1.0, 1.0);
}
