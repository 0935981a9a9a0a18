#version 330 core

// The visible half of the sphere: its normal gives the light, its bulge the depth.

in vec3 centre;
flat in vec3 colour;
flat in float smallness;

uniform mat4 projection;
uniform float radius;

out vec4 fragment;

const vec3 light = vec3(-0.35, 0.70, 0.62);

void main() {
  vec2 across = vec2(2.0 * gl_PointCoord.x - 1.0, 1.0 - 2.0 * gl_PointCoord.y);
  float distance_squared = dot(across, across);
  // Round points of a few samples leave holes in a surface and flicker; they become flat squares.
  if (distance_squared > 1.0 + smallness) discard;
  vec3 normal = vec3(across, sqrt(max(1.0 - distance_squared, 0.0)));
  normal = normalize(mix(normal, vec3(0.0, 0.0, 1.0), smallness));
  float z = centre.z + radius * normal.z;
  float clip_z = projection[2][2] * z + projection[3][2];
  float clip_w = projection[2][3] * z + projection[3][3];
  gl_FragDepth = 0.5 * clip_z / clip_w + 0.5;
  float brightness = 0.68 + 0.38 * max(dot(normal, light), 0.0);
  fragment = vec4(colour * brightness, 1.0);
}
