#include "core/error.hpp"
#include "core/lattice.hpp"
#include "io/scene_check.hpp"
#include "io/schema_value.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kBytesPerParticle = 600.0;     ///< solver state of a fluid particle, its neighbours included
constexpr double kBytesPerCell = 16.0;          ///< search grid and depth grid
constexpr double kBytesPerShallowCell = 250.0;  ///< state and snapshots of a shallow-water run
constexpr double kTolerance = 1e-6;             ///< lengths, over the particle spacing

constexpr const char* kAxisNames = "xyz";

void check_domain(const Scene& scene, const TomlSource& source) {
  for (const int axis : scene_axes(scene)) {
    const double extent = scene.domain_max[axis] - scene.domain_min[axis];
    if (extent < scene.smoothing_length()) {
      source.fail(
          "domain.max",
          fmt::format("the domain is {:.6g} m long in {}; expected at least {:.6g} m, the smoothing length",
                      extent, kAxisNames[axis], scene.smoothing_length()));
    }
  }
}

/// Key that tells where a shape is.
std::string corner_key(const Shape& shape, bool upper) {
  if (shape.kind != ShapeKind::Box) return ".centre";
  return upper ? ".max" : ".min";
}

void check_shape(const Shape& shape, const std::string& path, const Scene& scene, const TomlSource& source) {
  if (shape.kind == ShapeKind::Cylinder && scene.dimension == 2) {
    source.fail(path + ".shape", "a cylinder needs dimension = 3; expected \"box\" or \"sphere\"");
  }
  if (shape.kind != ShapeKind::Box) return;
  for (const int axis : scene_axes(scene)) {
    if (shape.min[axis] < shape.max[axis]) continue;
    source.fail(path + ".max",
                fmt::format("expected {} above that of min, {}", kAxisNames[axis], shape.min[axis]));
  }
}

/// Water may cross only symmetry planes, where the mirror image completes it.
void check_region(const FluidRegion& region, const std::string& path, const Scene& scene,
                  const TomlSource& source) {
  check_shape(region.shape, path, scene, source);
  if (region.cut) return;
  Vec3d lower;
  Vec3d upper;
  region.shape.bounds(lower, upper);
  const double tolerance = kTolerance * scene.particle_spacing;
  for (const int axis : scene_axes(scene)) {
    const auto crosses = [&](double beyond, int face) {
      return beyond > tolerance && scene.faces[static_cast<std::size_t>(face)].kind != FaceKind::Symmetry;
    };
    const bool below = crosses(scene.domain_min[axis] - lower[axis], 2 * axis);
    if (below || crosses(upper[axis] - scene.domain_max[axis], 2 * axis + 1)) {
      source.fail(
          path + corner_key(region.shape, !below),
          fmt::format(
              "water reaches out of the domain in {} (from {:.6g} to {:.6g} m); expected it within {}",
              kAxisNames[axis], lower[axis], upper[axis], domain_text(scene)));
    }
    if (lower[axis] >= scene.domain_max[axis] || upper[axis] <= scene.domain_min[axis]) {
      source.fail(path + corner_key(region.shape, false),
                  fmt::format("the water is outside the domain; expected it within {}", domain_text(scene)));
    }
  }
}

void check_solid(const Shape& shape, const std::string& path, const Scene& scene, const TomlSource& source) {
  check_shape(shape, path, scene, source);
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  for (const int axis : scene_axes(scene)) {
    if (lower[axis] < scene.domain_max[axis] && upper[axis] > scene.domain_min[axis]) continue;
    source.fail(
        path + corner_key(shape, false),
        fmt::format("the solid is outside the domain; expected it to stand in {}", domain_text(scene)));
  }
}

std::vector<Shape> solid_shapes(const Scene& scene) {
  std::vector<Shape> shapes;
  for (const Obstacle& obstacle : scene.obstacles) shapes.push_back(obstacle.shape);
  for (const Gate& gate : scene.gates) shapes.push_back(gate.shape);
  return shapes;
}

/// Memory of the solids and grids, bytes.
double fixed_bytes(const Scene& scene) {
  double objects = 0.0;
  for (const Shape& shape : solid_shapes(scene)) {
    objects +=
        solid_particle_estimate(shape, scene.particle_spacing, scene.support_radius(), scene.dimension);
  }
  const Vec3d size = scene.domain_max - scene.domain_min;
  double cells = 1.0;
  for (const int axis : scene_axes(scene)) cells *= size[axis] / scene.support_radius() + 2.0;
  const double columns = (size.x() / scene.output.depth_cell_size + 1.0) *
                         (scene.dimension == 2 ? 1.0 : size.y() / scene.output.depth_cell_size + 1.0);
  return kBytesPerParticle * objects + kBytesPerCell * (cells + columns);
}

/// Memory of everything, from the bound on the particles, bytes.
double bytes_bound(const Scene& scene) {
  return fixed_bytes(scene) + kBytesPerParticle * fluid_particle_bound(scene);
}

