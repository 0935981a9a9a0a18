#version 330 core

// A particle as a point that just covers its sphere.

layout(location = 0) in vec3 position;
layout(location = 1) in float value;
layout(location = 2) in float radius;  // m

uniform mat4 view;
uniform mat4 projection;
uniform vec2 margin;         // part of the drawn area that the target takes
uniform float focal_length;  // samples per metre at unit clip w

out float centre_z;
flat out float field;
flat out float sphere_radius;

void main() {
  vec4 eye = view * vec4(position, 1.0);
  centre_z = eye.z;
  field = value;
  sphere_radius = radius;
  gl_Position = projection * eye;
  gl_Position.xy *= margin;
  gl_PointSize = max(2.0 * radius * focal_length / max(gl_Position.w, 1e-6), 1.5);
}
