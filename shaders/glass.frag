#version 330 core

// A pane of glass: nearly clear from the front, and the more a mirror the flatter it is looked at (Schlick 1994).

in vec3 eye_place;
in vec3 eye_normal;

uniform mat4 projection;
uniform vec3 colour;

out vec4 fragment;

void main() {
  vec3 to_eye = projection[2][3] == 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(-eye_place);
  float facing = abs(dot(normalize(eye_normal), to_eye));
  fragment = vec4(colour, 0.07 + 0.35 * pow(1.0 - facing, 4.0));
}
