#pragma once

#include "core/aligned_buffer.hpp"
#include "core/pack.hpp"

#include <cstdint>
#include <span>

namespace eisph {

/// Everything a particle can have as a neighbour, addressed by one index: first one row that never counts (it
/// fills the last pack of a neighbour list), then object particles, their mirror images, fluid particles and
/// theirs. Each group is sorted by cell.
struct SourceTable {
  AlignedBuffer<Float4> position;  ///< x, y, z in smoothing lengths (2D: x, z, 0); w: pressure, Pa
  AlignedBuffer<Float4> velocity;  ///< m/s; w: volume, m^3 (m^2 in 2D)
  AlignedBuffer<Float4> source;    ///< the vector whose divergence drives the pressure, m/s; w: volume

  static constexpr std::uint32_t kNothing = 0;  ///< far away, no volume
  static constexpr float kFarAway = 1e6F;

  std::uint32_t first_object = 1;
  std::uint32_t first_object_image = 1;
  std::uint32_t first_fluid = 1;
  std::uint32_t first_image = 1;
  std::uint32_t end = 1;

  /// Lays the groups out one after the other. Rows of groups whose place stays the same keep their content.
  void lay_out(std::uint32_t objects, std::uint32_t object_images, std::uint32_t fluid,
               std::uint32_t images) {
    first_object_image = first_object + objects;
    first_fluid = first_object_image + object_images;
    first_image = first_fluid + fluid;
    end = first_image + images;
    for (AlignedBuffer<Float4>* array : {&position, &velocity, &source}) array->resize(end);
    position[kNothing] = {kFarAway, kFarAway, kFarAway, 0.0F};
    velocity[kNothing] = {};
    source[kNothing] = {};
  }

  [[nodiscard]] std::size_t bytes() const { return position.bytes() + velocity.bytes() + source.bytes(); }
};

/// A group of the table: its particles by cell.
struct SourceGroup {
  std::uint32_t first = 0;               ///< table index of the group's first particle
  const std::uint32_t* start = nullptr;  ///< start[c] to start[c + 1]: the group's particles of cell c
  bool empty = true;
};

}  // namespace eisph
