#version 330 core

in vec3 eye_normal;

uniform vec3 colour;

out vec4 fragment;

const vec3 light = vec3(-0.35, 0.70, 0.62);

void main() {
  float brightness = 0.68 + 0.38 * max(dot(normalize(eye_normal), light), 0.0);
  fragment = vec4(colour * brightness, 1.0);
}
