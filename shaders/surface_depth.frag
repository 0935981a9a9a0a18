#version 330 core

// Distance of the sphere's visible half along the view axis, and the field's value there.

in float centre_z;
flat in float field;
flat in float sphere_radius;

uniform mat4 projection;

out vec2 fragment;

void main() {
  vec2 across = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);
  float distance_squared = dot(across, across);
  if (distance_squared > 1.0) discard;
  float z = centre_z + sphere_radius * sqrt(1.0 - distance_squared);
  float clip_z = projection[2][2] * z + projection[3][2];
  float clip_w = projection[2][3] * z + projection[3][3];
  gl_FragDepth = 0.5 * clip_z / clip_w + 0.5;
  fragment = vec2(-z, field);
}
