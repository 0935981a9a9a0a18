#pragma once

#include "boundary/mirror_planes.hpp"
#include "core/aligned_buffer.hpp"
#include "core/thread_pool.hpp"
#include "sph/cell_grid.hpp"
#include "sph/cell_sort.hpp"
#include "sph/source_table.hpp"

#include <cstdint>

namespace eisph {

/// The mirror images of one group of particles: only those near a wall or a symmetry plane have any, and only
/// these are stored. Sorted by cell.
template <int Dim>
class MirrorParticles {
 public:
  /// Finds the images of the particles in rows[0..count). `rows` are positions in smoothing lengths.
  void find(const MirrorPlanes<Dim>& planes, const CellGrid<Dim>& grid, const Float4* rows, std::size_t count,
            ThreadPool& pool, CellSort::Workspace& workspace);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(images_.size()); }
  /// Of the k-th image: the particle that it is of, and the code of MirrorPlanes.
  [[nodiscard]] std::uint32_t origin(std::size_t k) const { return images_[k].origin; }
  [[nodiscard]] std::uint8_t code(std::size_t k) const { return static_cast<std::uint8_t>(images_[k].code); }
  [[nodiscard]] const std::uint32_t* start() const { return sort_.start(); }
  [[nodiscard]] std::size_t bytes() const {
    return found_.bytes() + images_.bytes() + block_count_.bytes() + sort_.bytes();
  }

  /// Writes the images' rows from the particles': positions (w is copied), vectors (w is copied), or w alone.
  void mirror_positions(const MirrorPlanes<Dim>& planes, const Float4* rows, Float4* out,
                        ThreadPool& pool) const;
  void mirror_vectors(const MirrorPlanes<Dim>& planes, const Float4* rows, Float4* out,
                      ThreadPool& pool) const;
  /// Like mirror_vectors, of gradients: reflected whatever the slip of the walls.
  void mirror_gradients(const MirrorPlanes<Dim>& planes, const Float4* rows, Float4* out,
                        ThreadPool& pool) const;
  void mirror_pressure(const Float4* rows, Float4* out, ThreadPool& pool) const;

 private:
  struct Entry {
    std::uint32_t origin;
    std::uint32_t code;
  };

  AlignedBuffer<Entry> found_;   ///< in the order of the particles
  AlignedBuffer<Entry> images_;  ///< by cell
  AlignedBuffer<std::uint32_t> block_count_;
  CellSort sort_;
};

}  // namespace eisph
