#version 330 core

in vec2 texture_place;
in vec4 colour;

uniform sampler2D image;

out vec4 fragment;

void main() { fragment = colour * texture(image, texture_place); }
