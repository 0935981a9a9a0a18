#include "probe/fluid_field.hpp"

#include "probe/column_probes.hpp"
#include "probe/kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace eisph {

namespace {

/// Lengths below this part of the particle spacing are rounding.
constexpr double kTolerance = 1e-6;

/// The places from which a coordinate and its mirror images see the particles of an axis.
class MirroredCoordinate {
 public:
  MirroredCoordinate(double value, double lower, double upper, bool at_lower, bool at_upper, double reach) {
    const auto add = [&](double image) {
      if (image >= lower - reach && image <= upper + reach && count_ < images_.size())
        images_[count_++] = image;
    };
    add(value);
    if (at_lower) add(2.0 * lower - value);
    if (at_upper) add(2.0 * upper - value);
    if (!at_lower || !at_upper) return;
    // A domain narrower than the kernel shows images of images.
    const double period = 2.0 * (upper - lower);
    if (period > 4.0 * reach) return;
    for (const double shift : {-period, period}) {
      add(value + shift);
      if (shift < 0.0) add(2.0 * lower - value + shift);
      if (shift > 0.0) add(2.0 * upper - value + shift);
    }
  }
  [[nodiscard]] const double* begin() const { return images_.data(); }
  [[nodiscard]] const double* end() const { return images_.data() + count_; }

 private:
  std::array<double, 8> images_{};
  std::size_t count_ = 0;
};

MirroredCoordinate mirrored(const Scene& scene, int axis, double value, double reach) {
  const auto closed = [&](int face) {
    return axis != 2 || scene.faces[static_cast<std::size_t>(face)].kind != FaceKind::Open;
  };
  return {value, scene.domain_min[axis], scene.domain_max[axis], closed(2 * axis), closed(2 * axis + 1),
          reach};
}

/// Weighted sums of a linear fit about one point. Offsets from it are in smoothing lengths.
struct LinearFit {
  double weight = 0.0;
  double value = 0.0;
  Vec3d offset = Vec3d::Zero();
  Vec3d offset_value = Vec3d::Zero();
  Eigen::Matrix3d offset_offset = Eigen::Matrix3d::Zero();
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();

  void add(const Vec3d& r, double w, double p) {
    weight += w;
    value += w * p;
    offset += w * r;
    offset_value += w * p * r;
    offset_offset += w * r * r.transpose();
    lowest = std::min(lowest, p);
    highest = std::max(highest, p);
  }

  /// Value at the point. Directions in which the particles are not spread count as level.
  [[nodiscard]] std::optional<double> value_at_point() const {
    constexpr double kLeastVariance = 0.01;  // h^2; two layers a spacing apart have 0.08
    if (!(weight > 0.0)) return std::nullopt;
    const double mean = value / weight;
    const Vec3d centre = offset / weight;
    const Eigen::Matrix3d variance = offset_offset / weight - centre * centre.transpose();
    const Vec3d covariance = offset_value / weight - mean * centre;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(variance);
    double result = mean;
    for (int k = 0; k < 3; ++k) {
      if (spread.eigenvalues()(k) < kLeastVariance) continue;
      const Vec3d direction = spread.eigenvectors().col(k);
      result -= centre.dot(direction) * covariance.dot(direction) / spread.eigenvalues()(k);
    }
    if (std::abs(result - mean) > highest - lowest) result = mean;
    return std::max(result, std::min(lowest, 0.0));
  }
};

/// Those of a snapshot with columns are for drawing only.
const Snapshot& particles_of(const Snapshot& snapshot) {
  static const Snapshot kNone;
  return snapshot.columns ? kNone : snapshot;
}

}  // namespace

std::vector<StandingSolid> standing_solids(const Scene& scene, double time) {
  std::vector<StandingSolid> solids;
  for (const Obstacle& obstacle : scene.obstacles) solids.push_back({obstacle.name, obstacle.shape});
  for (const Gate& gate : scene.gates) {
    const std::optional<double> lift = gate.lift(time);
    if (!lift) continue;
    StandingSolid& solid = solids.emplace_back(StandingSolid{gate.name, gate.shape});
    solid.shape.min.z() += *lift;
    solid.shape.max.z() += *lift;
    solid.shape.centre.z() += *lift;
  }
  return solids;
}

