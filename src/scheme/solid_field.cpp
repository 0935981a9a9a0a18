#include "scheme/solid_field.hpp"

#include "scheme/neighbour_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace eisph {

namespace {

constexpr std::size_t kBlock = 256;
/// Least spread of the fluid along a surface that a plane is fitted to, in parts of that about a point within
/// the fluid: a single row of particles before a far layer has less.
constexpr double kLeastSpread = 0.2;

/// Moments of the fluid about an object particle and the sum of its velocities, weighted with the kernel;
/// lengths in smoothing lengths.
template <int Dim>
struct MomentSums {
  static constexpr int kEntries = Dim * (Dim + 1) / 2;
  Pack weight = splat<Pack>(0.0);
  Vector<Dim, Pack> first = zero_vector<Dim, Pack>();
  Vector<kEntries, Pack> second = zero_vector<kEntries, Pack>();
  Vector<Dim, Pack> velocity = zero_vector<Dim, Pack>();

  template <class Kernel>
  void add(const PairGeometry<Dim, Pack, Kernel>& pair, const Vector<Dim, Pack>& u) {
    const Pack w = pair.value();
    weight += w;
    int entry = 0;
    for (int a = 0; a < Dim; ++a) {
      const Pack along = w * pair.offset.x[a];
      first.x[a] -= along;
      velocity.x[a] += w * u.x[a];
      for (int b = a; b < Dim; ++b) second.x[entry++] += along * pair.offset.x[b];
    }
  }
};

}  // namespace

template <int Dim>
template <class Body>
void SolidField<Dim>::for_wet(const Body& body) {
  particles_.pool.run_blocks(particles_.objects(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      if (particles_.neighbours.is_wet(particles_.object_row(k))) body(k);
    }
  });
}

/// Puts what pressures(k) returns, of the table and to keep, where it belongs; dry solids have none.
template <int Dim>
template <class Pressures>
void SolidField<Dim>::put(const Pressures& pressures) {
  ParticleSystem<Dim>& p = particles_;
  p.pool.run_blocks(p.objects(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      std::array<float, 2> found{};
      if (p.neighbours.is_wet(p.object_row(k))) found = pressures(k);
      p.table.position[p.object_row(k)].w = found[0];
      p.kept_object_pressure(k) = found[1];
    }
  });
  p.mirror_object_pressure();
}

template <int Dim>
float SolidField<Dim>::clamped(double pressure) const {
  return static_cast<float>(particles_.scene.scheme.clamp_pressure ? std::max(0.0, pressure) : pressure);
}

template <int Dim>
void SolidField<Dim>::find_weights() {
  if (empty()) return;
  weights_.resize(particles_.objects());
  rise_.resize(particles_.objects());
  mean_velocity_.resize(particles_.objects());
  for_wet([&](std::size_t k) { find_weights(k); });
}

/// With m = <r>, S = <r r'> over the fluid, r = (x_f - x_j) / h, T = 1 - n n' and the spread along the
/// surface M = T (S - m m') T + sigma n n', the plane through the values q_f has at r = 0 along the surface
/// the value
///   <q> - (T m) . M^-1 <(r - m) q> = <(c - b . r) q>,  b = M^-1 T m,  c = 1 + b . m.
template <int Dim>
void SolidField<Dim>::find_weights(std::size_t k) {
  const ParticleSystem<Dim>& p = particles_;
  using Column = Eigen::Matrix<double, Dim, 1>;
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  const std::uint32_t row = p.object_row(k);
  MomentSums<Dim> sums;
  for_neighbours<Dim>(p, row, p.neighbours.of(row),
                      [&](const std::uint32_t* j, const auto& pair, const Pack&) {
                        sums.add(pair, components<Dim>(gather_rows(p.table.velocity.data(), j)));
                      });
  const double weight = horizontal_sum(sums.weight);
  weights_[k] = mean_velocity_[k] = {};
  rise_[k] = 0.0F;
  // The outermost neighbours may have none to speak of.
  if (!(weight > 1e-9)) return;

  Column mean;
  Column normal;
  Column gravity;
  Matrix second;
  int entry = 0;
  for (int a = 0; a < Dim; ++a) {
    mean[a] = horizontal_sum(sums.first.x[a]) / weight;
    normal[a] = (&p.object_normal(k).x)[a];
    gravity[a] = p.gravity[a];
    (&mean_velocity_[k].x)[a] = static_cast<float>(horizontal_sum(sums.velocity.x[a]) / weight);
    for (int b = a; b < Dim; ++b) {
      second(a, b) = second(b, a) = horizontal_sum(sums.second.x[entry++]) / weight;
    }
  }
  const bool has_normal = normal.squaredNorm() > 0.5;
  const Matrix tangential = Matrix::Identity() - normal * normal.transpose();
  const double spread = p.lattice.spread;
  const Matrix along =
      tangential * (second - mean * mean.transpose()) * tangential + spread * normal * normal.transpose();
  const double least =
      (has_normal ? spread : kLeastSpread * spread) * std::pow(kLeastSpread * spread, Dim - 1);
  Column slope = Column::Zero();
  if (along.determinant() > least) slope = along.inverse() * (tangential * mean);
  const double constant = 1.0 + slope.dot(mean);
  for (int a = 0; a < Dim; ++a) (&weights_[k].x)[a] = static_cast<float>(slope[a] / weight);
  weights_[k].w = static_cast<float>(constant / weight);
  const double rise = slope.dot(second * normal) - constant * normal.dot(mean);
  rise_[k] = static_cast<float>(p.scene.density * p.h * gravity.dot(normal) * rise);
}

