#version 330 core

// A particle as a point that just covers its sphere.

layout(location = 0) in vec3 position;
layout(location = 1) in float value;

uniform mat4 view;
uniform mat4 projection;
uniform vec2 margin;          // part of the drawn area that the target takes
uniform float radius;         // m
uniform float focal_length;   // samples per metre at unit clip w
uniform float lower;          // field value of the colour map's first row
uniform float upper;          // field value of its last row
uniform sampler2D colour_map;

out vec3 centre;
flat out vec3 colour;
flat out float smallness;  // 0: a clear disc; 1: too few samples to show a shape

void main() {
  vec4 eye = view * vec4(position, 1.0);
  centre = eye.xyz;
  gl_Position = projection * eye;
  gl_Position.xy *= margin;
  gl_PointSize = max(2.0 * radius * focal_length / max(gl_Position.w, 1e-6), 1.5);
  smallness = clamp((6.0 - gl_PointSize) / 3.0, 0.0, 1.0);
  float fraction = clamp((value - lower) / (upper - lower), 0.0, 1.0);
  float rows = float(textureSize(colour_map, 0).x);
  colour = textureLod(colour_map, vec2((0.5 + fraction * (rows - 1.0)) / rows, 0.5), 0.0).rgb;
}
