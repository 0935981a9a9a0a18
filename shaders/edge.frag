#version 330 core

in vec3 place;

uniform vec3 colour;
uniform vec3 clip_min;  // m
uniform vec3 clip_max;  // m

out vec4 fragment;

void main() {
  if (any(lessThan(place, clip_min)) || any(greaterThan(place, clip_max))) discard;
  fragment = vec4(colour, 1.0);
}
