#version 330 core
in vec3 facing;
in vec3 base;
in vec3 light;
in float gloss;
in float beyond;
in float deviation;

uniform vec3 half_way;                   // unit, between key light and eye
uniform vec3 over_colour;                // linear light
uniform vec3 map_colour[5];              // linear light, -0.5 -0.3 0 +0.3 +0.5 mm

out vec4 colour;

#ifdef BY_DEVIATION
vec3 difference(float mm) {
  float size = abs(mm);
  vec3 middle = mm < 0.0 ? map_colour[1] : map_colour[3];
  vec3 end = mm < 0.0 ? map_colour[0] : map_colour[4];
  vec3 c = mix(map_colour[2], middle, clamp((size - 0.1) * 5.0, 0.0, 1.0));
  c = mix(c, end, clamp((size - 0.3) * 5.0, 0.0, 1.0));
  float line = abs(size - 0.3) / max(fwidth(mm), 1e-5);
  return c * mix(0.35, 1.0, clamp(line, 0.0, 1.0));
}
#endif

void main() {
#ifdef BY_DEVIATION
  vec3 surface = difference(deviation);
#else
  // Cut beyond the leeway: hatched.
  float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) * 0.1);
  vec3 surface = mix(base, over_colour, beyond > 0.5 ? (stripe < 0.5 ? 1.0 : 0.25) : 0.0);
#endif
  float s = max(dot(facing, half_way), 0.0) * inversesqrt(dot(facing, facing));
  float s4 = s * s * s * s;
  float s16 = s4 * s4 * s4 * s4;
  float s64 = s16 * s16 * s16 * s16;
  vec3 lit = surface * light + vec3(gloss * (0.22 * s64 + 0.05 * s16));
  colour = vec4(sqrt(min(lit, vec3(1.0))), 1.0);
}
