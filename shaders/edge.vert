#version 330 core

// A line segment as a rectangle of constant width on the screen: instance k is segment k, and the six vertices
// make its two triangles.

layout(location = 0) in vec3 first;
layout(location = 1) in vec3 second;

uniform mat4 view;
uniform mat4 projection;
uniform vec2 size;    // of the target, samples
uniform float width;  // of the line, samples

out vec3 place;

void main() {
  place = int[6](0, 1, 2, 2, 1, 3)[gl_VertexID] < 2 ? first : second;
  vec4 a = projection * (view * vec4(first, 1.0));
  vec4 b = projection * (view * vec4(second, 1.0));
  // Cut off what lies before the near plane, where the division below means nothing.
  float before_a = a.z + a.w;
  float before_b = b.z + b.w;
  if (before_a <= 0.0 && before_b <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  if (before_a <= 0.0) a = mix(a, b, (1e-5 - before_a) / (before_b - before_a));
  if (before_b <= 0.0) b = mix(b, a, (1e-5 - before_b) / (before_a - before_b));

  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  float span = length(along);
  along = span > 0.0 ? along / span : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  int corner = int[6](0, 1, 2, 2, 1, 3)[gl_VertexID];
  vec4 end = corner < 2 ? a : b;
  float side = (corner & 1) == 0 ? -1.0 : 1.0;
  float beyond = corner < 2 ? -0.3 : 0.3;
  vec2 offset = (0.5 * side * across + beyond * along) * width * 2.0 / size;
  // Slightly nearer than the surface it outlines.
  gl_Position = vec4(end.xy + offset * end.w, end.z - 4e-4 * end.w, end.w);
}
