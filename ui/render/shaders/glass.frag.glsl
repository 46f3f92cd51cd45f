#version 330 core
// What the mirror shows where neither tooth nor gums stand: the dim mouth.
in vec2 place;
out vec4 colour;
void main() {
  float edge = dot(place, place);
  colour = vec4(mix(vec3(0.40, 0.36, 0.35), vec3(0.26, 0.22, 0.22), edge), 1.0);
}
