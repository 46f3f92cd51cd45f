#version 330 core
in float across_px;
in float along_mm;
uniform vec4 ink;
uniform float half_px;
uniform vec2 dash_mm;  // drawn, left out; drawn 0: solid
out vec4 colour;
void main() {
  if (dash_mm.x > 0.0 && mod(along_mm, dash_mm.x + dash_mm.y) > dash_mm.x) discard;
  float a = clamp(half_px + 0.5 - abs(across_px), 0.0, 1.0);
  if (a <= 0.0) discard;
  colour = vec4(ink.rgb, ink.a * a);
}
