#version 330 core
uniform vec4 ink;
uniform float stripe_px;
out vec4 colour;
void main() {
  // Ink and white by turns, so that the patch stands out of the darkest and the palest colour of the map.
  float along = mod(gl_FragCoord.x + gl_FragCoord.y, 2.0 * stripe_px);
  colour = along < stripe_px ? ink : vec4(1.0, 1.0, 1.0, 0.5 * ink.a);
}
