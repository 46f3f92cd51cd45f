#version 330 core
in vec3 facing;
#ifdef BY_DEVIATION
in vec3 light;
in float deviation;
#else
in vec3 shaded;
in vec3 beyond;
#endif
in float gloss;

uniform vec3 half_way;                   // unit, between key light and eye
uniform vec3 to_eye, up, right;          // unit
uniform vec3 over_colour;                // as the screen shows it
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
  vec3 n = facing * inversesqrt(dot(facing, facing));
  float s = max(dot(n, half_way), 0.0);
  float s4 = s * s * s * s;
  float s16 = s4 * s4 * s4 * s4;
#ifdef BY_DEVIATION
  float s64 = s16 * s16 * s16 * s16;
  vec3 lit = difference(deviation) * light + vec3(gloss * (0.22 * s64 + 0.05 * s16));
  colour = vec4(sqrt(min(lit, vec3(1.0))), 1.0);
#else
  // Cut beyond the leeway: hatched.
  float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) * 0.1);
  vec3 surface = mix(shaded, over_colour * beyond.x, beyond.y > 0.5 ? (stripe < 0.5 ? 1.0 : 0.25) : 0.0);
  // A wet surface mirrors the lamp's square face.
  vec3 mirrored = 2.0 * dot(n, to_eye) * n - to_eye;
  vec2 place = vec2(dot(mirrored, right) + 0.50, dot(mirrored, up) - 0.62);
  vec2 inside = clamp((vec2(0.20, 0.14) - abs(place)) * 6.0 + 0.5, 0.0, 1.0);
  float face = inside.x * inside.y;
  float shine = gloss * (0.75 * face * face * beyond.z + 0.14 * s16);
  colour = vec4(surface + shine * (1.0 - surface), 1.0);
#endif
}
