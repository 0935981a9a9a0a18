#version 330 core

// Interface: positions in pixels from the upper left corner.

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 tint;

uniform vec2 size;    // of the interface, in its units
uniform vec2 origin;  // its upper left corner

out vec2 texture_place;
out vec4 colour;

void main() {
  texture_place = place;
  colour = tint;
  vec2 across = 2.0 * (position - origin) / size - 1.0;
  gl_Position = vec4(across.x, -across.y, 0.0, 1.0);
}
