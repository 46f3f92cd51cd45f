#version 330 core
// A patch of the surface, a little before it.
layout(location = 0) in vec3 at;

uniform mat4 clip_from_world;
uniform vec3 eye;
uniform float lift_mm;

void main() { gl_Position = clip_from_world * vec4(at + normalize(eye - at) * lift_mm, 1.0); }
