#pragma once

#include "boundary/solid_sides.hpp"
#include "core/repulsion.hpp"
#include "core/scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace eisph {

/// The object particles of a scene (thesis section 3.3.2): obstacles and dam walls, which stay, and gates,
/// which rise or vanish. They take part in every sum like water that continues behind the surface. What is
/// numbered are the sides of the particles (SolidSides): a particle of a thin solid that water on both sides
/// sees is there twice.
class SolidParticles {
 public:
  SolidParticles() = default;
  /// Fills the solids with the particles of scene_solids.
  explicit SolidParticles(const Scene& scene);

  [[nodiscard]] std::size_t size() const { return present_.size(); }
  /// Number of particles, each counted once.
  [[nodiscard]] std::size_t particles() const { return particles_present_; }
  /// Whether the k-th is the first side of its particle.
  [[nodiscard]] bool is_first_side(std::size_t k) const { return present_[k].side == 0; }
  /// Whether any particle has two sides.
  [[nodiscard]] bool has_thin_solids() const { return present_.size() > particles_present_; }
  /// Moves the gates to their place at `time`, s. Returns whether anything differs from the last call.
  bool update(double time);

  /// Of the k-th side present: m (absolute), m^3 (m^2 in 2D), m/s.
  [[nodiscard]] Vec3d position(std::size_t k) const;
  [[nodiscard]] double volume(std::size_t k) const { return particles_[present_[k].particle].volume; }
  [[nodiscard]] double rise_speed(std::size_t k) const;
  [[nodiscard]] const SolidSide& side(std::size_t k) const {
    return particles_[present_[k].particle].sides[present_[k].side];
  }
  /// Pressure kept for the k-th side present, Pa.
  float& pressure(std::size_t k) { return particles_[present_[k].particle].pressure[present_[k].side]; }
  [[nodiscard]] float pressure(std::size_t k) const {
    return particles_[present_[k].particle].pressure[present_[k].side];
  }

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
    std::uint32_t solid;
    bool by_gate = false;  ///< of a gate, or so near one that its sides change with it
    std::uint8_t side_count = 1;
    std::array<SolidSide, 2> sides{};
    std::array<float, 2> pressure{};
  };
  struct PresentSide {
    std::uint32_t particle;
    std::uint32_t side;
  };

  void mark_near_gates(const Scene& scene);
  /// The sides of all particles, or of those that may change when a gate does.
  void find_sides(bool all);
  void list_present();

  int dimension_ = 3;
  double spacing_ = 0.0;
  Repulsion repulsion_;
  std::vector<Solid> solids_;
  SolidSides sides_;
  std::vector<Particle> particles_;
  std::vector<PresentSide> present_;
  std::size_t particles_present_ = 0;
};

}  // namespace eisph
