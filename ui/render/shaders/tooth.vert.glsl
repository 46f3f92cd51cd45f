#version 330 core
// Position and normal in the specimen frame (mm). What costs is done here, once a vertex, not once a pixel.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in uvec4 kind;    // tissue, cut, ambient, beyond
layout(location = 3) in float value;   // mm from the target

uniform mat4 clip_from_world;
uniform vec3 tissue_colour[32];        // linear light
uniform vec4 clip_plane;               // kept where dot(plane, (position, 1)) >= 0
uniform int by_deviation;
uniform int show_target;
uniform vec3 target_colour;            // linear light

out vec3 at;
out vec3 facing;
out vec3 base;
out vec3 light;     // ambient, gloss, beyond the leeway
out float deviation;

void main() {
  gl_Position = clip_from_world * vec4(position, 1.0);
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1.0));
  at = position;
  facing = normal;
  deviation = value;
  float ambient = float(kind.z) / 255.0;
  float cut = float(kind.y) / 255.0;
  base = tissue_colour[min(kind.x, 31u)];
  // Only enamel left whole shines; a burr leaves it matt.
  float gloss = (kind.x == 1u ? 1.0 : 0.45) * (1.0 - 0.7 * cut);
  if (by_deviation == 0 && show_target != 0 && cut < 0.5 && value < 0.0)
    base = mix(base, target_colour, 0.16);
  light = vec3(ambient, gloss, float(kind.w) / 255.0);
}
