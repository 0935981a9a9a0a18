#include "probe/surface_elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace eisph {

namespace {

constexpr double kPi = std::numbers::pi;

using Elements = std::vector<SurfaceElement>;

/// Pieces of at most `spacing` in `length`.
int pieces(double length, double spacing, int least = 1) {
  return std::max(least, static_cast<int>(std::ceil(length / spacing - 1e-9)));
}

/// Middle of piece k of n of an interval of the given length about zero.
double middle(int k, int n, double length) { return ((k + 0.5) / n - 0.5) * length; }

/// Directions in a plane with this normal: the first is horizontal.
void plane_axes(const Vec3d& normal, Vec3d& along, Vec3d& across) {
  const Vec3d level = Vec3d::UnitZ().cross(normal);
  along = level.norm() > 1e-9 ? Vec3d(level.normalized()) : Vec3d::UnitX();
  across = normal.cross(along);
}

/// Direction of a line with this normal in the plane of x and z.
Vec3d line_axis(const Vec3d& normal) { return {-normal.z(), 0.0, normal.x()}; }

void add_line(Elements& elements, const Vec3d& centre, const Vec3d& normal, double length, double spacing) {
  const int n = pieces(length, spacing);
  const Vec3d along = line_axis(normal);
  for (int k = 0; k < n; ++k) elements.push_back({centre + middle(k, n, length) * along, normal, length / n});
}

/// A parallelogram's worth of pieces: a rectangle with sides along two unit vectors.
void add_rectangle(Elements& elements, const Vec3d& centre, const Vec3d& normal, const Vec3d& first,
                   double first_length, const Vec3d& second, double second_length, double spacing) {
  const int n = pieces(first_length, spacing);
  const int m = pieces(second_length, spacing);
  const double area = first_length * second_length / (n * m);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      elements.push_back(
          {centre + middle(i, n, first_length) * first + middle(j, m, second_length) * second, normal, area});
    }
  }
}

/// Rings of equal breadth, each in equal pieces.
void add_disc(Elements& elements, const Vec3d& centre, const Vec3d& normal, double radius, double spacing) {
  Vec3d along;
  Vec3d across;
  plane_axes(normal, along, across);
  const int rings = pieces(radius, spacing);
  for (int ring = 0; ring < rings; ++ring) {
    const double breadth = radius / rings;
    const double middle_radius = (ring + 0.5) * breadth;
    const int n = pieces(2.0 * kPi * middle_radius, spacing, 4);
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * kPi * (k + 0.5) / n;
      elements.push_back({centre + middle_radius * (std::cos(angle) * along + std::sin(angle) * across),
                          normal, 2.0 * kPi * middle_radius * breadth / n});
    }
  }
}

Elements box_elements(const Shape& box, double spacing, int dimension) {
  const double c = std::cos(box.rotation_z);
  const double s = std::sin(box.rotation_z);
  const Vec3d axes[3] = {Vec3d(c, s, 0.0), Vec3d(-s, c, 0.0), Vec3d::UnitZ()};
  const Vec3d size = box.max - box.min;
  Vec3d centre = 0.5 * (box.min + box.max);
  if (dimension == 2) centre.y() = 0.0;
  Elements elements;
  for (int axis = 0; axis < 3; ++axis) {
    if (dimension == 2 && axis == 1) continue;
    for (const double side : {-1.0, 1.0}) {
      const Vec3d normal = side * axes[axis];
      const Vec3d face = centre + 0.5 * size[axis] * normal;
      if (dimension == 2) {
        add_line(elements, face, normal, size[2 - axis], spacing);
      } else {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        add_rectangle(elements, face, normal, axes[u], size[u], axes[v], size[v], spacing);
      }
    }
  }
  return elements;
}

Elements cylinder_elements(const Shape& cylinder, double spacing) {
  const double radius = cylinder.radius;
  Elements elements;
  add_disc(elements, cylinder.centre, -Vec3d::UnitZ(), radius, spacing);
  add_disc(elements, cylinder.centre + cylinder.height * Vec3d::UnitZ(), Vec3d::UnitZ(), radius, spacing);
  const int n = pieces(2.0 * kPi * radius, spacing, 8);
  const int m = pieces(cylinder.height, spacing);
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * (i + 0.5) / n;
    const Vec3d normal(std::cos(angle), std::sin(angle), 0.0);
    for (int j = 0; j < m; ++j) {
      const Vec3d up = (j + 0.5) / m * cylinder.height * Vec3d::UnitZ();
      elements.push_back(
          {cylinder.centre + radius * normal + up, normal, 2.0 * kPi * radius / n * cylinder.height / m});
    }
  }
  return elements;
}

Elements circle_elements(const Shape& disc, double spacing) {
  const int n = pieces(2.0 * kPi * disc.radius, spacing, 8);
  Elements elements;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * kPi * (k + 0.5) / n;
    const Vec3d normal(std::cos(angle), 0.0, std::sin(angle));
    elements.push_back({Vec3d(disc.centre.x(), 0.0, disc.centre.z()) + disc.radius * normal, normal,
                        2.0 * kPi * disc.radius / n});
  }
  return elements;
}

/// Bands between circles of latitude; their area goes with their height (Archimedes).
Elements sphere_elements(const Shape& sphere, double spacing) {
  const double radius = sphere.radius;
  const int bands = pieces(kPi * radius, spacing, 4);
  Elements elements;
  for (int band = 0; band < bands; ++band) {
    const double top = std::cos(kPi * band / bands);
    const double bottom = std::cos(kPi * (band + 1) / bands);
    const double height = 0.5 * (top + bottom);
    const double across = std::sqrt(1.0 - height * height);
    const int n = pieces(2.0 * kPi * radius * across, spacing, 4);
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * kPi * (k + 0.5) / n;
      const Vec3d normal(across * std::cos(angle), across * std::sin(angle), height);
      elements.push_back(
          {sphere.centre + radius * normal, normal, 2.0 * kPi * radius * radius * (top - bottom) / n});
    }
  }
  return elements;
}

}  // namespace

std::vector<SurfaceElement> surface_elements(const Shape& shape, double spacing, int dimension) {
  switch (shape.kind) {
    case ShapeKind::Sphere:
      return dimension == 2 ? circle_elements(shape, spacing) : sphere_elements(shape, spacing);
    case ShapeKind::Cylinder:
      return cylinder_elements(shape, spacing);
    case ShapeKind::Box:
      break;
  }
  return box_elements(shape, spacing, dimension);
}

std::vector<SurfaceElement> disc_elements(const Vec3d& centre, const Vec3d& normal, double size,
                                          double spacing, int dimension) {
  if (dimension == 2 || size <= 0.0) return square_elements(centre, normal, size, spacing, dimension);
  Elements elements;
  add_disc(elements, centre, normal, 0.5 * size, spacing);
  return elements;
}

std::vector<SurfaceElement> square_elements(const Vec3d& centre, const Vec3d& normal, double size,
                                            double spacing, int dimension) {
  Elements elements;
  if (size <= 0.0) {
    elements.push_back({centre, normal, 1.0});
  } else if (dimension == 2) {
    add_line(elements, centre, normal, size, spacing);
  } else {
    Vec3d along;
    Vec3d across;
    plane_axes(normal, along, across);
    add_rectangle(elements, centre, normal, along, size, across, size, spacing);
  }
  return elements;
}

}  // namespace eisph
