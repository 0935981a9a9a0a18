#include "boundary/solid_particles.hpp"

#include "core/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

SolidParticles::SolidParticles(const Scene& scene) : dimension_(scene.dimension) {
  if (scene.boundary.object_repulsion) repulsion_ = Repulsion(scene);
  const SceneSolids lattice = scene_solids(scene);
  spacing_ = lattice.spacing;
  for (std::size_t s = 0; s < lattice.ranges.size(); ++s) {
    Solid solid;
    solid.is_gate = s >= scene.obstacles.size();
    if (solid.is_gate) solid.gate = scene.gates[s - scene.obstacles.size()];
    solid.shape = solid.is_gate ? solid.gate.shape : scene.obstacles[s].shape;
    solid.first = lattice.ranges[s].first;
    solid.count = lattice.ranges[s].count;
    for (std::size_t k = solid.first; k < solid.first + solid.count; ++k) {
      particles_.push_back({lattice.position[k], lattice.volume[k], 0.0F, static_cast<std::uint32_t>(s)});
    }
    solids_.push_back(solid);
  }
  list_present();
  update(0.0);
}

void SolidParticles::list_present() {
  present_.clear();
  for (const Solid& solid : solids_) {
    if (!solid.present) continue;
    for (std::size_t k = 0; k < solid.count; ++k) {
      present_.push_back(static_cast<std::uint32_t>(solid.first + k));
    }
  }
}

bool SolidParticles::update(double time) {
  bool changed = false;
  bool left = false;
  for (Solid& solid : solids_) {
    if (!solid.is_gate || !solid.present) continue;
    const std::optional<double> lift = solid.gate.lift(time);
    const bool moving =
        lift.has_value() && solid.gate.motion == GateMotion::Lift && time >= solid.gate.start_time;
    const double rise_speed = moving ? solid.gate.speed : 0.0;
    if (!lift) {
      solid.present = false;
      left = true;
    } else if (*lift != solid.lift || rise_speed != solid.rise_speed) {
      changed = true;
      solid.lift = *lift;
      solid.rise_speed = rise_speed;
    }
  }
  if (left) list_present();
  return changed || left;
}

Vec3d SolidParticles::position(std::size_t k) const {
  const Particle& particle = particles_[present_[k]];
  return particle.position + Vec3d(0.0, 0.0, solids_[particle.solid].lift);
}

double SolidParticles::rise_speed(std::size_t k) const {
  return solids_[particles_[present_[k]].solid].rise_speed;
}

Vec3d SolidParticles::outward_normal(const Solid& solid, const Vec3d& point) const {
  const double step = 1e-6;
  Vec3d normal = Vec3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (dimension_ == 2 && axis == 1) continue;
    const Vec3d shift = step * Vec3d::Unit(axis);
    normal[axis] = solid.shape.signed_distance(point + shift, dimension_) -
                   solid.shape.signed_distance(point - shift, dimension_);
  }
  const double length = normal.norm();
  return length > 0.0 ? Vec3d(normal / length) : Vec3d::UnitZ();
}

void SolidParticles::add_repulsion(const Vec3d& point, Vec3d& acceleration) const {
  for (const Solid& solid : solids_) {
    if (!solid.present) continue;
    const Vec3d local = point - Vec3d(0.0, 0.0, solid.lift);
    const double distance = solid.shape.signed_distance(local, dimension_);
    if (distance < repulsion_.cutoff) {
      acceleration += repulsion_.capped(distance) * outward_normal(solid, local);
    }
  }
}

bool SolidParticles::push_out(Vec3d& point, Vec3d& normal) const {
  bool inside = false;
  for (const Solid& solid : solids_) {
    if (!solid.present) continue;
    const Vec3d local = point - Vec3d(0.0, 0.0, solid.lift);
    const double depth = -solid.shape.signed_distance(local, dimension_);
    if (depth <= 0.0) continue;
    inside = true;
    normal = outward_normal(solid, local);
    point += (depth * (1.0 + 1e-9) + 1e-12) * normal;
  }
  return inside;
}

std::size_t SolidParticles::bytes() const {
  return particles_.capacity() * sizeof(Particle) + present_.capacity() * sizeof(std::uint32_t);
}

}  // namespace eisph
