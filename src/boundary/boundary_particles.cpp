#include "boundary/boundary_particles.hpp"

#include "boundary/mirror_planes.hpp"
#include "boundary/virtual_particles.hpp"

#include <array>

namespace eisph {

namespace {

template <int Dim>
std::vector<Vec3f> find_ghosts(const Scene& scene, const Snapshot& snapshot) {
  std::vector<Vec3f> found;
  const MirrorPlanes<Dim> planes(scene);
  if (!scene.boundary.ghost_particles || planes.empty()) return found;
  const auto h = static_cast<float>(scene.smoothing_length());
  const Vec3f origin = scene.domain_min.cast<float>();
  for (const Vec3f& position : snapshot.position) {
    const Vec3f from = (position - origin) / h;
    const Float4 xi =
        Dim == 2 ? Float4{from.x(), from.z(), 0.0F, 0.0F} : Float4{from.x(), from.y(), from.z(), 0.0F};
    planes.for_images(xi, [&](std::uint8_t code) {
      const auto& image = planes.image(code);
      Vec3f at = position;
      for (int d = 0; d < Dim; ++d) {
        const int axis = scene_axis<Dim>(d);
        at[axis] = origin[axis] + h * (image.scale[d] * (&xi.x)[d] + image.shift[d]);
      }
      found.push_back(at);
    });
  }
  return found;
}

template <int Dim>
std::vector<Vec3f> find_virtuals(const Scene& scene) {
  std::vector<Vec3f> found;
  for (const std::array<double, Dim>& point : VirtualParticles<Dim>(scene).lattice_points()) {
    Vec3d at = scene.domain_min;
    if (Dim == 2) at.y() = 0.0;
    for (int d = 0; d < Dim; ++d) at[scene_axis<Dim>(d)] += point[d];
    found.emplace_back(at.cast<float>());
  }
  return found;
}

}  // namespace

BoundaryParticles boundary_particles(const Scene& scene, const Snapshot& snapshot, bool ghosts,
                                     bool virtual_particles) {
  const bool flat = scene.dimension == 2;
  BoundaryParticles particles;
  if (ghosts) particles.ghosts = flat ? find_ghosts<2>(scene, snapshot) : find_ghosts<3>(scene, snapshot);
  if (virtual_particles) {
    particles.virtual_particles = flat ? find_virtuals<2>(scene) : find_virtuals<3>(scene);
  }
  return particles;
}

}  // namespace eisph
