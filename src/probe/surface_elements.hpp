#pragma once

#include "core/shape.hpp"

#include <vector>

namespace eisph {

/// A small piece of a surface, for sums over it.
struct SurfaceElement {
  Vec3d point = Vec3d::Zero();   ///< m, its middle
  Vec3d normal = Vec3d::Zero();  ///< unit vector, outwards
  double area = 0.0;             ///< m^2 (m in two dimensions)
};

/// Midpoints of pieces no longer than `spacing` (m) that make up the whole surface of a shape. The areas add
/// up to that of the shape. In two dimensions the outline in x and z; a sphere is a disc there, a cylinder is
/// not used.
[[nodiscard]] std::vector<SurfaceElement> surface_elements(const Shape& shape, double spacing, int dimension);

/// The same for a flat disc or square about `centre`, of diameter or side `size` (m), with `normal` (unit
/// vector). One pair of the square's sides is horizontal; on a floor or ceiling they lie along x and y. In
/// two dimensions both are a line. A size of zero gives one element of area 1.
[[nodiscard]] std::vector<SurfaceElement> disc_elements(const Vec3d& centre, const Vec3d& normal, double size,
                                                        double spacing, int dimension);
[[nodiscard]] std::vector<SurfaceElement> square_elements(const Vec3d& centre, const Vec3d& normal,
                                                          double size, double spacing, int dimension);

}  // namespace eisph
