#version 330 core

// Water over the opaque picture: the normal of the smoothed surface gives reflection (Fresnel's equations as C.
// Schlick 1994 approximates them) and a highlight; what is behind shows through, displaced by refraction and
// dimmed by the water's thickness (Beer and Lambert). With a field, its colour stands in for that of the water.

uniform sampler2D surface;    // r: distance along the view axis, m, 0 without water; g: value of the field
uniform sampler2D thickness;  // m
uniform sampler2D opaque_colour;
uniform sampler2D opaque_depth;
uniform sampler2D colour_map;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 size;           // of the picture, samples
uniform float focal_length;  // samples per metre at unit clip w
uniform float depth_scale;   // m, thickness at which the tint is clear
uniform float spacing;       // m, of the particles
uniform float lower;         // field value of the colour map's first row
uniform float upper;         // field value of its last row
uniform int has_field;
uniform vec3 zenith;   // colours that the water mirrors, from above
uniform vec3 horizon;  // and from the side
uniform vec3 body;     // colour of deep water

out vec4 fragment;

const vec3 light = vec3(-0.35, 0.70, 0.62);
const vec3 absorption = vec3(4.4, 1.7, 0.95);  // over depth_scale; far above that of real water, to be seen

float clip_w(float distance) { return projection[3][3] - projection[2][3] * distance; }

float window_depth(float distance) {
  return 0.5 * (projection[3][2] - projection[2][2] * distance) / clip_w(distance) + 0.5;
}

vec3 eye_place(vec2 sample_place, float distance) {
  return vec3((sample_place - 0.5 * size) * clip_w(distance) / focal_length, -distance);
}

/// Slope of the surface along one axis: of the two sides the flatter one, so that a step of the surface leaves
/// its edge alone. Dry sides do not count.
vec3 tangent(ivec2 place, ivec2 side, float here) {
  ivec2 last = textureSize(surface, 0) - 1;
  ivec2 after = clamp(place + side, ivec2(0), last);
  ivec2 before = clamp(place - side, ivec2(0), last);
  float d_after = texelFetch(surface, after, 0).r;
  float d_before = texelFetch(surface, before, 0).r;
  vec3 middle = eye_place(gl_FragCoord.xy, here);
  bool take_after = d_after > 0.0 && (d_before <= 0.0 || abs(d_after - here) < abs(here - d_before));
  if (!take_after && d_before <= 0.0) return vec3(side, 0.0);
  return take_after ? eye_place(gl_FragCoord.xy + vec2(after - place), d_after) - middle
                    : middle - eye_place(gl_FragCoord.xy + vec2(before - place), d_before);
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  float depth_behind = texelFetch(opaque_depth, place, 0).r;
  vec3 behind = texelFetch(opaque_colour, place, 0).rgb;
  gl_FragDepth = depth_behind;
  fragment = vec4(behind, 1.0);
  vec2 front = texelFetch(surface, place, 0).rg;
  if (front.r <= 0.0) return;
  float depth_here = window_depth(front.r);
  if (depth_here >= depth_behind) return;
  gl_FragDepth = depth_here;

  vec3 along_x = tangent(place, ivec2(1, 0), front.r);
  vec3 along_y = tangent(place, ivec2(0, 1), front.r);
  vec3 normal = normalize(cross(along_x, along_y));
  vec3 to_eye = projection[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-eye_place(gl_FragCoord.xy, front.r));
  float facing = clamp(dot(normal, to_eye), 0.0, 1.0);

  float way = texture(thickness, gl_FragCoord.xy / size).r;
  // The picture behind shifts with the slope and the depth of the water; not onto something before the water.
  vec2 shift = -0.25 * normal.xy * min(way, 0.35 * depth_scale) * focal_length / clip_w(front.r);
  ivec2 seen = clamp(ivec2(gl_FragCoord.xy + shift), ivec2(0), ivec2(size) - 1);
  if (texelFetch(opaque_depth, seen, 0).r > depth_here) behind = texelFetch(opaque_colour, seen, 0).rgb;

  float brightness = 0.68 + 0.38 * max(dot(normal, light), 0.0);
  vec3 colour;
  if (has_field != 0) {
    float fraction = clamp((front.g - lower) / (upper - lower), 0.0, 1.0);
    float rows = float(textureSize(colour_map, 0).x);
    vec3 tint = textureLod(colour_map, vec2((0.5 + fraction * (rows - 1.0)) / rows, 0.5), 0.0).rgb;
    colour = mix(behind, tint * brightness, 1.0 - exp(-1.2 * max(way / spacing, 1.0)));
  } else {
    // Films and drops, which would be all but clear, count as thicker.
    vec3 passed = exp(-absorption * max(way / depth_scale, 0.12));
    // What the water scatters towards the eye grows alike in all colours.
    colour = behind * passed + body * brightness * (1.0 - passed.g);
  }
  vec3 up = normalize((view * vec4(0.0, 0.0, 1.0, 0.0)).xyz);
  vec3 mirrored = reflect(-to_eye, normal);
  vec3 sky = mix(horizon, zenith, clamp(dot(mirrored, up), 0.0, 1.0));
  float fresnel = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
  // A surface in a colour of the bar stays near it.
  float gloss = has_field != 0 ? 0.5 : 1.0;
  colour = mix(colour, sky, gloss * fresnel);
  float highlight = pow(max(dot(normal, normalize(normalize(light) + to_eye)), 0.0), 90.0);
  fragment = vec4(colour + gloss * 0.55 * highlight, 1.0);
}
