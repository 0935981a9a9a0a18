#include "scheme/initial_fit.hpp"

#include "scheme/neighbour_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 1024;
/// Water touches what its nearest particle is no further from, in spacings.
constexpr double kTouches = 1.5;
constexpr std::array<const char*, kFaceCount> kFaceNames{"x_min", "x_max", "y_min",
                                                         "y_max", "z_min", "z_max"};

/// Largest normalised number density less one.
template <int Dim>
double compression(ParticleSystem<Dim>& p) {
  p.find_initial_neighbours();
  p.set_source_volumes();
  std::vector<double> largest((p.fluid + kBlock - 1) / kBlock, 0.0);
  p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; ++i) {
      const std::uint32_t row = p.fluid_row(i);
      const double value = number_density(p, row, p.neighbours.of(row)) / p.lattice.number_density;
      largest[first / kBlock] = std::max(largest[first / kBlock], value);
    }
  });
  return *std::max_element(largest.begin(), largest.end()) - 1.0;
}

/// Calls visit(place) for every particle, m.
template <int Dim, class Visit>
void visit_places(const ParticleSystem<Dim>& p, const Visit& visit) {
  for (std::size_t i = 0; i < p.fluid; ++i) visit(p.place_of(i));
}

template <int Dim>
void add_gap(const ParticleSystem<Dim>& p, const std::string& name, double distance, InitialFit& fit) {
  const double gap = distance / p.scene.particle_spacing;
  if (gap <= kTouches) fit.gaps.push_back({name, gap});
}

template <int Dim>
void add_gaps(const ParticleSystem<Dim>& p, InitialFit& fit) {
  const Scene& scene = p.scene;
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    for (const int side : {0, 1}) {
      const std::size_t face = 2 * static_cast<std::size_t>(axis) + static_cast<std::size_t>(side);
      if (scene.faces[face].kind == FaceKind::Open) continue;
      double distance = std::numeric_limits<double>::infinity();
      visit_places(p, [&](const Vec3d& at) {
        distance = std::min(
            distance, side == 0 ? at[axis] - scene.domain_min[axis] : scene.domain_max[axis] - at[axis]);
      });
      add_gap(p, kFaceNames[face], distance, fit);
    }
  }
  const auto add_solid = [&](const std::string& name, const Shape& shape) {
    double distance = std::numeric_limits<double>::infinity();
    visit_places(p, [&](const Vec3d& at) { distance = std::min(distance, shape.signed_distance(at, Dim)); });
    add_gap(p, fmt::format("\"{}\"", name), distance, fit);
  };
  for (const Obstacle& obstacle : scene.obstacles) add_solid(obstacle.name, obstacle.shape);
  for (const Gate& gate : scene.gates) {
    if (gate.lift(0.0)) add_solid(gate.name, gate.shape);
  }
}

}  // namespace

template <int Dim>
InitialFit initial_fit(ParticleSystem<Dim>& particles) {
  InitialFit fit;
  fit.compression = compression(particles);
  add_gaps(particles, fit);
  return fit;
}

template InitialFit initial_fit<2>(ParticleSystem<2>&);
template InitialFit initial_fit<3>(ParticleSystem<3>&);

}  // namespace eisph
