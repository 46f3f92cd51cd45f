#version 330 core
in vec2 place;
uniform vec3 middle, edge;
out vec4 colour;
void main() {
  float t = clamp(length(place * vec2(0.75, 0.75)), 0.0, 1.0);
  colour = vec4(mix(middle, edge, t * t), 1.0);
}
