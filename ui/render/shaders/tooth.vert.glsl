#version 330 core
// Position and normal in the specimen frame (mm). The light is reckoned here, once a vertex: the mesh is finer than the
// light changes, and there are ten times more pixels than vertices. Only the gloss is left to the pixel.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal_thin;  // normal; how much light comes through from behind
layout(location = 2) in uvec4 kind;        // tissue, cut, ambient, beyond
layout(location = 3) in float value;       // mm from the target
layout(location = 4) in vec4 look;         // square root of the body's colour; share of enamel

uniform mat4 clip_from_world;
uniform vec4 clip_plane;               // kept where dot(plane, (position, 1)) >= 0
uniform int show_target;
uniform vec3 target_colour;            // linear light
uniform vec3 eye;
uniform vec3 key_light, fill_light, back_light, up;  // unit, towards the light
uniform vec4 bur;                      // pivot, radius; radius 0: none
uniform vec3 bur_axis;
uniform vec4 lamp;                     // middle of its beam, radius

uniform vec3 right, to_eye;            // unit; with up the frame of the view

// Two of four numbers each: what is interpolated costs software OpenGL as much as what is reckoned.
out vec4 facing;     // normal in the view's frame; gloss
#ifdef BY_DEVIATION
out vec4 light;      // that reaches the eye from a white surface; mm from the target
#else
out vec4 shaded;     // as the screen shows it; cut beyond the leeway
#endif

const vec3 key_colour = 1.80 * vec3(1.0, 0.955, 0.875);
const vec3 fill_colour = 0.45 * vec3(0.86, 0.93, 1.0);
const vec3 back_colour = 0.49 * vec3(0.90, 0.96, 1.0);
const vec3 sky = vec3(0.38, 0.395, 0.42), ground = vec3(0.27, 0.22, 0.17);
const vec3 rim_colour = vec3(0.66, 0.73, 0.80);      // enamel lets light through at its edge
const vec3 bounced = vec3(0.46, 0.42, 0.36);         // light that comes from wall to wall
const vec3 from_floor = vec3(1.4, 1.32, 1.18);         // the handpiece's own light, back from the floor to a wall
const uint gingiva = 7u, pulp = 5u;

/// Linear light to what the screen shows. Dark tissue keeps the colour that it is told apart by; white fades slowly.
vec3 screen(vec3 linear) { return sqrt(1.0 - exp2(-linear * (0.75 + 0.48 * linear))); }

void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  vec3 normal = normal_thin.xyz;
  float cut = float(kind.y) / 255.0;
  float enamel = look.w;
  float whole = enamel * (1.0 - cut);

  float ambient = float(kind.z) / 255.0;
  // The bur keeps light away from what is close to it.
  vec3 from_bur = position - bur.xyz;
  float along = max(dot(from_bur, bur_axis), 0.0);
  float apart = length(from_bur - along * bur_axis) - bur.w;
  if (bur.w > 0.0) ambient *= mix(0.55, 1.0, clamp(apart / (1.6 * bur.w), 0.0, 1.0));
  // A cavity's walls light each other.
  float open = mix(ambient, sqrt(ambient), 0.75 * cut);
  float lit = mix(mix(0.14, 0.45, cut), 1.0, smoothstep(0.10, 0.85, open));
#ifdef BY_DEVIATION
  open = 0.45 + 0.55 * open;  // the map's colours are to be read at the bottom of a hole too
  lit = 0.4 + 0.6 * lit;
#endif

  // Tissue carries light a little round its edge, red light furthest; what a bur left is rough and carries none.
  vec3 wrap = mix(vec3(0.38, 0.30, 0.25), vec3(0.12), cut);
  vec3 key = max((dot(normal, key_light) + wrap) / (1.0 + wrap), vec3(0.0));
  float fill = max(dot(normal, fill_light), 0.0);
  float behind = max(dot(normal, back_light), 0.0);
  vec3 warm = open * (1.0 + (1.0 - open) * vec3(0.25, 0.08, -0.06));  // what light has gone through
  vec3 total = key * key_colour * lit + warm * (fill * fill_colour + behind * back_colour + mix(ground, sky, 0.5 + 0.5 * dot(normal, up)));
  float nearly = max(dot(normal, normalize(eye - position)), 0.0);
  total += cut * ((1.0 - ambient) * bounced + nearly * (1.0 - nearly) * from_floor);
  // The lamp lights where one looks; towards the edge of its beam it fades.
  total *= mix(1.06, 0.62, smoothstep(0.35, 1.9, distance(position, lamp.xyz) / lamp.w));
  float aslant = 1.0 - nearly;

#ifdef BY_DEVIATION
  light = vec4(0.06 + 0.40 * total, value);
  float gloss = 0.25 * open;
#else
  float thin = normal_thin.w;
  total += thin * open * (0.12 + 0.25 * (0.5 - 0.5 * dot(normal, back_light))) * vec3(0.8, 0.95, 1.1);
  vec3 body = look.rgb * look.rgb;
  if (show_target != 0 && cut < 0.5 && value < 0.0) body = mix(body, target_colour, 0.16);
  float edge = aslant * aslant * aslant;
  body = mix(body, rim_colour, 0.28 * edge * whole);
  // Enamel left whole is wet, gums and pulp are moist, what a bur left is matt.
  float wet = mix(kind.x == gingiva || kind.x == pulp ? 0.55 : 0.16, mix(1.0, 0.28, cut), enamel);
  float gloss = wet * ambient * ambient;
  shaded.rgb = screen(body * total + gloss * (0.035 + 0.55 * edge * aslant) * sky);
  shaded.a = show_target != 0 ? float(kind.w) / 255.0 : 0.0;
#endif
  facing = vec4(dot(normal, right), dot(normal, up), dot(normal, to_eye), gloss);
}
