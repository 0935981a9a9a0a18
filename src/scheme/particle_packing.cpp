#include "scheme/particle_packing.hpp"

#include "core/fluid_fit.hpp"
#include "scheme/neighbour_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace eisph {

namespace {

constexpr int kSpreadings = 40;
constexpr int kMostEvenings = 100;
/// Error of the normalised number density that ends the evening.
constexpr double kEvenEnough = 0.005;
constexpr std::size_t kBlock = 1024;
/// Of h^2 grad n: a step of diffusion of the number density.
constexpr double kDiffusion = 0.3;
/// Longest move of one iteration, in spacings.
constexpr double kLongestMove = 0.1;
/// Least distance from a round or rotated solid, and from other solids and walls, in spacings.
constexpr double kClearance = 0.5;
constexpr double kFlatClearance = 0.4;
/// Water this near to a round or rotated solid touches it, in spacings.
constexpr double kTouches = 1.0;
/// Reach of the packing from such a solid, in smoothing lengths; beyond it particles as far as the support
/// radius are seen but stay.
constexpr double kReach = 8.0;
/// Differences in the volume of cells that are left alone.
constexpr double kLargestMisfit = 0.004;

bool is_loose(const Shape& shape) { return shape.kind != ShapeKind::Box || shape.rotation_z != 0.0; }

std::vector<Shape> solid_shapes(const Scene& scene) {
  std::vector<Shape> shapes;
  for (const Obstacle& obstacle : scene.obstacles) shapes.push_back(obstacle.shape);
  for (const Gate& gate : scene.gates) {
    if (gate.lift(0.0)) shapes.push_back(gate.shape);
  }
  return shapes;
}

/// Signed distance to the water's surface, negative inside; not beyond the nearest shape, m.
double water_distance(const Scene& scene, const Vec3d& point) {
  double distance = std::numeric_limits<double>::infinity();
  for (const FluidRegion& region : scene.fluid) {
    if (!region.cut) distance = std::min(distance, region.shape.signed_distance(point, scene.dimension));
  }
  for (const FluidRegion& region : scene.fluid) {
    if (region.cut) distance = std::max(distance, -region.shape.signed_distance(point, scene.dimension));
  }
  return distance;
}

/// The water's bounds as a tank: the surface of water that fills them but for solids is a mirror plane, and
/// the number density in it complete up to the surface.
Scene closed_about_water(const Scene& scene) {
  Scene closed = scene;
  Vec3d lower = Vec3d::Constant(std::numeric_limits<double>::infinity());
  Vec3d upper = -lower;
  for (const FluidRegion& region : scene.fluid) {
    if (region.cut) continue;
    Vec3d from;
    Vec3d to;
    region.shape.bounds(from, to);
    lower = lower.cwiseMin(from);
    upper = upper.cwiseMax(to);
  }
  closed.domain_min = scene.domain_min.cwiseMax(lower);
  closed.domain_max = scene.domain_max.cwiseMin(upper);
  closed.faces.fill(Face{});
  closed.boundary.ghost_particles = true;
  closed.scheme.list_reach = 0.0;
  return closed;
}

template <int Dim>
class Packing {
 public:
  Packing(const Scene& scene, int threads, const FluidLattice& sites,
          const std::vector<std::uint32_t>& members, const std::vector<char>& moves)
      : scene_(closed_about_water(scene)),
        solids_(solid_shapes(scene)),
        spacing_(std::pow(sites.particle_volume, 1.0 / Dim)),
        particles_(scene_, threads, selection(sites, members)) {
    barred_.resize(members.size(), kStays);
    particles_.pool.run_blocks(members.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t k = first; k < last; ++k) {
        if (moves[members[k]] != 0) barred_[k] = barred_axis(sites.position[members[k]]);
      }
    });
  }

  void run() {
    for (int iteration = 0; iteration < kSpreadings; ++iteration) spread();
    for (int iteration = 0; iteration < kMostEvenings && find_errors() > kEvenEnough; ++iteration) even_out();
  }

  /// Places of the members, m.
  [[nodiscard]] std::vector<Vec3d> places() const {
    std::vector<Vec3d> found(particles_.fluid);
    for (std::uint32_t i = 0; i < particles_.fluid; ++i) found[particles_.id[i]] = particles_.place_of(i);
    return found;
  }

 private:
  static constexpr int kStays = -2;
  static constexpr int kFree = -1;

  static FluidLattice selection(const FluidLattice& sites, const std::vector<std::uint32_t>& members) {
    FluidLattice chosen;
    chosen.particle_volume = sites.particle_volume;
    for (const std::uint32_t k : members) chosen.position.push_back(sites.position[k]);
    chosen.velocity.assign(members.size(), Vec3d::Zero());
    return chosen;
  }

  [[nodiscard]] bool is_air(const Vec3d& point) const {
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      if (point[axis] < scene_.domain_min[axis] || point[axis] > scene_.domain_max[axis]) return false;
    }
    const double slack = kTouches * spacing_;
    return water_distance(scene_, point) > 1e-6 * spacing_ &&
           std::none_of(solids_.begin(), solids_.end(), [&](const Shape& solid) {
             return solid.signed_distance(point, scene_.dimension) <= slack;
           });
  }

  /// The axis that points to air within the support radius of a particle: its missing neighbours look like a
  /// low density, and it must not follow them.
  [[nodiscard]] int barred_axis(const Vec3d& point) const {
    Vec3d towards = Vec3d::Zero();
    const int across = Dim == 3 ? 1 : 0;
    for (const double reach : {0.5, 1.0, 1.5, 2.0}) {
      for (int k = -1; k <= 1; ++k) {
        for (int j = -across; j <= across; ++j) {
          for (int i = -1; i <= 1; ++i) {
            const Vec3d direction = Vec3d(i, j, k);
            if (direction.isZero()) continue;
            const Vec3d unit = direction.normalized();
            if (is_air(point + reach * particles_.h * unit)) towards += unit;
          }
        }
      }
    }
    if (towards.norm() < 1e-9) return kFree;
    int barred = Dim - 1;
    for (int d = 0; d < Dim; ++d) {
      if (std::abs(towards[scene_axis<Dim>(d)]) > std::abs(towards[scene_axis<Dim>(barred)]) + 1e-9)
        barred = d;
    }
    return barred;
  }

  /// x -= 0.3 h^2 grad n: parts particles that lie close and fills gaps.
  void spread() {
    particles_.find_initial_neighbours();
    particles_.set_source_volumes();
    for_moving([&](std::size_t, std::uint32_t row, const Neighbours& near) {
      Vector<Dim, double> gradient = concentration_gradient(particles_, row, near);
      for (double& component : gradient.x) component *= -1.0;
      return gradient;
    });
  }

  /// The normalised number densities less one, into the w of the positions, none beside air. Returns the
  /// largest of particles that move.
  double find_errors() {
    ParticleSystem<Dim>& p = particles_;
    p.find_initial_neighbours();
    p.set_source_volumes();
    Float4* rows = p.fluid_rows(p.table.position);
    std::vector<double> largest((p.fluid + kBlock - 1) / kBlock, 0.0);
    p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t row = p.fluid_row(i);
        const double error = number_density(p, row, p.neighbours.of(row)) / p.lattice.number_density - 1.0;
        const bool counts = barred_[p.id[i]] == kFree;
        // Not into the rows yet: other particles read them.
        p.carried[i] = counts ? static_cast<float>(error) : 0.0F;
        if (counts) largest[first / kBlock] = std::max(largest[first / kBlock], std::abs(error));
      }
    });
    for (std::uint32_t i = 0; i < p.fluid; ++i) rows[i].w = p.carried[i];
    p.mirror_pressure();
    return *std::max_element(largest.begin(), largest.end());
  }

  /// x -= 0.3 h^2 sum V_j (e_i + e_j) grad W_ij with the errors e of find_errors: descends towards the least
  /// sum of their squares.
  void even_out() {
    for_moving([&](std::size_t i, std::uint32_t row, const Neighbours& near) {
      if (barred_[particles_.id[i]] != kFree) return Vector<Dim, double>{};
      Vector<Dim, double> force = pressure_terms(particles_, row, near).acceleration;
      for (double& component : force.x) component *= scene_.density;
      return force;
    });
  }

  /// Moves particle i by 0.3 h^2 direction(i, row, near), not further than a tenth of the spacing and not
  /// along its barred axis, then out to the least distances.
  template <class Direction>
  void for_moving(const Direction& direction) {
    ParticleSystem<Dim>& p = particles_;
    p.pool.run_blocks(p.fluid, kBlock, [&](std::size_t first, std::size_t last, int) {
      for (std::size_t i = first; i < last; ++i) {
        const int barred = barred_[p.id[i]];
        if (barred == kStays) continue;
        const std::uint32_t row = p.fluid_row(i);
        Vector<Dim, double> step = direction(i, row, p.neighbours.of(row));
        if (barred != kFree) step.x[barred] = 0.0;
        double squared = 0.0;
        for (int d = 0; d < Dim; ++d) squared += step.x[d] * step.x[d];
        const double length = kDiffusion * p.h * p.h * std::sqrt(squared);
        const double most = kLongestMove * spacing_;
        const double scale = kDiffusion * p.h * p.h * (length > most ? most / length : 1.0);
        Vec3d at = particles_.place_of(i);
        const Vec3d before = at;
        for (int d = 0; d < Dim; ++d) at[scene_axis<Dim>(d)] += scale * step.x[d];
        keep_clear(at, before);
        for (int d = 0; d < Dim; ++d) {
          p.position[d][i] = at[scene_axis<Dim>(d)] - scene_.domain_min[scene_axis<Dim>(d)];
        }
      }
    });
  }

  void keep_clear(Vec3d& at, const Vec3d& before) const {
    for (int pass = 0; pass < 2; ++pass) {
      for (const Shape& solid : solids_) {
        const double clearance = (is_loose(solid) ? kClearance : kFlatClearance) * spacing_;
        const double distance = solid.signed_distance(at, Dim);
        if (distance < clearance) at += (clearance - distance) * solid.outward_normal(at, Dim);
      }
    }
    const double clearance = kFlatClearance * spacing_;
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      at[axis] = std::clamp(at[axis], std::min(before[axis], scene_.domain_min[axis] + clearance),
                            std::max(before[axis], scene_.domain_max[axis] - clearance));
    }
  }

  Scene scene_;
  std::vector<Shape> solids_;
  double spacing_;  ///< edge of a cube of the volume of a particle, m
  ParticleSystem<Dim> particles_;
  std::vector<int> barred_;  ///< by id: the axis of the solver along which it does not move
};

