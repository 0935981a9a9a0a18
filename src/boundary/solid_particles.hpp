#pragma once

#include "boundary/virtual_particles.hpp"
#include "core/scene.hpp"

#include <cstdint>
#include <vector>

namespace eisph {

/// The object particles of a scene (thesis section 3.3.2): obstacles and dam walls, which stay, and gates,
/// which rise or vanish. They take part in every sum like water that does not move.
class SolidParticles {
 public:
  SolidParticles() = default;
  /// Fills the solids with the particles of scene_solids.
  explicit SolidParticles(const Scene& scene);

  [[nodiscard]] std::size_t size() const { return present_.size(); }
  /// Moves the gates to their place at `time`, s. Returns whether anything differs from the last call.
  bool update(double time);

  /// Of the k-th particle present: m (absolute), m^3 (m^2 in 2D), m/s.
  [[nodiscard]] Vec3d position(std::size_t k) const;
  [[nodiscard]] double volume(std::size_t k) const { return particles_[present_[k]].volume; }
  [[nodiscard]] double rise_speed(std::size_t k) const;
  /// Pressure kept for the k-th particle present, Pa.
  float& pressure(std::size_t k) { return particles_[present_[k]].pressure; }
  [[nodiscard]] float pressure(std::size_t k) const { return particles_[present_[k]].pressure; }

  /// Largest spacing of the lattices, m.
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] bool empty() const { return solids_.empty(); }

  /// Adds the repulsion of the surfaces, m/s^2, by the distance to each and along its normal. The thesis has
  /// none; without it water pressed hard against an obstacle sinks in by up to 0.75 dx.
  void add_repulsion(const Vec3d& point, Vec3d& acceleration) const;
  /// If `point` lies inside a solid: moves it out through the nearest surface, sets `normal` to the outward
  /// normal there and returns true.
  bool push_out(Vec3d& point, Vec3d& normal) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Solid {
    Shape shape;
    Gate gate;  ///< of gates
    bool is_gate = false;
    bool present = true;
    double lift = 0.0;
    double rise_speed = 0.0;
    std::size_t first = 0;
    std::size_t count = 0;
  };
  struct Particle {
    Vec3d position;  ///< closed position
    double volume;
    float pressure;
    std::uint32_t solid;
  };

  /// Outward normal of the solid's surface nearest to `point`, by differences of the distance.
  [[nodiscard]] Vec3d outward_normal(const Solid& solid, const Vec3d& point) const;
  void list_present();

  int dimension_ = 3;
  double spacing_ = 0.0;
  Repulsion repulsion_;
  std::vector<Solid> solids_;
  std::vector<Particle> particles_;
  std::vector<std::uint32_t> present_;
};

}  // namespace eisph
