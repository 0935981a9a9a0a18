#include "app/output_plan.hpp"
#include "app/pairing.hpp"
#include "app/scene_report.hpp"
#include "core/fluid_fit.hpp"
#include "core/water_volume.hpp"
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
constexpr double kLargestThesisPhi = 0.06;
/// Of the reference speed, as long as no water is that fast. Water at rest gains energy beyond 0.3.
constexpr double kLargestPhiAtRest = 0.26;
constexpr double kLargestPhiWithObjects = 0.17;
/// Times as many steps as without outputs that are worth a word.
constexpr double kManySteps = 1.3;
/// Of an implicit pressure, where the water strikes.
constexpr double kLargestPhiOfBlows = 0.17;
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

/// The largest time steps that the hard cases of `eisph stability` bear, beyond which only gentle flows do.
double largest_phi(const Scene& scene) {
  return scene.scheme.stepping == Stepping::Thesis ? kLargestThesisPhi : kLargestPhi;
}

double largest_courant(Stepping stepping) {
  switch (stepping) {
    case Stepping::RungeKutta:
      return 1.25;  // at 1.5 a wedge in a fine lattice blew up
    case Stepping::PredictorCorrector:
      return 0.4;
    case Stepping::Symplectic:
    case Stepping::Thesis:
      break;
  }
  return 0.3;
}

/// dt Umax / dx at t = 0.
double phi_at_start(const Scene& scene, const SimulationPlan& plan) {
  return plan.time_step * scene.expected_speed() / scene.particle_spacing;
}

void warn_of_courant(std::vector<std::string>& warnings, const Scene& scene, const SimulationPlan& plan) {
  const double speeds = scene.scheme.sound_speed + scene.expected_speed();
  const double courant = plan.time_step * speeds / scene.smoothing_length();
  const double most = largest_courant(scene.scheme.stepping);
  if (courant <= most * (1.0 + 1e-6)) return;
  warnings.push_back(
      fmt::format("the Courant number dt (c0 + Umax) / h is {:.3g} at t = 0, above {:g}: the run may blow up",
                  courant, most));
}

/// Negative pressure pulls the particles of a free surface into clumps.
void warn_of_negative_pressure(std::vector<std::string>& warnings, const Scene& scene) {
  if (scene.scheme.clamp_pressure || scene.scheme.free_surface_threshold <= 0.0) return;
  warnings.emplace_back(
      "scheme.clamp_pressure = false lets pressure become negative: with a free surface particles clump and "
      "the "
      "run may blow up");
}

/// A blow in one step is what an implicit pressure makes of it: at longer time steps single particles at the
/// rim of a drop that strikes were thrown away.
void warn_of_implicit_blows(std::vector<std::string>& warnings, const Scene& scene,
                            const SimulationPlan& plan) {
  const double reference = scene.reference_speed();
  const double phi = phi_at_start(scene, plan);
  if (scene.scheme.name != "isph" || phi <= kLargestPhiOfBlows * (1.0 + 1e-6)) return;
  if (reference <= 0.0 || scene.initial_speed() <= reference) return;
  warnings.push_back(
      fmt::format("the water starts at {:.3g} m/s, faster than it falls ({:.3g} m/s): with scheme.name = "
                  "\"isph\" and phi = {:.3g}, above {:g}, the run may blow up where it strikes",
                  scene.initial_speed(), reference, phi, kLargestPhiOfBlows));
}

void warn_of_time_step(std::vector<std::string>& warnings, const Scene& scene, const SimulationPlan& plan) {
  const bool adaptive = scene.scheme.time_step_mode == TimeStepMode::Adaptive;
  const double at_rest = phi_at_start(scene, plan);
  const double phi = adaptive ? std::min(at_rest, scene.scheme.phi) : at_rest;
  const double slack = 1.0 + 1e-6;
  const bool objects = plan.object_particles > 0;
  if (phi > largest_phi(scene) * slack) {
    warnings.push_back(fmt::format(
        "phi = dt Umax / dx is {:.3g} at t = 0, above {:g}: water may pass through walls and the run blow up",
        phi, largest_phi(scene)));
  } else if (objects && phi > kLargestPhiWithObjects * slack) {
    warnings.push_back(
        fmt::format("phi = dt Umax / dx is {:.3g} at t = 0, above 0.17 in a scene with objects: water "
                    "may pass through them",
                    phi));
  } else if (at_rest > kLargestPhiAtRest * slack) {
    warnings.push_back(
        fmt::format("phi / reference_speed_weight is {:.3g}, above {:g}: the time step while the water moves "
                    "slowly may be too long for its weight",
                    at_rest, kLargestPhiAtRest));
  }
  if (!adaptive) return;
  Scene inviscid = scene;
  inviscid.kinematic_viscosity = 0.0;
  inviscid.artificial_viscosity = 0.0;
  const LatticeConstants lattice = scene.dimension == 2
                                       ? lattice_constants<2>(scene.kernel, scene.smoothing_ratio)
                                       : lattice_constants<3>(scene.kernel, scene.smoothing_ratio);
  const double advective = admissible_time_step(inviscid, lattice, 0.0);
  const double viscous = admissible_time_step(scene, lattice, 0.0);
  if (viscous < advective) {
    warnings.push_back(fmt::format("the viscous limit governs the time step: {:.3g} s instead of {:.3g} s",
                                   viscous, advective));
  }
}

