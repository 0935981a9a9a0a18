#include "app/pairing.hpp"

#include <fmt/format.h>

namespace eisph {

namespace {

struct PairingLimit {
  const char* kernel;  ///< as in a sentence
  double largest;      ///< h / dx up to which particles stay apart
};

/// Largest part of the particles within 0.6 dx of another, in %, 2D / 3D:
///
///   h / dx        1.1    1.2     1.32     1.5      1.7
///   cubic spline  1 / 4  7 / 19  85 / 62  94 / -
///   Wendland C2          0 / 1   2 / 2    14 / 14  23 / 22
PairingLimit pairing_limit(KernelKind kernel) {
  switch (kernel) {
    case KernelKind::CubicSpline:
      return {"cubic spline", 1.15};
    case KernelKind::WendlandC2:
      return {"Wendland C2 kernel", 1.4};
    case KernelKind::QuinticSpline:
      break;
  }
  return {"quintic spline", 1.5};
}

}  // namespace

std::optional<std::string> pairing_warning(KernelKind kernel, double smoothing_ratio, int dimension) {
  const PairingLimit limit = pairing_limit(kernel);
  if (smoothing_ratio <= limit.largest * (1.0 + 1e-9)) return std::nullopt;
  return fmt::format(
      "particles.smoothing_ratio = {:g}: with the {} particles pair above {:g} in {}D, so that two stand for "
      "one; run.json tells how many (paired_fraction_max)",
      smoothing_ratio, limit.kernel, limit.largest, dimension);
}

}  // namespace eisph
