#include "render/solid_mesh.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace eisph {

namespace {

constexpr int kSegments = 64;  ///< of a circle

void add_quad(SolidMesh& mesh, const std::array<Vec3d, 4>& corner) {
  const Vec3f normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized().cast<float>();
  for (const int k : {0, 1, 2, 0, 2, 3}) {
    mesh.triangles.push_back({corner[static_cast<std::size_t>(k)].cast<float>(), normal});
  }
}

void add_edge(SolidMesh& mesh, const Vec3d& first, const Vec3d& second) {
  mesh.edges.push_back({first.cast<float>(), second.cast<float>()});
}

void add_box(SolidMesh& mesh, const Vec3d& lower, const Vec3d& upper, double rotation) {
  const Vec3d centre = 0.5 * (lower + upper);
  const Vec3d half = 0.5 * (upper - lower);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(rotation, Vec3d::UnitZ()).toRotationMatrix();
  std::array<Vec3d, 8> corner;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vec3d sign((k & 1U) != 0 ? 1.0 : -1.0, (k & 2U) != 0 ? 1.0 : -1.0, (k & 4U) != 0 ? 1.0 : -1.0);
    corner[k] = centre + turn * half.cwiseProduct(sign);
  }
  for (const auto& face : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                           std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    const auto at = [&](std::size_t k) { return corner[static_cast<std::size_t>(face[k])]; };
    add_quad(mesh, {at(0), at(1), at(2), at(3)});
  }
  for (std::size_t k = 0; k < 8; ++k) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((k & bit) == 0) add_edge(mesh, corner[k], corner[k | bit]);
    }
  }
}

void add_cylinder(SolidMesh& mesh, const Vec3d& base, double radius, double height) {
  const auto rim = [&](int k, double z) {
    const double angle = 2.0 * std::numbers::pi * k / kSegments;
    return Vec3d(base + Vec3d(radius * std::cos(angle), radius * std::sin(angle), z));
  };
  const auto normal = [&](int k) {
    const double angle = 2.0 * std::numbers::pi * k / kSegments;
    return Vec3d(std::cos(angle), std::sin(angle), 0.0);
  };
  for (int k = 0; k < kSegments; ++k) {
    const std::array corner{rim(k, 0.0), rim(k + 1, 0.0), rim(k + 1, height), rim(k, height)};
    const std::array normals{normal(k), normal(k + 1), normal(k + 1), normal(k)};
    for (const std::size_t j : {0U, 1U, 2U, 0U, 2U, 3U}) {
      mesh.triangles.push_back({corner[j].cast<float>(), normals[j].cast<float>()});
    }
    const Vec3d top = base + Vec3d(0.0, 0.0, height);
    for (const Vec3d& point : {top, corner[3], corner[2]}) {
      mesh.triangles.push_back({point.cast<float>(), Vec3f::UnitZ()});
    }
    add_edge(mesh, corner[3], corner[2]);
    add_edge(mesh, corner[0], corner[1]);
  }
}

void add_sphere(SolidMesh& mesh, const Vec3d& centre, double radius) {
  const int rows = kSegments / 2;
  const auto direction = [&](int row, int k) {
    const double polar = std::numbers::pi * row / rows;
    const double angle = 2.0 * std::numbers::pi * k / kSegments;
    return Vec3d(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
  };
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < kSegments; ++k) {
      const std::array corner{direction(row + 1, k), direction(row + 1, k + 1), direction(row, k + 1),
                              direction(row, k)};
      for (const std::size_t j : {0U, 1U, 2U, 0U, 2U, 3U}) {
        mesh.triangles.push_back({(centre + radius * corner[j]).cast<float>(), corner[j].cast<float>()});
      }
    }
  }
}

}  // namespace

void add_shape(SolidMesh& mesh, const Shape& shape, double lift, int dimension, double thickness) {
  const Vec3d raise(0.0, 0.0, lift);
  switch (shape.kind) {
    case ShapeKind::Cylinder:
      add_cylinder(mesh, shape.centre + raise, shape.radius, shape.height);
      return;
    case ShapeKind::Sphere:
      add_sphere(mesh, shape.centre + raise, shape.radius);
      return;
    case ShapeKind::Box:
      break;
  }
  Vec3d lower = shape.min + raise;
  Vec3d upper = shape.max + raise;
  if (dimension == 2) {
    lower.y() = -0.5 * thickness;
    upper.y() = 0.5 * thickness;
  }
  add_box(mesh, lower, upper, shape.rotation_z);
}

