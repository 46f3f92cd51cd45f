#version 330 core
in vec3 lit;
uniform vec2 work_px;    // the bur's tip, from the lower left corner
uniform vec2 fade;       // of the squared way from there: clear up to the first; 1 / (second - first), as solid as it becomes from there
uniform float most_share;
out vec4 colour;
void main() {
  vec2 away = gl_FragCoord.xy - work_px;
  float share = clamp((dot(away, away) - fade.x) * fade.y, 0.0, 1.0);
  if (share <= 0.0) discard;
  colour = vec4(lit, most_share * share);
}