/// Which particles may move.
std::vector<char> moving_particles(const Scene& scene, const FluidLattice& sites, double misfit) {
  std::vector<char> moves(sites.position.size(), misfit > kLargestMisfit ? 1 : 0);
  for (const Shape& solid : solid_shapes(scene)) {
    if (!is_loose(solid)) continue;
    std::vector<double> distance(sites.position.size());
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < distance.size(); ++k) {
      distance[k] = solid.signed_distance(sites.position[k], scene.dimension);
      nearest = std::min(nearest, distance[k]);
    }
    if (nearest > kTouches * scene.particle_spacing) continue;
    const double reach = kReach * scene.smoothing_length();
    for (std::size_t k = 0; k < distance.size(); ++k) {
      if (distance[k] < reach) moves[k] = 1;
    }
  }
  return moves;
}

/// Those that move, and those that they see.
std::vector<std::uint32_t> moving_and_seen(const Scene& scene, const FluidLattice& sites,
                                           const std::vector<char>& moves) {
  std::vector<std::uint32_t> members;
  const bool all = std::find(moves.begin(), moves.end(), 0) == moves.end();
  const std::vector<Shape> solids = solid_shapes(scene);
  const double reach = kReach * scene.smoothing_length() + 2.0 * scene.support_radius();
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const bool seen =
        all || moves[k] != 0 || std::any_of(solids.begin(), solids.end(), [&](const Shape& solid) {
          return is_loose(solid) && solid.signed_distance(sites.position[k], scene.dimension) < reach;
        });
    if (seen) members.push_back(static_cast<std::uint32_t>(k));
  }
  return members;
}

