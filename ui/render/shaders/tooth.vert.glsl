#version 330 core
// Position and normal in the specimen frame (mm). The light is reckoned here, once a vertex: the mesh is finer than the
// light changes, and there are ten times more pixels than vertices. Only the gloss is left to the pixel.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uvec4 kind;    // tissue, cut, ambient, beyond
layout(location = 3) in float value;   // mm from the target

uniform mat4 clip_from_world;
uniform vec3 tissue_colour[32];        // linear light
uniform vec4 clip_plane;               // kept where dot(plane, (position, 1)) >= 0
uniform int show_target;
uniform vec3 target_colour;            // linear light
uniform vec3 eye;
uniform vec3 key_light, fill_light, up;  // unit, towards the light
uniform vec4 bur;                     // pivot, radius; radius 0: none
uniform vec3 bur_axis;
uniform vec4 lamp;                     // middle of its beam, radius

out vec3 facing;
out vec3 base;
out vec3 light;      // that reaches the eye from a white surface
out float gloss;
out float beyond;    // the leeway
out float deviation;

#ifdef BY_DEVIATION
const vec3 key_colour = vec3(0.72);
const vec3 shade_colour = vec3(0.55);
const vec3 edge_colour = vec3(0.70);
#else
const vec3 key_colour = vec3(0.78, 0.735, 0.645);
const vec3 shade_colour = vec3(0.50, 0.40, 0.29);   // what light has gone through: warm brown
const vec3 edge_colour = vec3(0.62, 0.58, 0.48);    // enamel lets light through at its edge
#endif

void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  facing = normal;
  deviation = value;
  beyond = show_target != 0 ? float(kind.w) / 255.0 : 0.0;
  float cut = float(kind.y) / 255.0;
  base = tissue_colour[min(kind.x, 31u)];
  if (show_target != 0 && cut < 0.5 && value < 0.0) base = mix(base, target_colour, 0.16);

  float ambient = float(kind.z) / 255.0;
  // The bur keeps light away from what is close to it.
  vec3 from_bur = position - bur.xyz;
  float along = max(dot(from_bur, bur_axis), 0.0);
  float apart = length(from_bur - along * bur_axis) - bur.w;
  if (bur.w > 0.0) ambient *= mix(0.45, 1.0, clamp(apart / (1.6 * bur.w), 0.0, 1.0));
  float open = ambient * ambient * (3.0 - 2.0 * ambient);
#ifdef BY_DEVIATION
  open = 0.45 + 0.55 * open;  // the map's colours are to be read at the bottom of a hole too
#endif

  // Key light from the upper left, carried a little round the tooth's edge; a cool fill from the right; light from around.
  float wrapped = max(dot(normal, key_light) * 0.80 + 0.20, 0.0);
  float fill = max(dot(normal, fill_light), 0.0);
  vec3 around = mix(vec3(0.10, 0.085, 0.065), vec3(0.25, 0.25, 0.26), 0.5 + 0.5 * dot(normal, up));
  light = wrapped * (0.2 + 0.8 * open) * key_colour + open * (fill * vec3(0.09, 0.10, 0.11) + around);
  light *= mix(shade_colour, vec3(1.0), clamp(open * 1.25, 0.0, 1.0));
  // The lamp lights where one looks; towards the edge of its beam it fades.
  light *= mix(1.06, 0.62, smoothstep(0.35, 1.9, distance(position, lamp.xyz) / lamp.w));
  float to_eye = max(dot(normal, normalize(eye - position)), 0.0);
  light *= mix(edge_colour, vec3(1.0), smoothstep(0.0, 0.55, to_eye));

  // Only enamel left whole shines, a neighbour's too; a bur leaves it matt.
#ifdef BY_DEVIATION
  gloss = 0.25 * open;
#else
  gloss = (kind.x == 1u || kind.x == 29u ? 1.0 : 0.45) * (1.0 - 0.7 * cut) * open;
#endif
}
