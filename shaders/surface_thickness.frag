#version 330 core

flat in float amount;

uniform sampler2D opaque_depth;
uniform int factor;  // samples of the opaque picture per sample of this one, along each axis

out float fragment;

void main() {
  vec2 across = 2.0 * gl_PointCoord - 1.0;
  float fade = max(1.0 - dot(across, across), 0.0);
  // Water behind a solid is not looked through.
  ivec2 place = min(ivec2(gl_FragCoord.xy) * factor + factor / 2, textureSize(opaque_depth, 0) - 1);
  fragment = gl_FragCoord.z > texelFetch(opaque_depth, place, 0).r ? 0.0 : amount * fade * fade;
}
