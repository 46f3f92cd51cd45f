#version 330 core
uniform vec4 ink;
uniform float stripe_px;
out vec4 colour;
void main() {
  // Stripes: the colour below stays to be seen, and the patch is told from any colour of the map.
  float along = mod(gl_FragCoord.x + gl_FragCoord.y, 2.0 * stripe_px);
  colour = vec4(ink.rgb, along < stripe_px ? ink.a : 0.35 * ink.a);
}