/// Every output ends a step: those that follow each other within few steps cost more of them.
void warn_of_short_intervals(std::vector<std::string>& warnings, const Scene& scene,
                             const SimulationPlan& plan) {
  const OutputPlan outputs(scene, true);
  const double whole = scene.end_time / plan.time_step;
  double steps = 0.0;
  double shortest = scene.end_time;
  for (double time = 0.0; time < scene.end_time;) {
    const double next = std::min(outputs.next_after(time), scene.end_time);
    steps += std::ceil((next - time) / plan.time_step - 1e-6);
    shortest = std::min(shortest, next - time);
    time = next;
  }
  if (steps <= kManySteps * whole) return;
  warnings.push_back(fmt::format(
      "every output ends a time step: with intervals down to {:.3g} s there are about {:.0f} steps, "
      "of {:.3g} s at t = 0, where {:.0f} would do",
      shortest, steps, plan.time_step, std::ceil(whole)));
}

/// Water beside cut-outs and other water that is thinner than a layer of particles.
void warn_of_thin_water(std::vector<std::string>& warnings, const Scene& scene, const SimulationPlan& plan) {
  const FluidFit fit = fit_fluid(scene);
  const char* unit = scene.dimension == 2 ? "m^2" : "m^3";
  const auto text = [&](const Vec3d& at) {
    return scene.dimension == 2 ? fmt::format("({:g}, {:g})", at.x(), at.z())
                                : fmt::format("({:g}, {:g}, {:g})", at.x(), at.y(), at.z());
  };
  const auto check = [&](const FluidPiece& piece, double particles) {
    const int axis = thin_axis(scene, piece);
    if (axis < 0) return;
    const double held = particles * plan.water_volume / static_cast<double>(plan.fluid_particles);
    warnings.push_back(fmt::format(
        "the water of fluid.region.{} from {} to {} m is {:.4g} m thin in {}, less than a particle "
        "spacing ({:g} m): it gets {:.4g} of its {:.4g} {}",
        piece.region, text(piece.lower), text(piece.upper), piece.upper[axis] - piece.lower[axis],
        "xyz"[axis], scene.particle_spacing, held, piece_volume(scene, piece), unit));
  };
  for (const FluidPiece& piece : fit.pieces)
    check(piece, piece.layers[0] * piece.layers[1] * piece.layers[2]);
  for (const FluidPiece& piece : fit.thin) check(piece, 0.0);
}

/// Of cells.
void warn_of_lost_volume(std::vector<std::string>& warnings, const Scene& scene, double filled) {
  const double wanted = water_volume(scene);
  if (!(wanted > 0.0) || std::abs(filled - wanted) <= kVolumeTolerance * wanted) return;
  const char* unit = scene.dimension == 2 ? "m^2" : "m^3";
  warnings.push_back(
      fmt::format("the cells hold {:.4g} {} of water, the regions {:.4g} {}: {:+.2g} %; lengths that are "
                  "multiples of the cell size avoid that",
                  filled, unit, wanted, unit, 100.0 * (filled / wanted - 1.0)));
}

/// Cells on solids are full height from the floor up, and none in a solid that no cell centre lies in.
std::vector<std::string> shallow_water_warnings(const Scene& scene, const SimulationPlan& plan) {
  std::vector<std::string> warnings;
  const auto check = [&](const char* sort, const std::string& name, const Shape& shape) {
    Vec3d lower;
    Vec3d upper;
    shape.bounds(lower, upper);
    const double base = lower.z() - scene.domain_min.z();
    if (shape.kind != ShapeKind::Sphere && base > 1e-6 * plan.cell_size) {
      warnings.push_back(fmt::format(
          "{} \"{}\" begins {:g} m above the floor: it is taken as standing on it, no water passes below",
          sort, name, base));
    }
    const Vec3d size = upper - lower;
    const double thin = scene.dimension == 2 ? size.x() : std::min(size.x(), size.y());
    if (thin < plan.cell_size * (1.0 - 1e-9)) {
      warnings.push_back(fmt::format(
          "{} \"{}\" is {:g} m thin, less than a cell ({:g} m): it may lie between the cell centres and "
          "have no effect",
          sort, name, thin, plan.cell_size));
    }
  };
  for (const Obstacle& obstacle : scene.obstacles) check("obstacle", obstacle.name, obstacle.shape);
  for (const Gate& gate : scene.gates) check("gate", gate.name, gate.shape);
  warn_of_lost_volume(warnings, scene, plan.water_volume);
  return warnings;
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene, const SimulationPlan& plan) {
  if (scene.scheme.name == "shallow_water") return shallow_water_warnings(scene, plan);
  std::vector<std::string> warnings;
  for (const Obstacle& obstacle : scene.obstacles) {
    warn_of_thin_solid(warnings, scene, "obstacle", obstacle.name, obstacle.shape);
  }
  for (const Gate& gate : scene.gates) warn_of_thin_solid(warnings, scene, "gate", gate.name, gate.shape);
  if (scene.scheme.weakly_compressible()) {
    warn_of_courant(warnings, scene, plan);
  } else {
    warn_of_time_step(warnings, scene, plan);
  }
  if (auto warning = pairing_warning(scene.kernel, scene.smoothing_ratio, scene.dimension)) {
    warnings.push_back(*std::move(warning));
  }
  warn_of_negative_pressure(warnings, scene);
  warn_of_implicit_blows(warnings, scene, plan);
  warn_of_short_intervals(warnings, scene, plan);

  warn_of_thin_water(warnings, scene, plan);
  return warnings;
}

}  // namespace eisph
