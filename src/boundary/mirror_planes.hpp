#pragma once

#include "core/pack.hpp"
#include "core/scene.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace eisph {

/// Axis of a 2D or 3D solver in the scene's x, y, z: 2D uses x and z.
template <int Dim>
constexpr int scene_axis(int axis) {
  return Dim == 2 && axis == 1 ? 2 : axis;
}

/// The mirror images that the faces of the domain make of a particle (thesis section 3.3.2, ghost particles).
/// One plane reflects; where two or three meet, the images of images fill the edge and the corner, so that
/// the field continues evenly across all of them. Two parallel planes closer than a support radius also make
/// images of the second order. The velocity of an image is that of the particle with the component normal to
/// each plane negated and the tangential ones multiplied by 2 slip_factor - 1: 1 for free slip and symmetry,
/// -1 for no slip.
template <int Dim>
class MirrorPlanes {
 public:
  /// How an image follows from its particle. Positions in smoothing lengths from the domain's lower corner.
  struct Image {
    std::array<float, Dim> scale;  ///< xi' = scale xi + shift
    std::array<float, Dim> shift;
    std::array<float, Dim> velocity;  ///< u' = velocity u, by component
    bool symmetry;                    ///< across planes of symmetry alone
  };

  MirrorPlanes() = default;
  explicit MirrorPlanes(const Scene& scene);

  [[nodiscard]] bool empty() const { return images_.empty(); }
  [[nodiscard]] const Image& image(std::uint8_t code) const { return images_[code]; }

  [[nodiscard]] bool is_symmetry(std::uint8_t code) const { return images_[code].symmetry; }
  /// Whether any image is one across planes of symmetry alone.
  [[nodiscard]] bool any_symmetry() const { return any_symmetry_; }

  /// Calls body(code) for every image of a particle at xi that lies within a support radius of the domain.
  template <class Body>
  void for_images(const Float4& xi, const Body& body) const {
    const float at[3] = {xi.x, xi.y, xi.z};
    // Images of one axis that are near enough; entry 0 stands for the particle itself.
    std::array<std::array<std::uint8_t, kOrders>, Dim> near{};
    std::array<int, Dim> count{};
    int product = 1;
    for (int d = 0; d < Dim; ++d) {
      count[d] = 1;
      for (const AxisImage& axis_image : axis_images_[d]) {
        const float mirrored = axis_image.scale * at[d] + axis_image.shift;
        if (mirrored >= -kReach && mirrored <= extent_[d] + kReach) near[d][count[d]++] = axis_image.order;
      }
      product *= count[d];
    }
    if (product == 1) return;
    for (int combination = 1; combination < product; ++combination) {
      int rest = combination;
      int key = 0;
      for (int d = 0; d < Dim; ++d) {
        key = key * kOrders + near[d][rest % count[d]];
        rest /= count[d];
      }
      body(code_[key]);
    }
  }

 private:
  static constexpr int kOrders = 5;                ///< none, two of the first order, two of the second
  static constexpr float kReach = kKernelSupport;  ///< support radius in smoothing lengths
  static constexpr int kKeys = Dim == 2 ? kOrders * kOrders : kOrders * kOrders * kOrders;

  struct AxisImage {
    std::uint8_t order;
    float scale;
    float shift;
    float normal;      ///< factor of the velocity along the axis
    float tangential;  ///< and across it
    bool symmetry;
  };

  std::array<float, Dim> extent_{};
  std::array<std::vector<AxisImage>, Dim> axis_images_;
  std::array<std::uint8_t, kKeys> code_{};
  std::vector<Image> images_;
  bool any_symmetry_ = false;
};

}  // namespace eisph
