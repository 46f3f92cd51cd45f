#version 330 core
// Key light from the upper left, a cool fill from the right, light from around weighted by what reaches the place.
in vec3 at;
in vec3 facing;
in vec3 base;
in vec3 light;
in float deviation;

uniform vec3 eye;
uniform vec3 key_light, fill_light, up;  // unit, towards the light
uniform int by_deviation;
uniform int show_target;
uniform vec3 over_colour;                // linear light
uniform vec3 map_colour[5];              // linear light, -0.5 -0.3 0 +0.3 +0.5 mm
uniform vec4 burr;                       // pivot, radius; radius 0: none
uniform vec3 burr_axis;

out vec4 colour;

vec3 difference(float mm) {
  float size = abs(mm);
  vec3 middle = mm < 0.0 ? map_colour[1] : map_colour[3];
  vec3 end = mm < 0.0 ? map_colour[0] : map_colour[4];
  vec3 c = mix(map_colour[2], middle, clamp((size - 0.1) * 5.0, 0.0, 1.0));
  c = mix(c, end, clamp((size - 0.3) * 5.0, 0.0, 1.0));
  float line = abs(size - 0.3) / max(fwidth(mm), 1e-5);
  return c * mix(0.35, 1.0, clamp(line, 0.0, 1.0));
}

void main() {
  vec3 n = normalize(facing);
  vec3 to_eye = normalize(eye - at);
  vec3 surface = base;
  float gloss = light.y;
  if (by_deviation != 0) {
    surface = difference(deviation);
    gloss = 0.25;
  } else if (show_target != 0 && light.z > 0.5) {
    float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) * 0.1);
    surface = mix(surface, over_colour, stripe < 0.5 ? 1.0 : 0.25);
  }

  float ambient = light.x;
  // The burr keeps light away from what is close to it.
  if (burr.w > 0.0) {
    vec3 from_burr = at - burr.xyz;
    float along = max(dot(from_burr, burr_axis), 0.0);
    float apart = length(from_burr - along * burr_axis) - burr.w;
    float shade = clamp(apart / (1.6 * burr.w), 0.0, 1.0);
    ambient *= mix(0.45, 1.0, shade);
  }

  float key = dot(n, key_light);
  float wrapped = max(key * 0.80 + 0.20, 0.0);    // light that the tooth carries round its edge
  float fill = max(dot(n, fill_light), 0.0);
  float open = ambient * ambient * (3.0 - 2.0 * ambient);
  vec3 around = mix(vec3(0.10, 0.085, 0.065), vec3(0.25, 0.25, 0.26), 0.5 + 0.5 * dot(n, up)) * open;
  float warm = by_deviation != 0 ? 0.0 : 1.0;
  vec3 key_colour = mix(vec3(0.72), vec3(0.78, 0.735, 0.645), warm);
  vec3 lit = surface * (wrapped * (0.2 + 0.8 * open) * key_colour + fill * vec3(0.09, 0.10, 0.11) * open + around);

  // Dark places take the colour of what light has gone through: warm brown.
  lit *= mix(mix(vec3(0.55), vec3(0.50, 0.40, 0.29), warm), vec3(1.0), clamp(open * 1.25, 0.0, 1.0));

  vec3 h = normalize(key_light + to_eye);
  float s = max(dot(n, h), 0.0);
  float s4 = s * s * s * s;
  float s16 = s4 * s4 * s4 * s4;
  float s64 = s16 * s16 * s16 * s16;
  float facing_eye = max(dot(n, to_eye), 0.0);
  // Enamel lets light through at its edge: darker and warmer there, with a cool gleam.
  lit *= mix(mix(vec3(0.62, 0.58, 0.48), vec3(0.7), 1.0 - warm), vec3(1.0), smoothstep(0.0, 0.55, facing_eye));
  lit += gloss * open * (0.22 * s64 + 0.05 * s16) * vec3(1.0, 0.99, 0.97);

  colour = vec4(sqrt(clamp(lit, 0.0, 1.0)), 1.0);
}