template <int Dim>
void pack(const Scene& scene, int threads, FluidLattice& sites, const std::vector<char>& moves) {
  const std::vector<std::uint32_t> members = moving_and_seen(scene, sites, moves);
  Packing<Dim> packing(scene, threads, sites, members, moves);
  packing.run();
  const std::vector<Vec3d> places = packing.places();
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (moves[members[k]] != 0) sites.position[members[k]] = places[k];
  }
}

}  // namespace

FluidLattice packed_fluid(const Scene& scene, int threads) {
  const FluidFit fit = fit_fluid(scene);
  const std::vector<Shape> solids = solid_shapes(scene);
  const bool off_lattice = std::any_of(solids.begin(), solids.end(), is_loose);
  if (!off_lattice && fit.misfit <= kLargestMisfit) return fluid_lattice(scene);
  Scene still = scene;
  still.jitter = 0.0;
  FluidLattice sites = fluid_lattice(still);
  const std::vector<char> moves = moving_particles(scene, sites, fit.misfit);
  if (std::find(moves.begin(), moves.end(), 1) != moves.end()) {
    if (scene.dimension == 2) {
      pack<2>(scene, threads, sites, moves);
    } else {
      pack<3>(scene, threads, sites, moves);
    }
  }
  add_jitter(scene, sites.position);
  return sites;
}

}  // namespace eisph
