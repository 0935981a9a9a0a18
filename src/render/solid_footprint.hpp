#pragma once

#include "core/scene.hpp"
#include "render/colour.hpp"
#include "render/image.hpp"

#include <utility>
#include <vector>

namespace eisph {

/// Obstacles, dams and gates as they stand at one time, seen from above (three dimensions) or in section
/// (two).
class SolidFootprint {
 public:
  /// Time in seconds.
  SolidFootprint(const Scene& scene, double time);

  [[nodiscard]] bool empty() const { return shapes_.empty(); }
  /// Signed distance (m) of a point of the plan to the nearest solid, and whether that is a gate. From above
  /// the plan is (x, y); in section it is (x, z).
  [[nodiscard]] std::pair<double, bool> distance(double first, double second) const;
  /// Paints one pixel of a solid whose edge is `pixels` away (negative inside): filled, with a darker
  /// outline.
  void paint(Image& image, int x, int y, double pixels, const Colour& colour) const;

 private:
  struct Part {
    Shape shape;
    bool gate;
  };
  int dimension_;
  std::vector<Part> shapes_;
};

}  // namespace eisph
