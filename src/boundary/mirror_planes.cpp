#include "boundary/mirror_planes.hpp"

namespace eisph {

namespace {

/// Factor of the tangential velocity of an image behind the face.
float tangential_factor(const Face& face) {
  return face.kind == FaceKind::Symmetry ? 1.0F : static_cast<float>(2.0 * face.slip_factor - 1.0);
}

}  // namespace

template <int Dim>
MirrorPlanes<Dim>::MirrorPlanes(const Scene& scene) {
  for (int d = 0; d < Dim; ++d) {
    const int axis = scene_axis<Dim>(d);
    const auto length =
        static_cast<float>((scene.domain_max[axis] - scene.domain_min[axis]) / scene.smoothing_length());
    extent_[d] = length;
    const auto mirrors = [&](const Face& face) {
      return face.kind == FaceKind::Symmetry ||
             (face.kind == FaceKind::Wall && scene.boundary.ghost_particles);
    };
    const Face& lower = scene.faces[2 * axis];
    const Face& upper = scene.faces[2 * axis + 1];
    std::vector<AxisImage>& images = axis_images_[d];
    const bool low = lower.kind == FaceKind::Symmetry;
    const bool high = upper.kind == FaceKind::Symmetry;
    if (mirrors(lower)) images.push_back({1, -1.0F, 0.0F, -1.0F, tangential_factor(lower), low});
    if (mirrors(upper)) images.push_back({2, -1.0F, 2.0F * length, -1.0F, tangential_factor(upper), high});
    if (mirrors(lower) && mirrors(upper) && length < kReach) {
      const float both = tangential_factor(lower) * tangential_factor(upper);
      images.push_back({3, 1.0F, -2.0F * length, 1.0F, both, low && high});
      images.push_back({4, 1.0F, 2.0F * length, 1.0F, both, low && high});
    }
  }
  for (int key = 1; key < kKeys; ++key) {
    Image image;
    image.scale.fill(1.0F);
    image.shift.fill(0.0F);
    image.velocity.fill(1.0F);
    image.symmetry = true;
    bool exists = true;
    int rest = key;
    for (int d = Dim - 1; d >= 0; --d) {
      const int order = rest % kOrders;
      rest /= kOrders;
      if (order == 0) continue;
      const AxisImage* found = nullptr;
      for (const AxisImage& candidate : axis_images_[d]) {
        if (candidate.order == order) found = &candidate;
      }
      if (found == nullptr) {
        exists = false;
        break;
      }
      image.scale[d] = found->scale;
      image.shift[d] = found->shift;
      image.symmetry = image.symmetry && found->symmetry;
      for (int c = 0; c < Dim; ++c) image.velocity[c] *= c == d ? found->normal : found->tangential;
    }
    if (!exists) continue;
    code_[key] = static_cast<std::uint8_t>(images_.size());
    images_.push_back(image);
    any_symmetry_ = any_symmetry_ || image.symmetry;
  }
}

template class MirrorPlanes<2>;
template class MirrorPlanes<3>;

}  // namespace eisph
