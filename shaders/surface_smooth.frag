#version 330 core

// One direction of a narrow-range filter of distances (N. Truong and C. Yuksel, A narrow-range filter for
// screen-space fluid rendering, Proc. ACM Comput. Graph. Interact. Tech. 1, 2018): Gaussian weights; what lies
// before the surface takes no part, what lies behind it counts as just behind it, which rounds edges, and the range
// widens along a surface that slopes. Taps come in pairs, so that a slope stays as it is; a pair of which both are
// behind does not count, so that a drop on the floor is not drawn into it.

uniform sampler2D surface;  // r: distance along the view axis, m, 0 without water; g: value of the field
uniform vec2 direction;     // of the taps, (1, 0) or (0, 1)
uniform mat4 projection;
uniform float focal_length;  // samples per metre at unit clip w
uniform float reach;         // of the filter, m: two standard deviations
uniform float range;         // m of distance that belong to the surface

out vec2 fragment;

const int kMostTaps = 24;  // on each side

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  vec2 here = texelFetch(surface, place, 0).rg;
  fragment = here;
  if (here.r <= 0.0) return;
  float w = projection[3][3] - projection[2][3] * here.r;
  float samples = reach * focal_length / w;
  int taps = clamp(int(samples), 1, kMostTaps);
  float stride = max(samples / float(taps), 1.0);
  ivec2 last = textureSize(surface, 0) - 1;
  float nearest = here.r - range;
  float farthest = here.r + range;
  float behind = here.r + 0.08 * range;
  vec2 sum = here;
  float weights = 1.0;
  for (int k = 1; k <= taps; ++k) {
    ivec2 offset = ivec2(round(float(k) * stride * direction));
    vec2 a = texelFetch(surface, clamp(place - offset, ivec2(0), last), 0).rg;
    vec2 b = texelFetch(surface, clamp(place + offset, ivec2(0), last), 0).rg;
    bool a_behind = a.r <= 0.0 || a.r > farthest;
    bool b_behind = b.r <= 0.0 || b.r > farthest;
    if (a_behind && b_behind) continue;
    if (a_behind) a = vec2(behind, here.g);
    if (b_behind) b = vec2(behind, here.g);
    if (a.r < nearest || b.r < nearest) continue;
    float fraction = float(k) / float(taps);
    float weight = exp(-2.0 * fraction * fraction);
    sum += weight * (a + b);
    weights += 2.0 * weight;
    nearest = min(nearest, min(a.r, b.r) - range);
    if (!a_behind) farthest = max(farthest, a.r + range);
    if (!b_behind) farthest = max(farthest, b.r + range);
  }
  fragment = sum / weights;
}
