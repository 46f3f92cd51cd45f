#version 330 core
in vec3 at;
in vec3 facing;
in vec3 tool;
in float blades;
uniform vec3 eye;
uniform vec3 key_light, up;
uniform float turn;     // angle of the blades; below 0: turning too fast to see them
uniform float radius;
uniform float share;    // how solid it is drawn
out vec4 colour;
void main() {
  vec3 n = normalize(facing);
  vec3 to_eye = normalize(eye - at);
  vec3 metal = vec3(0.50, 0.53, 0.59);
  float dark = 1.0;
  if (blades > 0.5) {
    metal = vec3(0.40, 0.41, 0.44);
    if (turn >= 0.0) {
      float angle = atan(tool.y, tool.x) + 0.9 * tool.z / radius + turn;
      dark = 0.55 + 0.45 * smoothstep(-0.5, 0.3, sin(8.0 * angle));
    } else {
      dark = 0.85;
    }
  }
  // A studio in a line: bright above, a band of shade at the side, the floor below.
  vec3 mirrored = reflect(-to_eye, n);
  float sky = dot(mirrored, up);
  float side = dot(n, normalize(cross(up, to_eye)));
  float band = mix(0.55, 1.0, smoothstep(0.75, -0.35, side)) * (smoothstep(-0.9, 0.1, sky) * 0.25 + 0.75);
  float key = max(dot(n, key_light), 0.0);
  vec3 h = normalize(key_light + to_eye);
  float s = max(dot(n, h), 0.0);
  float s4 = s * s * s * s;
  float s16 = s4 * s4 * s4 * s4;
  vec3 lit = metal * dark * (0.52 + 0.70 * key) * band + vec3(0.30) * s16 * dark + metal * 0.25 * smoothstep(0.3, 0.9, sky);
  colour = vec4(sqrt(clamp(lit, 0.0, 1.0)), share);
}
