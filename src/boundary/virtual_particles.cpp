#include "boundary/virtual_particles.hpp"

#include <algorithm>
#include <cmath>

namespace eisph {

template <int Dim>
VirtualParticles<Dim>::VirtualParticles(const Scene& scene)
    : repulsion_(scene), form_(scene.boundary.repulsion_form) {
  spacing_ = 0.5 * scene.particle_spacing;
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    extent_[d] = scene.domain_max[axis] - scene.domain_min[axis];
    const Face& lower = scene.faces[2 * axis];
    const Face& upper = scene.faces[2 * axis + 1];
    if (lower.kind != FaceKind::Symmetry && upper.kind == FaceKind::Symmetry) origin_[d] = extent_[d];
    if (!scene.boundary.virtual_particles) continue;
    if (lower.kind == FaceKind::Wall) walls_.push_back({d, 0.0, 1.0});
    if (upper.kind == FaceKind::Wall) walls_.push_back({d, extent_[d], -1.0});
  }
}

template <int Dim>
void VirtualParticles<Dim>::add_acceleration(const std::array<double, Dim>& position,
                                             std::array<double, Dim>& acceleration) const {
  std::array<double, Dim> push{};
  for (const Wall& wall : walls_) {
    const double distance = (position[wall.axis] - wall.position) * wall.inward;
    if (distance >= repulsion_.cutoff) continue;
    if (form_ == RepulsionForm::Even) {
      push[wall.axis] += wall.inward * repulsion_.raw(distance);
    } else {
      add_lattice(wall, position, push);
    }
  }
  double squared = 0.0;
  for (int d = 0; d < Dim; ++d) squared += push[d] * push[d];
  if (squared == 0.0) return;
  const double scale = std::min(1.0, repulsion_.cap / std::sqrt(squared));
  for (int d = 0; d < Dim; ++d) acceleration[d] += scale * push[d];
}

template <int Dim>
void VirtualParticles<Dim>::add_lattice(const Wall& wall, const std::array<double, Dim>& position,
                                        std::array<double, Dim>& acceleration) const {
  const double cutoff = repulsion_.cutoff;
  // First node within the cutoff along each axis in the wall, and one past the last.
  std::array<long, Dim> first{};
  std::array<long, Dim> last{};
  for (int d = 0; d < Dim; ++d) {
    if (d == wall.axis) continue;
    first[d] = std::lround(std::ceil((position[d] - cutoff - origin_[d]) / spacing_));
    last[d] = std::lround(std::floor((position[d] + cutoff - origin_[d]) / spacing_));
  }
  std::array<long, Dim> node = first;
  std::array<double, Dim> offset{};
  offset[wall.axis] =
      std::max((position[wall.axis] - wall.position) * wall.inward, Repulsion::kNearest * cutoff) *
      wall.inward;
  const int a = wall.axis == 0 ? 1 : 0;
  const int b = Dim - 1 == wall.axis ? Dim - 2 : Dim - 1;
  for (node[a] = first[a]; node[a] <= last[a]; ++node[a]) {
    offset[a] = position[a] - origin_[a] - spacing_ * static_cast<double>(node[a]);
    if constexpr (Dim == 2) {
      add_node(offset, acceleration);
    } else {
      for (node[b] = first[b]; node[b] <= last[b]; ++node[b]) {
        offset[b] = position[b] - origin_[b] - spacing_ * static_cast<double>(node[b]);
        add_node(offset, acceleration);
      }
    }
  }
}

template <int Dim>
void VirtualParticles<Dim>::add_node(const std::array<double, Dim>& offset,
                                     std::array<double, Dim>& acceleration) const {
  double squared = 0.0;
  for (int d = 0; d < Dim; ++d) squared += offset[d] * offset[d];
  const double distance = std::sqrt(squared);
  const double scale = repulsion_.raw(distance) / distance;
  for (int d = 0; d < Dim; ++d) acceleration[d] += scale * offset[d];
}

template <int Dim>
std::vector<std::array<double, Dim>> VirtualParticles<Dim>::lattice_points() const {
  std::vector<std::array<double, Dim>> points;
  for (const Wall& wall : walls_) {
    std::array<long, Dim> count{};
    std::size_t nodes = 1;
    for (int d = 0; d < Dim; ++d) {
      count[d] = d == wall.axis ? 1 : std::lround(std::floor(extent_[d] / spacing_ + 1e-9)) + 1;
      nodes *= static_cast<std::size_t>(count[d]);
    }
    points.reserve(points.size() + nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
      std::size_t rest = n;
      std::array<double, Dim> point;
      for (int d = 0; d < Dim; ++d) {
        const auto along = static_cast<std::size_t>(count[d]);
        const double from_origin = spacing_ * static_cast<double>(rest % along);
        rest /= along;
        point[d] = d == wall.axis ? wall.position : std::abs(origin_[d] - from_origin);
      }
      points.push_back(point);
    }
  }
  return points;
}

template <int Dim>
std::uint64_t VirtualParticles<Dim>::count() const {
  std::uint64_t sum = 0;
  if (form_ == RepulsionForm::Even) return sum;
  for (const Wall& wall : walls_) {
    std::uint64_t nodes = 1;
    for (int d = 0; d < Dim; ++d) {
      if (d != wall.axis) nodes *= static_cast<std::uint64_t>(std::lround(extent_[d] / spacing_)) + 1;
    }
    sum += nodes;
  }
  return sum;
}

template class VirtualParticles<2>;
template class VirtualParticles<3>;

}  // namespace eisph
