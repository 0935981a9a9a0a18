#include "boundary/solid_particles.hpp"

#include "core/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace eisph {

SolidParticles::SolidParticles(const Scene& scene)
    : dimension_(scene.dimension), repulsion_(repulsion_of_solids(scene)), sides_(scene) {
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
      Particle particle;
      particle.position = lattice.position[k];
      particle.volume = lattice.volume[k];
      particle.solid = static_cast<std::uint32_t>(s);
      particle.by_gate = solid.is_gate;
      particles_.push_back(particle);
    }
    solids_.push_back(solid);
  }
  find_sides(true);
  mark_near_gates(scene);
  list_present();
  update(0.0);
}

void SolidParticles::mark_near_gates(const Scene& scene) {
  for (const Gate& gate : scene.gates) {
    Vec3d lower;
    Vec3d upper;
    gate.shape.bounds(lower, upper);
    upper.z() += gate.stroke;
    for (Particle& particle : particles_) {
      particle.by_gate =
          particle.by_gate || sides_.may_touch(particle.solid, particle.position, lower, upper);
    }
  }
}

void SolidParticles::find_sides(bool all) {
  std::vector<std::optional<Shape>> shapes;
  for (const Solid& solid : solids_) {
    std::optional<Shape>& shape = shapes.emplace_back();
    if (!solid.present) continue;
    shape = solid.shape;
    shape->min.z() += solid.lift;
    shape->max.z() += solid.lift;
    shape->centre.z() += solid.lift;
  }
  sides_.place(std::move(shapes));
  for (Particle& particle : particles_) {
    const Solid& solid = solids_[particle.solid];
    if (!solid.present || !(all || particle.by_gate)) continue;
    const Vec3d at = particle.position + Vec3d(0.0, 0.0, solid.lift);
    const std::vector<SolidSide> sides = sides_.of(particle.solid, at);
    particle.side_count = static_cast<std::uint8_t>(sides.size());
    std::copy(sides.begin(), sides.end(), particle.sides.begin());
  }
}

void SolidParticles::list_present() {
  present_.clear();
  particles_present_ = 0;
  for (std::size_t k = 0; k < particles_.size(); ++k) {
    if (!solids_[particles_[k].solid].present) continue;
    ++particles_present_;
    for (std::uint32_t side = 0; side < particles_[k].side_count; ++side) {
      present_.push_back({static_cast<std::uint32_t>(k), side});
    }
  }
}

bool SolidParticles::update(double time) {
  bool changed = false;
  for (Solid& solid : solids_) {
    if (!solid.is_gate || !solid.present) continue;
    const std::optional<double> lift = solid.gate.lift(time);
    const bool moving =
        lift.has_value() && solid.gate.motion == GateMotion::Lift && time >= solid.gate.start_time;
    const double rise_speed = moving ? solid.gate.speed : 0.0;
    if (!lift) {
      solid.present = false;
      changed = true;
    } else if (*lift != solid.lift || rise_speed != solid.rise_speed) {
      changed = true;
      solid.lift = *lift;
      solid.rise_speed = rise_speed;
    }
  }
  if (!changed) return false;
  find_sides(false);
  list_present();
  return true;
}

Vec3d SolidParticles::position(std::size_t k) const {
  const Particle& particle = particles_[present_[k].particle];
  return particle.position + Vec3d(0.0, 0.0, solids_[particle.solid].lift);
}

double SolidParticles::rise_speed(std::size_t k) const {
  return solids_[particles_[present_[k].particle].solid].rise_speed;
}

void SolidParticles::add_repulsion(const Vec3d& point, Vec3d& acceleration) const {
  for (const Solid& solid : solids_) {
    if (!solid.present) continue;
    const Vec3d local = point - Vec3d(0.0, 0.0, solid.lift);
    const double distance = solid.shape.signed_distance(local, dimension_);
    if (distance < repulsion_.cutoff) {
      acceleration += repulsion_.capped(distance) * solid.shape.outward_normal(local, dimension_);
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
    normal = solid.shape.outward_normal(local, dimension_);
    point += (depth * (1.0 + 1e-9) + 1e-12) * normal;
  }
  return inside;
}

std::size_t SolidParticles::bytes() const {
  return particles_.capacity() * sizeof(Particle) + present_.capacity() * sizeof(PresentSide);
}

}  // namespace eisph
