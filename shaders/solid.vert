#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 view;
uniform mat4 projection;

out vec3 place;      // m
out vec3 eye_place;  // m
out vec3 eye_normal;

void main() {
  place = position;
  vec4 eye = view * vec4(position, 1.0);
  eye_place = eye.xyz;
  eye_normal = mat3(view) * normal;
  gl_Position = projection * eye;
}
