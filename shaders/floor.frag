#version 330 core

// A lit floor with shadows.

in vec3 place;
in vec3 eye_normal;

uniform vec3 colour;
uniform vec2 lower;  // corners of the floor, m
uniform vec2 upper;
uniform sampler2D ground_light;

out vec4 fragment;

const vec3 light = vec3(-0.35, 0.70, 0.62);

void main() {
  float brightness = 0.68 + 0.38 * max(dot(normalize(eye_normal), light), 0.0);
  float shade = texture(ground_light, (place.xy - lower) / (upper - lower)).r;
  fragment = vec4(colour * brightness * shade, 1.0);
}
