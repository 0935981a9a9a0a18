#pragma once

namespace eisph {

/// sRGB colour, channels 0 to 1.
struct Colour {
  float red = 0.0F;
  float green = 0.0F;
  float blue = 0.0F;

  [[nodiscard]] friend bool operator==(const Colour&, const Colour&) = default;
};

/// (1 - weight) first + weight second.
[[nodiscard]] inline Colour mix(const Colour& first, const Colour& second, float weight) {
  return {first.red + weight * (second.red - first.red), first.green + weight * (second.green - first.green),
          first.blue + weight * (second.blue - first.blue)};
}

}  // namespace eisph
