#pragma once

#include "core/scene.hpp"

#include <array>
#include <vector>

namespace eisph {

/// Triangles with flat or smooth normals, and the edges that outline them. Metres.
struct SolidMesh {
  struct Vertex {
    Vec3f position;
    Vec3f normal;
  };
  std::vector<Vertex> triangles;  ///< three to a triangle
  std::vector<std::array<Vec3f, 2>> edges;
};

/// Adds the surface of `shape`, raised by `lift`. In two dimensions the shape is given `thickness` in y.
void add_shape(SolidMesh& mesh, const Shape& shape, double lift, int dimension, double thickness);
/// Adds the rectangle [x0, x1] x [y0, y1] at height z, facing upwards.
void add_floor(SolidMesh& mesh, double x0, double x1, double y0, double y1, double z);

/// Obstacles and dams.
[[nodiscard]] SolidMesh obstacle_mesh(const Scene& scene);
/// Gates as they stand at `time` (s).
[[nodiscard]] SolidMesh gate_mesh(const Scene& scene, double time);
/// Outlines of the domain's walls up to height `top`; open and symmetry faces are left out.
[[nodiscard]] std::vector<std::array<Vec3f, 2>> wall_edges(const Scene& scene, double top);
/// The upright walls of the domain up to height `top` (three dimensions), without edges.
[[nodiscard]] SolidMesh wall_panes(const Scene& scene, double top);
/// Lines on the floor at multiples of `spacing` from the domain's lower corner.
[[nodiscard]] std::vector<std::array<Vec3f, 2>> floor_grid(const Scene& scene, double spacing);

}  // namespace eisph