void add_floor(SolidMesh& mesh, double x0, double x1, double y0, double y1, double z) {
  add_quad(mesh, {Vec3d(x0, y0, z), Vec3d(x1, y0, z), Vec3d(x1, y1, z), Vec3d(x0, y1, z)});
}

SolidMesh obstacle_mesh(const Scene& scene) {
  SolidMesh mesh;
  for (const Obstacle& obstacle : scene.obstacles) {
    add_shape(mesh, obstacle.shape, 0.0, scene.dimension, scene.particle_spacing);
  }
  return mesh;
}

SolidMesh gate_mesh(const Scene& scene, double time) {
  SolidMesh mesh;
  for (const Gate& gate : scene.gates) {
    if (const auto lift = gate.lift(time)) {
      add_shape(mesh, gate.shape, *lift, scene.dimension, scene.particle_spacing);
    }
  }
  return mesh;
}

std::vector<std::array<Vec3f, 2>> wall_edges(const Scene& scene, double top) {
  const Vec3d& lower = scene.domain_min;
  const Vec3d& upper = scene.domain_max;
  const auto is_wall = [&](int face) {
    return scene.faces[static_cast<std::size_t>(face)].kind == FaceKind::Wall;
  };
  SolidMesh mesh;
  const auto add_side = [&](double x0, double y0, double x1, double y1) {
    add_edge(mesh, {x0, y0, lower.z()}, {x1, y1, lower.z()});
    add_edge(mesh, {x0, y0, lower.z()}, {x0, y0, top});
    add_edge(mesh, {x1, y1, lower.z()}, {x1, y1, top});
    if (x0 != x1 || y0 != y1) add_edge(mesh, {x0, y0, top}, {x1, y1, top});
  };
  const double y0 = scene.dimension == 2 ? 0.0 : lower.y();
  const double y1 = scene.dimension == 2 ? 0.0 : upper.y();
  if (is_wall(kXMin)) add_side(lower.x(), y0, lower.x(), y1);
  if (is_wall(kXMax)) add_side(upper.x(), y0, upper.x(), y1);
  if (scene.dimension == 2) {
    if (is_wall(kZMin)) add_edge(mesh, {lower.x(), 0.0, lower.z()}, {upper.x(), 0.0, lower.z()});
    return mesh.edges;
  }
  if (is_wall(kYMin)) add_side(lower.x(), lower.y(), upper.x(), lower.y());
  if (is_wall(kYMax)) add_side(lower.x(), upper.y(), upper.x(), upper.y());
  return mesh.edges;
}

SolidMesh wall_panes(const Scene& scene, double top) {
  const Vec3d& lower = scene.domain_min;
  const Vec3d& upper = scene.domain_max;
  SolidMesh mesh;
  const auto add = [&](int face, double x0, double y0, double x1, double y1) {
    if (scene.faces[static_cast<std::size_t>(face)].kind != FaceKind::Wall) return;
    add_quad(mesh,
             {Vec3d(x0, y0, lower.z()), Vec3d(x1, y1, lower.z()), Vec3d(x1, y1, top), Vec3d(x0, y0, top)});
  };
  add(kXMin, lower.x(), upper.y(), lower.x(), lower.y());
  add(kXMax, upper.x(), lower.y(), upper.x(), upper.y());
  add(kYMin, lower.x(), lower.y(), upper.x(), lower.y());
  add(kYMax, upper.x(), upper.y(), lower.x(), upper.y());
  return mesh;
}

std::vector<std::array<Vec3f, 2>> floor_grid(const Scene& scene, double spacing) {
  const Vec3d& lower = scene.domain_min;
  const Vec3d& upper = scene.domain_max;
  SolidMesh mesh;
  const auto count = [&](int axis) {
    return static_cast<int>((upper[axis] - lower[axis]) / spacing * (1.0 - 1e-9));
  };
  for (int k = 1; k <= count(0); ++k) {
    const double x = lower.x() + k * spacing;
    add_edge(mesh, {x, lower.y(), lower.z()}, {x, upper.y(), lower.z()});
  }
  for (int k = 1; k <= count(1); ++k) {
    const double y = lower.y() + k * spacing;
    add_edge(mesh, {lower.x(), y, lower.z()}, {upper.x(), y, lower.z()});
  }
  return mesh.edges;
}

}  // namespace eisph
