#version 330 core
in vec4 facing;
#ifdef BY_DEVIATION
in vec4 light;
#else
in vec4 shaded;
#endif

uniform vec3 half_way;                   // unit, between key light and eye; in the view's frame, as facing
uniform vec3 over_colour;                // as the screen shows it
uniform float stripes_a_px;              // of the hatching, along either axis of the framebuffer
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
  float shorter = 1.0 / dot(facing.xyz, facing.xyz);
  float s = max(dot(facing.xyz, half_way), 0.0);
  float s2 = s * s * shorter;
  float s4 = s2 * s2;
  float s16 = s4 * s4 * s4 * s4;
#ifdef BY_DEVIATION
  float s64 = s16 * s16 * s16 * s16;
  vec3 lit = difference(light.a) * light.rgb + vec3(facing.w * (0.22 * s64 + 0.05 * s16));
  colour = vec4(sqrt(min(lit, vec3(1.0))), 1.0);
#else
  // Cut beyond the leeway: hatched.
  float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) * stripes_a_px);
  float hatch = shaded.a > 0.5 ? (stripe < 0.5 ? 1.0 : 0.25) : 0.0;
  vec3 surface = mix(shaded.rgb, over_colour * (0.25 + 0.75 * shaded.r), hatch);
  // A wet surface mirrors the lamp's square face: where the mirrored eye's way goes, right and up.
  vec2 place = 2.0 * facing.z * shorter * facing.xy + vec2(0.50, -0.62);
  vec2 inside = clamp((vec2(0.20, 0.14) - abs(place)) * 6.0 + 0.5, 0.0, 1.0);
  float face = inside.x * inside.y;
  float shine = facing.w * (0.75 * face * face * facing.w + 0.14 * s16);
  colour = vec4(surface + shine * (1.0 - surface), 1.0);
#endif
}
