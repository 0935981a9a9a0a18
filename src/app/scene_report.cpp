#include "app/scene_report.hpp"

#include "app/output_plan.hpp"
#include "core/scheme_list.hpp"
#include "io/comparison_file.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eisph {
namespace {

/// Position, velocity, pressure, number density, id and place of a particle in a .vtp file, before
/// compression.
constexpr double kStateBytesPerParticle = 12 + 12 + 4 + 4 + 4 + 8;

class Report {
 public:
  void row(const std::string& name, const std::string& value) {
    text_ += fmt::format("{:<18}{}\n", name, value);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string megabytes(double bytes) { return fmt::format("{:.3g} MB", bytes / 1e6); }

std::string content(const ImageSettings& image) {
  if (image.kind == ImageKind::DepthMap) return "depth map, " + image.field;
  if (image.kind == ImageKind::Particles)
    return (image.style == WaterStyle::Surface ? "surface, " : "particles, ") + image.field;
  std::vector<std::string> parts = image.panels;
  parts.insert(parts.end(), image.gauges.begin(), image.gauges.end());
  return fmt::format("panels {}", fmt::join(parts, ", "));
}

void add_frames(Report& report, const Scene& scene, const OutputCounts& counts) {
  for (std::size_t k = 0; k < scene.images.size(); ++k) {
    const ImageSettings& image = scene.images[k];
    report.row(k == 0 ? "frames" : "", fmt::format("{} of \"{}\": {}, {} x {}", counts.frames[k], image.name,
                                                   content(image), image.width, image.height));
  }
  if (scene.images.empty()) report.row("frames", "none");
}

void add_tables(Report& report, const Scene& scene, const OutputCounts& counts) {
  const auto rows = [&](double interval) {
    Schedule schedule;
    schedule.interval = interval;
    return schedule.empty() ? std::string("at every output")
                            : fmt::format("{} rows", count_due(schedule, scene.end_time));
  };
  for (const Gauge& gauge : scene.gauges) {
    report.row("gauge",
               fmt::format("{} at ({:g}, {:g}) m, {}", gauge.name, gauge.x, gauge.y, rows(gauge.interval)));
  }
  for (const PointProbe& probe : scene.probes) {
    const Vec3d& at = probe.position;
    report.row("probe", fmt::format("{} at ({:g}, {:g}, {:g}) m, {}", probe.name, at.x(), at.y(), at.z(),
                                    rows(probe.interval)));
  }
  for (const PressureSensor& sensor : scene.pressure_sensors) {
    const Vec3d& at = sensor.position;
    report.row("pressure sensor", fmt::format("{} at ({:g}, {:g}, {:g}) m, {}", sensor.name, at.x(), at.y(),
                                              at.z(), rows(sensor.interval)));
  }
  for (const FrontProbe& front : scene.fronts) {
    report.row("front", fmt::format("{} along {}{}, {}", front.name, front.upwards ? '+' : '-',
                                    "xyz"[front.axis], rows(front.interval)));
  }
  for (const LineProbe& line : scene.lines) {
    report.row("line", fmt::format("{} of {} points, {} each", line.name, line.points, rows(line.interval)));
  }
  for (const ForceProbe& force : scene.forces) {
    report.row("force", fmt::format("{} on {}, {}", force.name, force.obstacle, rows(force.interval)));
  }
  for (const DischargeProbe& plane : scene.discharges) {
    report.row("discharge", fmt::format("{} through {} = {:g} m, {}", plane.name, "xyz"[plane.axis],
                                        plane.position, rows(plane.interval)));
  }
  report.row("tables", fmt::format("leading edge and ledger with every output, {} times from probes",
                                   counts.probe_times));
}

std::string scheme_meaning(const std::string& name) {
#define EISPH_MEANING(scheme, meaning) \
  if (name == #scheme) return meaning;
  EISPH_SCHEMES(EISPH_MEANING)
#undef EISPH_MEANING
  return name;
}

void add_particles(Report& report, const Scene& scene, const SimulationPlan& plan) {
  report.row("scheme", scheme_meaning(scene.scheme.name));
  report.row("spacing", fmt::format("{:g} m, smoothing length {:g} m", scene.particle_spacing,
                                    scene.smoothing_length()));
  report.row("particles", fmt::format("{} fluid, {} object, {} virtual (not stored), {} ghost at t = 0",
                                      plan.fluid_particles, plan.object_particles, plan.virtual_particles,
                                      plan.ghost_particles));
  const double cube = std::pow(scene.particle_spacing, scene.dimension);
  report.row("water", fmt::format("{:.6g} {}, {:.5g} spacings {} a particle", plan.water_volume,
                                  scene.dimension == 2 ? "m^2" : "m^3",
                                  plan.water_volume / cube / static_cast<double>(plan.fluid_particles),
                                  scene.dimension == 2 ? "squared" : "cubed"));
}

void add_cells(Report& report, const Scene& scene, const SimulationPlan& plan) {
  report.row("scheme", fmt::format("shallow water, Courant number {:g}, Manning coefficient {:g} s m^(-1/3)",
                                   scene.shallow_water.courant, scene.shallow_water.manning));
  report.row("cells", fmt::format("{} of {:g} m, {} of them on solids, {} wet at t = 0", plan.fluid_particles,
                                  plan.cell_size, plan.object_particles, plan.wet_cells));
  report.row("water", fmt::format("{:.6g} {}", plan.water_volume, scene.dimension == 2 ? "m^2" : "m^3"));
}

}  // namespace

std::string scene_report(const Scene& scene, const SimulationPlan& plan, std::uint64_t available_memory) {
  Report report;
  report.row("scene", fmt::format("{} ({}), {}D, {:g} s", scene.name, scene.source_file, scene.dimension,
                                  scene.end_time));
  const bool cells = scene.scheme.name == "shallow_water";
  if (cells) {
    add_cells(report, scene, plan);
  } else {
    add_particles(report, scene, plan);
  }
  report.row("memory", fmt::format("{} of solver state, {} available",
                                   megabytes(static_cast<double>(plan.estimated_bytes)),
                                   megabytes(static_cast<double>(available_memory))));
  report.row("time step",
             fmt::format("{:.4g} s at t = 0, about {} steps", plan.time_step, plan.estimated_steps));
  if (cells) {
    report.row("long waves", fmt::format("{:.3g} m/s in water as deep as the reference depth, {:g} m",
                                         plan.effective_sound_speed, scene.reference_depth));
  } else if (std::isinf(plan.effective_sound_speed)) {
    report.row("speed of sound",
               fmt::format("infinite: pressure solved to {:g} of its residual, {:.3g} m/s expected",
                           scene.scheme.pressure_tolerance, scene.expected_speed()));
  } else {
    report.row("speed of sound",
               fmt::format("{:.3g} m/s effective, Mach number {:.2g} at the speed expected, {:.3g} m/s",
                           plan.effective_sound_speed, scene.expected_speed() / plan.effective_sound_speed,
                           scene.expected_speed()));
  }

  const OutputCounts counts = OutputPlan(scene, true).counts(scene.end_time);
  add_frames(report, scene, counts);
  const double state_bytes = kStateBytesPerParticle * static_cast<double>(plan.fluid_particles);
  report.row("particle states", counts.particles == 0
                                    ? std::string("none")
                                    : fmt::format("{} .vtp files of at most about {} each", counts.particles,
                                                  megabytes(state_bytes)));
  report.row("depth grids",
             counts.depth == 0 ? std::string("none") : fmt::format("{} .vti files", counts.depth));
  add_tables(report, scene, counts);
  if (!scene.comparison.empty()) {
    const Comparison comparison = load_comparison(scene.comparison);
    report.row("comparison",
               fmt::format("with {} photographs, {}", comparison.photographs.size(), scene.comparison));
  }
  return report.text();
}

std::string fit_report(const InitialFit& fit) {
  Report report;
  std::vector<std::string> gaps;
  gaps.reserve(fit.gaps.size());
  for (const InitialFit::Gap& gap : fit.gaps)
    gaps.push_back(fmt::format("{} {:.3f}", gap.name, gap.spacings));
  report.row("nearest row", gaps.empty() ? std::string("water touches neither walls nor solids")
                                         : fmt::format("{} spacings", fmt::join(gaps, ", ")));
  report.row("compression", fmt::format("{:.2g} % at t = 0", 100.0 * std::max(0.0, fit.compression)));
  return report.text();
}

}  // namespace eisph
