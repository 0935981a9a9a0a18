#include "boundary/mirror_particles.hpp"

namespace eisph {

namespace {

constexpr std::size_t kBlock = 2048;

template <int Dim>
Float4 mirror_position(const typename MirrorPlanes<Dim>::Image& image, const Float4& row) {
  Float4 out;
  out.x = image.scale[0] * row.x + image.shift[0];
  out.y = image.scale[1] * row.y + image.shift[1];
  if constexpr (Dim == 3) out.z = image.scale[2] * row.z + image.shift[2];
  out.w = row.w;
  return out;
}

/// `factors`: by component.
template <int Dim>
Float4 mirror_vector(const std::array<float, Dim>& factors, const Float4& row) {
  Float4 out;
  out.x = factors[0] * row.x;
  out.y = factors[1] * row.y;
  if constexpr (Dim == 3) out.z = factors[2] * row.z;
  out.w = row.w;
  return out;
}

}  // namespace

template <int Dim>
void MirrorParticles<Dim>::find(const MirrorPlanes<Dim>& planes, const CellGrid<Dim>& grid,
                                const Float4* rows, std::size_t count, ThreadPool& pool,
                                CellSort::Workspace& workspace) {
  const std::size_t blocks = planes.empty() ? 0 : (count + kBlock - 1) / kBlock;
  block_count_.resize(blocks + 1);
  pool.run_blocks(blocks == 0 ? 0 : count, kBlock, [&](std::size_t first, std::size_t last, int) {
    std::uint32_t images = 0;
    for (std::size_t i = first; i < last; ++i) {
      planes.for_images(rows[i], [&](std::uint8_t) { ++images; });
    }
    block_count_[first / kBlock] = images;
  });
  std::uint32_t total = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::uint32_t here = block_count_[block];
    block_count_[block] = total;
    total += here;
  }
  found_.resize(total);
  images_.resize(total);
  pool.run_blocks(blocks == 0 ? 0 : count, kBlock, [&](std::size_t first, std::size_t last, int) {
    std::uint32_t next = block_count_[first / kBlock];
    for (std::size_t i = first; i < last; ++i) {
      planes.for_images(rows[i], [&](std::uint8_t code) {
        found_[next++] = {static_cast<std::uint32_t>(i), code};
      });
    }
  });
  sort_.sort(total, grid.cells(), pool, workspace, [&](std::size_t k) {
    const Entry& entry = found_[k];
    const Float4 at =
        mirror_position<Dim>(planes.image(static_cast<std::uint8_t>(entry.code)), rows[entry.origin]);
    return grid.index(&at.x);
  });
  pool.run_blocks(total, kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) images_[k] = found_[sort_.order()[k]];
  });
}

template <int Dim>
void MirrorParticles<Dim>::mirror_positions(const MirrorPlanes<Dim>& planes, const Float4* rows, Float4* out,
                                            ThreadPool& pool) const {
  pool.run_blocks(images_.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const Entry& entry = images_[k];
      out[k] = mirror_position<Dim>(planes.image(static_cast<std::uint8_t>(entry.code)), rows[entry.origin]);
    }
  });
}

template <int Dim>
void MirrorParticles<Dim>::mirror_vectors(const MirrorPlanes<Dim>& planes, const Float4* rows, Float4* out,
                                          ThreadPool& pool) const {
  pool.run_blocks(images_.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const Entry& entry = images_[k];
      out[k] = mirror_vector<Dim>(planes.image(static_cast<std::uint8_t>(entry.code)).velocity,
                                  rows[entry.origin]);
    }
  });
}

template <int Dim>
void MirrorParticles<Dim>::mirror_gradients(const MirrorPlanes<Dim>& planes, const Float4* rows, Float4* out,
                                            ThreadPool& pool) const {
  pool.run_blocks(images_.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) {
      const Entry& entry = images_[k];
      out[k] =
          mirror_vector<Dim>(planes.image(static_cast<std::uint8_t>(entry.code)).scale, rows[entry.origin]);
    }
  });
}

template <int Dim>
void MirrorParticles<Dim>::mirror_pressure(const Float4* rows, Float4* out, ThreadPool& pool) const {
  pool.run_blocks(images_.size(), kBlock, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t k = first; k < last; ++k) out[k].w = rows[images_[k].origin].w;
  });
}

template class MirrorParticles<2>;
template class MirrorParticles<3>;

}  // namespace eisph
