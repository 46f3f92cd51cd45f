#version 330 core
in vec2 place;
uniform sampler2D picture;
out vec4 colour;
void main() {
  colour = texture(picture, place);
  if (colour.a < 0.5) discard;
}