FluidField::FluidField(const Scene& scene, const Snapshot& snapshot)
    : scene_(&scene),
      snapshot_(&snapshot),
      solids_(standing_solids(scene, snapshot.time)),
      cells_(particles_of(snapshot), 2.0 * snapshot.smoothing_length) {}

PointSample FluidField::sample_at(const Vec3d& point) const {
  if (snapshot_->columns) return sample_column(point, *snapshot_->columns, *scene_);
  ShepardSum sum(point, *snapshot_);
  cells_.visit_near(point, 2.0 * snapshot_->smoothing_length,
                    [&](std::size_t k, const Vec3f&) { sum.add(k); });
  return sum.sample();
}

double FluidField::distance_to_solids(const Vec3d& point) const {
  double distance = std::numeric_limits<double>::max();
  for (const StandingSolid& solid : solids_) {
    distance = std::min(distance, solid.shape.signed_distance(point, snapshot_->dimension));
  }
  return distance;
}

bool FluidField::is_in_solid(const Vec3d& point) const {
  return distance_to_solids(point) < -kTolerance * snapshot_->particle_spacing;
}

bool FluidField::is_in_domain(const Vec3d& point) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (snapshot_->dimension == 2 && axis == 1) continue;
    if (point[axis] < scene_->domain_min[axis] || point[axis] > scene_->domain_max[axis]) return false;
  }
  return true;
}

double FluidField::water_fraction(const Vec3d& point) const {
  if (snapshot_->columns) return sample_column(point, *snapshot_->columns, *scene_).wet ? 1.0 : 0.0;
  const double dx = snapshot_->particle_spacing;
  const double reach = 2.0 * dx;
  const bool flat = snapshot_->dimension == 2;
  const double volume = snapshot_->particle_mass / snapshot_->reference_density;
  double sum = 0.0;
  const auto add_from = [&](const Vec3d& image) {
    cells_.visit_near(image, reach, [&](std::size_t, const Vec3f& position) {
      const Vec3d offset = (position.cast<double>() - image) / dx;
      const double across = flat ? 1.0 : axis_spline(offset.y());
      sum += axis_spline(offset.x()) * across * axis_spline(offset.z());
    });
  };
  const MirroredCoordinate x = mirrored(*scene_, 0, point.x(), reach);
  const MirroredCoordinate y =
      flat ? MirroredCoordinate(0.0, 0.0, 0.0, false, false, reach) : mirrored(*scene_, 1, point.y(), reach);
  const MirroredCoordinate z = mirrored(*scene_, 2, point.z(), reach);
  for (const double image_z : z) {
    for (const double image_y : y) {
      for (const double image_x : x) add_from(Vec3d(image_x, image_y, image_z));
    }
  }
  constexpr double kLeastSpace = 0.1;
  double solid = 0.0;
  if (!solids_.empty()) {
    const double distance = distance_to_solids(point) / dx;
    solid = axis_spline(distance + 0.5) + axis_spline(distance + 1.5);
  }
  return sum * volume / std::pow(dx, snapshot_->dimension) / std::max(1.0 - solid, kLeastSpace);
}

std::optional<double> FluidField::wall_pressure(const Vec3d& point, const Vec3d& normal) const {
  if (snapshot_->columns) return column_wall_pressure(point, normal, *snapshot_->columns, *scene_);
  if (!is_wet(point)) return std::nullopt;
  const double h = snapshot_->smoothing_length;
  // Water behind a thin wall has no say.
  const double behind = -0.25 * snapshot_->particle_spacing;
  LinearFit fit;
  cells_.visit_near(point, 2.0 * h, [&](std::size_t k, const Vec3f& position) {
    Vec3d offset = position.cast<double>() - point;
    if (snapshot_->dimension == 2) offset.y() = 0.0;
    const double distance = offset.norm();
    if (!(distance < 2.0 * h) || offset.dot(normal) < behind) return;
    fit.add(offset / h, radial_spline(distance / h), snapshot_->pressure[k]);
  });
  return fit.value_at_point();
}

}  // namespace eisph