template <int Dim>
Float4 SolidField<Dim>::mirrored_velocity(std::size_t k) const {
  const float* wall = &particles_.object_velocity(k).x;
  const float* normal = &particles_.object_normal(k).x;
  const float* mean = &mean_velocity_[k].x;
  float across = 0.0F;
  for (int d = 0; d < Dim; ++d) across += (mean[d] - wall[d]) * normal[d];
  Float4 result{};
  for (int d = 0; d < Dim; ++d) (&result.x)[d] = mean[d] - 2.0F * across * normal[d];
  return result;
}

template <int Dim>
void SolidField<Dim>::set_velocities() {
  ParticleSystem<Dim>& p = particles_;
  if (empty() || p.scene.boundary.object_no_slip) return;
  for_wet([&](std::size_t k) {
    Float4& velocity = p.table.velocity[p.object_row(k)];
    const float volume = velocity.w;
    velocity = mirrored_velocity(k);
    velocity.w = volume;
  });
  p.mirror_object_vectors(p.table.velocity);
}

template <int Dim>
void SolidField<Dim>::set_sources(double omega, double time_step) {
  ParticleSystem<Dim>& p = particles_;
  if (empty()) return;
  const auto factor = static_cast<float>(omega);
  for_wet([&](std::size_t k) {
    const Float4 velocity = mirrored_velocity(k);
    Float4& source = p.table.source[p.object_row(k)];
    for (int d = 0; d < Dim; ++d) {
      (&source.x)[d] = factor * (&velocity.x)[d] + static_cast<float>(time_step * p.gravity[d]);
    }
  });
  p.mirror_object_vectors(p.table.source);
}

/// Carried pressures of the fluid rows of a pack of indices and of the originals of images among them.
template <int Dim>
Pack SolidField<Dim>::carried_pressures(const std::uint32_t* j) const {
  const ParticleSystem<Dim>& p = particles_;
  Pack pressures = splat<Pack>(0.0);
  for (std::size_t lane = 0; lane < kPackWidth; ++lane) {
    if (j[lane] == SourceTable::kNothing) break;
    const std::uint32_t i = j[lane] < p.table.first_image
                                ? j[lane] - p.table.first_fluid
                                : p.fluid_images.origin(j[lane] - p.table.first_image);
    pressures[lane] = p.carried[i];
  }
  return pressures;
}

template <int Dim>
template <bool Carried>
std::array<double, 2> SolidField<Dim>::extrapolated(std::size_t k) const {
  const ParticleSystem<Dim>& p = particles_;
  const std::uint32_t row = p.object_row(k);
  const auto slope = splat_row<Dim>(weights_[k]);
  const Pack constant = splat<Pack>(weights_[k].w);
  Pack sum = splat<Pack>(0.0);
  Pack carried = splat<Pack>(0.0);
  for_neighbours<Dim>(p, row, p.neighbours.of(row),
                      [&](const std::uint32_t* j, const auto& pair, const Pack& pressure) {
                        Pack factor = constant;
                        for (int d = 0; d < Dim; ++d) factor += slope.x[d] * pair.offset.x[d];
                        factor *= pair.value();
                        sum += factor * pressure;
                        if constexpr (Carried) carried += factor * carried_pressures(j);
                      });
  return {horizontal_sum(sum), horizontal_sum(carried)};
}

template <int Dim>
void SolidField<Dim>::extrapolate() {
  if (empty()) return;
  put([&](std::size_t k) {
    const float pressure = clamped(extrapolated<false>(k)[0] + rise_[k]);
    return std::array<float, 2>{pressure, pressure};
  });
}

template <int Dim>
void SolidField<Dim>::extrapolate_twice() {
  if (empty()) return;
  put([&](std::size_t k) {
    const std::array<double, 2> pressure = extrapolated<true>(k);
    return std::array<float, 2>{clamped(pressure[0] + rise_[k]), clamped(pressure[1] + rise_[k])};
  });
}

template <int Dim>
template <class Pressure>
void SolidField<Dim>::put_into_table(const Pressure& pressure) {
  if (empty()) return;
  for_wet([&](std::size_t k) {
    particles_.table.position[particles_.object_row(k)].w = static_cast<float>(pressure(k));
  });
  particles_.mirror_object_pressure();
}

template <int Dim>
void SolidField<Dim>::extrapolate_unclamped() {
  put_into_table([&](std::size_t k) { return extrapolated<false>(k)[0] + rise_[k]; });
}

template <int Dim>
void SolidField<Dim>::extrapolate_linear() {
  put_into_table([&](std::size_t k) { return extrapolated<false>(k)[0]; });
}

template class SolidField<2>;
template class SolidField<3>;

}  // namespace eisph
