#version 330 core

// Averages the samples of a pixel and darkens what lies behind its surroundings (eye-dome lighting: C. Boucheny,
// thesis, Grenoble 2009), which brings out waves and edges where single spheres are too small to show a slope.

uniform sampler2D samples;
uniform sampler2D depth;
uniform mat4 projection;
uniform int factor;      // samples per pixel and axis
uniform int reach;       // of the comparison, samples
uniform float strength;  // 0: none
uniform float scale;     // m, difference of depth that counts as 1

out vec4 fragment;

float distance_at(ivec2 place) {
  ivec2 inside = clamp(place, ivec2(0), textureSize(depth, 0) - 1);
  float clip = 2.0 * texelFetch(depth, inside, 0).r - 1.0;
  // Solves clip = clip_z / clip_w for the distance along the view axis.
  return -(clip * projection[3][3] - projection[3][2]) / (projection[2][2] - clip * projection[2][3]);
}

void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * factor;
  vec3 sum = vec3(0.0);
  for (int j = 0; j < factor; ++j) {
    for (int i = 0; i < factor; ++i) sum += texelFetch(samples, corner + ivec2(i, j), 0).rgb;
  }
  vec3 colour = sum / float(factor * factor);
  if (strength > 0.0) {
    ivec2 middle = corner + factor / 2;
    if (texelFetch(depth, middle, 0).r < 1.0) {
      float here = distance_at(middle);
      float behind = 0.0;
      for (int k = 0; k < 8; ++k) {
        float angle = 0.7853982 * float(k);
        float there = distance_at(middle + ivec2(round(float(reach) * vec2(cos(angle), sin(angle)))));
        behind += clamp((here - there) / scale, 0.0, 1.0);
      }
      colour *= exp(-strength * behind / 8.0);
    }
  }
  fragment = vec4(colour, 1.0);
}