/// A spacing, larger than the present one, at which the scene fits the memory.
std::string fitting_spacing(Scene scene, const TomlSource& source, double available_memory) {
  constexpr double kStep = 1.1;
  for (int attempt = 0; attempt < 200; ++attempt) {
    scene.particle_spacing *= kStep;
    if (!source.given("output.depth_cell_size")) scene.output.depth_cell_size *= kStep;
    if (bytes_bound(scene) <= available_memory && fluid_particle_bound(scene) <= kMaximumFluidParticles) {
      return fmt::format("a spacing of {:.2g} m or more", 1.05 * scene.particle_spacing);
    }
  }
  return "a smaller domain or larger depth_cell_size";
}

/// Counts the water and holds it against the memory.
void check_count(const Scene& scene, const TomlSource& source, double available_memory) {
  const double bound = fluid_particle_bound(scene);
  const double fitting = std::floor((available_memory - fixed_bytes(scene)) / kBytesPerParticle);
  const bool hopeless = bound > kMaximumFluidParticles || fitting < 1.0;
  const auto limit = static_cast<std::uint64_t>(std::clamp(fitting, 0.0, kMaximumFluidParticles));
  const std::uint64_t count = hopeless ? 0 : count_fluid_particles(scene, limit);
  if (hopeless || count > limit) {
    constexpr double kGigabyte = 1e9;
    source.fail(
        "particles.spacing",
        fmt::format(
            "about {:.3g} fluid particles, the solids and the grids need {:.3g} GB of memory, {:.3g} GB "
            "are available; expected {}",
            bound, bytes_bound(scene) / kGigabyte, available_memory / kGigabyte,
            fitting_spacing(scene, source, available_memory)));
  }
  if (count == 0) {
    source.fail(
        "fluid",
        fmt::format("no particle lies in the water; expected regions that are larger than the spacing "
                    "{} m, inside the domain and not cut away",
                    scene.particle_spacing));
  }
}

/// No particle may start inside a solid; one whose centre lies on the surface may.
void check_overlap(const Scene& scene, const TomlSource& source) {
  const std::vector<Shape> solids = solid_shapes(scene);
  const double tolerance = kTolerance * scene.particle_spacing;
  std::vector<std::uint64_t> overlaps(solids.size(), 0);
  visit_fluid_lattice(scene, [&](const Vec3d& point, const Vec3d&) {
    for (std::size_t s = 0; s < solids.size(); ++s) {
      if (solids[s].signed_distance(point, scene.dimension) < -tolerance) ++overlaps[s];
    }
    return true;
  });
  for (std::size_t s = 0; s < solids.size(); ++s) {
    if (overlaps[s] == 0) continue;
    source.fail(
        solid_path(scene, source, s) + ".name",
        fmt::format(
            "{} fluid particles lie inside this solid; expected none: end the water at its faces or take "
            "its shape out by a [[fluid.region]] with cut = true",
            overlaps[s]));
  }
}

/// Memory of the cells of a shallow-water run.
void check_cells(const Scene& scene, const TomlSource& source, double available_memory) {
  if (scene.scheme.name != "shallow_water") return;
  const Vec3d size = scene.domain_max - scene.domain_min;
  const double side = scene.shallow_water.cell_size;
  const double cells = size.x() / side * (scene.dimension == 2 ? 1.0 : size.y() / side);
  if (kBytesPerShallowCell * cells <= available_memory && cells <= kMaximumFluidParticles) return;
  source.fail(
      "shallow_water.cell_size", write_number(side),
      fmt::format("{:.3g} cells need {:.3g} GB of memory, {:.3g} GB are available; expected larger ones",
                  cells, kBytesPerShallowCell * cells * 1e-9, available_memory * 1e-9));
}

}  // namespace

std::vector<int> scene_axes(const Scene& scene) {
  return scene.dimension == 2 ? std::vector<int>{0, 2} : std::vector<int>{0, 1, 2};
}

std::string domain_text(const Scene& scene) {
  return fmt::format("the domain from {} to {}", write_vector(scene.domain_min, scene.dimension),
                     write_vector(scene.domain_max, scene.dimension));
}

void check_geometry(const Scene& scene, const TomlSource& source, std::uint64_t available_memory) {
  check_domain(scene, source);
  if (scene.fluid.empty()) source.fail("fluid.region", "missing; expected at least one [[fluid.region]]");
  for (std::size_t k = 0; k < scene.fluid.size(); ++k) {
    check_region(scene.fluid[k], fmt::format("fluid.region.{}", k), scene, source);
  }
  const std::vector<Shape> solids = solid_shapes(scene);
  for (std::size_t k = 0; k < solids.size(); ++k)
    check_solid(solids[k], solid_path(scene, source, k), scene, source);
  check_probes(scene, source);
  check_thickness(scene, source);
  check_count(scene, source, static_cast<double>(available_memory));
  check_cells(scene, source, static_cast<double>(available_memory));
  check_overlap(scene, source);
}

}  // namespace eisph
