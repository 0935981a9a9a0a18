#include "app/fluid_volume.hpp"
#include "app/scene_report.hpp"
#include "scheme/time_step.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eisph {
namespace {

/// Objects thinner than this let water through, in particle spacings.
constexpr double kLeastThickness = 1.5;
/// phi above which walls alone, and walls with objects, no longer hold for certain.
constexpr double kLargestPhi = 0.25;
constexpr double kLargestPhiWithObjects = 0.17;
/// Largest relative difference between the volume of the particles and that of the regions.
constexpr double kVolumeTolerance = 0.01;

double thickness(const Shape& shape, int dimension) {
  switch (shape.kind) {
    case ShapeKind::Sphere:
      return 2.0 * shape.radius;
    case ShapeKind::Cylinder:
      return std::min(2.0 * shape.radius, shape.height);
    case ShapeKind::Box:
      break;
  }
  const Vec3d size = shape.max - shape.min;
  return dimension == 2 ? std::min(size.x(), size.z()) : size.minCoeff();
}

void warn_of_thin_solid(std::vector<std::string>& warnings, const Scene& scene, const char* sort,
                        const std::string& name, const Shape& shape) {
  const double least = kLeastThickness * scene.particle_spacing;
  const double thin = thickness(shape, scene.dimension);
  if (thin >= least * (1.0 - 1e-9)) return;
  warnings.push_back(
      fmt::format("{} \"{}\" is {:g} m thin, less than 1.5 particle spacings ({:g} m): water may pass "
                  "through it",
                  sort, name, thin, least));
}

void warn_of_time_step(std::vector<std::string>& warnings, const Scene& scene, const SimulationPlan& plan) {
  const double phi = plan.time_step * scene.reference_speed() / scene.particle_spacing;
  const double slack = 1.0 + 1e-6;
  const bool objects = plan.object_particles > 0;
  if (phi > kLargestPhi * slack) {
    warnings.push_back(
        fmt::format("phi = dt Umax / dx is {:.3g} at t = 0, above 0.25: water may pass through walls", phi));
  } else if (objects && phi > kLargestPhiWithObjects * slack) {
    warnings.push_back(
        fmt::format("phi = dt Umax / dx is {:.3g} at t = 0, above 0.17 in a scene with objects: water "
                    "may pass through them",
                    phi));
  }
  if (scene.scheme.time_step_mode != TimeStepMode::Adaptive) return;
  Scene inviscid = scene;
  inviscid.kinematic_viscosity = 0.0;
  inviscid.artificial_viscosity = 0.0;
  const double advective = admissible_time_step(inviscid, 0.0);
  const double viscous = admissible_time_step(scene, 0.0);
  if (viscous < advective) {
    warnings.push_back(fmt::format("the viscous limit governs the time step: {:.3g} s instead of {:.3g} s",
                                   viscous, advective));
  }
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene, const SimulationPlan& plan) {
  std::vector<std::string> warnings;
  for (const Obstacle& obstacle : scene.obstacles) {
    warn_of_thin_solid(warnings, scene, "obstacle", obstacle.name, obstacle.shape);
  }
  for (const Gate& gate : scene.gates) warn_of_thin_solid(warnings, scene, "gate", gate.name, gate.shape);
  warn_of_time_step(warnings, scene, plan);

  const double wanted = fluid_volume(scene);
  const double filled =
      static_cast<double>(plan.fluid_particles) * std::pow(scene.particle_spacing, scene.dimension);
  if (wanted > 0.0 && std::abs(filled - wanted) > kVolumeTolerance * wanted) {
    const char* unit = scene.dimension == 2 ? "m^2" : "m^3";
    warnings.push_back(
        fmt::format("the particles hold {:.4g} {} of water, the regions {:.4g} {}: {:+.2g} %; lengths "
                    "that are multiples of the particle spacing avoid that",
                    filled, unit, wanted, unit, 100.0 * (filled / wanted - 1.0)));
  }
  return warnings;
}

}  // namespace eisph
