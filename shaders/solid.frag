#version 330 core

in vec3 eye_normal;
in vec3 place;

uniform vec3 colour;
uniform vec3 clip_min;  // m
uniform vec3 clip_max;  // m

out vec4 fragment;

const vec3 light = vec3(-0.35, 0.70, 0.62);

void main() {
  if (any(lessThan(place, clip_min)) || any(greaterThan(place, clip_max))) discard;
  float brightness = 0.68 + 0.38 * max(dot(normalize(eye_normal), light), 0.0);
  fragment = vec4(colour * brightness, 1.0);
}
