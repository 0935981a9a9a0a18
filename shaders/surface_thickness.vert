#version 330 core

// A piece of water spread over a disc.

layout(location = 0) in vec3 position;
layout(location = 1) in float volume;  // over that of a cube of the spacing

uniform mat4 view;
uniform mat4 projection;
uniform vec2 margin;         // part of the drawn area that the target takes
uniform float spacing;       // m
uniform float focal_length;  // of the thickness target, samples per metre at unit clip w

flat out float amount;  // m of water in the middle of the disc

void main() {
  vec4 eye = view * vec4(position, 1.0);
  gl_Position = projection * eye;
  gl_Position.xy *= margin;
  float spacing_on_screen = spacing * focal_length / max(gl_Position.w, 1e-6);
  float radius = max(1.5 * spacing_on_screen, 1.5);
  gl_PointSize = 2.0 * radius;
  // The mean of (1 - r^2)^2 over the disc is a third.
  amount = 3.0 * volume * spacing * spacing_on_screen * spacing_on_screen / (3.14159265 * radius * radius);
}
