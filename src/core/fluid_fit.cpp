#include "core/fluid_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eisph {

namespace {

/// Lengths, over the particle spacing.
constexpr double kTolerance = 1e-6;
/// Pieces thinner than this hold no particles, in spacings.
constexpr double kThinnest = 0.5;
/// Weights of the squared logarithms of: the volume of a cell over that of all cells, its edges over their
/// mean, the volume of all cells over dx^D. A difference in volume is a compression at t = 0, a stretched
/// cell hardly a fault: the kernel does not see the lattice.
constexpr double kVolumeWeight = 100.0;
constexpr double kStretchWeight = 1.0;
constexpr double kSpacingWeight = 1.0;
/// A piece that is too thin to hold a layer costs this much.
constexpr double kThinCost = 10.0;

bool is_upright_box(const Shape& shape) { return shape.kind == ShapeKind::Box && shape.rotation_z == 0.0; }

struct Box {
  Vec3d lower;
  Vec3d upper;
  bool cut;
  std::size_t region;
};

bool has_axis(const Scene& scene, int axis) { return scene.dimension == 3 || axis != 1; }

/// The upright boxes, within the domain.
std::vector<Box> boxes_in_domain(const Scene& scene) {
  std::vector<Box> boxes;
  for (std::size_t r = 0; r < scene.fluid.size(); ++r) {
    const FluidRegion& region = scene.fluid[r];
    if (!is_upright_box(region.shape)) continue;
    boxes.push_back({region.shape.min.cwiseMax(scene.domain_min), region.shape.max.cwiseMin(scene.domain_max),
                     region.cut, r});
    if (scene.dimension == 2) boxes.back().lower.y() = boxes.back().upper.y() = 0.0;
  }
  return boxes;
}

bool on_lattice(const Scene& scene, int axis, double coordinate) {
  const double index = (coordinate - scene.domain_min[axis]) / scene.particle_spacing;
  return std::abs(index - std::round(index)) <= kTolerance;
}

bool all_on_lattice(const Scene& scene, const std::vector<Box>& boxes) {
  return std::all_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!has_axis(scene, axis)) continue;
      if (!on_lattice(scene, axis, box.lower[axis]) || !on_lattice(scene, axis, box.upper[axis]))
        return false;
    }
    return true;
  });
}

/// The blocks between all faces of the boxes.
class Blocks {
 public:
  Blocks(const Scene& scene, const std::vector<Box>& boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double>& at = edges_[static_cast<std::size_t>(axis)];
      if (!has_axis(scene, axis)) {
        at = {0.0, 0.0};
        continue;
      }
      for (const Box& box : boxes) {
        at.push_back(box.lower[axis]);
        at.push_back(box.upper[axis]);
      }
      std::sort(at.begin(), at.end());
      const double same = kTolerance * scene.particle_spacing;
      at.erase(std::unique(at.begin(), at.end(), [&](double a, double b) { return b - a <= same; }),
               at.end());
    }
    owner_.resize(count(0) * count(1) * count(2), kDry);
    for (std::size_t block = 0; block < owner_.size(); ++block) {
      const Index at = index(block);
      Vec3d middle;
      for (std::size_t a = 0; a < 3; ++a) {
        middle[static_cast<int>(a)] = 0.5 * (edges_[a][at[a]] + edges_[a][at[a] + 1]);
      }
      owner_[block] = owner(boxes, middle);
    }
  }

  /// The water in boxes, each grown from its lowest corner along order[0] first, then along the others.
  [[nodiscard]] std::vector<FluidPiece> pieces(const std::array<std::size_t, 3>& order) const {
    std::vector<FluidPiece> found;
    std::vector<bool> taken(owner_.size(), false);
    const auto is_free = [&](std::size_t block) { return owner_[block] != kDry && !taken[block]; };
    for (std::size_t block = 0; block < owner_.size(); ++block) {
      if (!is_free(block)) continue;
      const Index first = index(block);
      Index last = first;
      for (const std::size_t a : order) {
        while (last[a] + 1 < count(a)) {
          Index from = first;
          Index to = last;
          from[a] = to[a] = last[a] + 1;
          if (!all(from, to, is_free)) break;
          ++last[a];
        }
      }
      FluidPiece piece;
      for (std::size_t a = 0; a < 3; ++a) {
        piece.lower[static_cast<int>(a)] = edges_[a][first[a]];
        piece.upper[static_cast<int>(a)] = edges_[a][last[a] + 1];
      }
      all(first, last, [&](std::size_t part) {
        taken[part] = true;
        piece.region = std::max(piece.region, owner_[part]);
        return true;
      });
      found.push_back(piece);
    }
    return found;
  }

 private:
  using Index = std::array<std::size_t, 3>;
  static constexpr std::size_t kDry = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] std::size_t count(std::size_t axis) const {
    return edges_[axis].empty() ? 0 : edges_[axis].size() - 1;
  }
  [[nodiscard]] Index index(std::size_t block) const {
    const std::size_t columns = std::max<std::size_t>(count(0), 1);
    const std::size_t rows = std::max<std::size_t>(count(1), 1);
    return {block % columns, block / columns % rows, block / (columns * rows)};
  }
  static std::size_t owner(const std::vector<Box>& boxes, const Vec3d& point) {
    std::size_t last = kDry;
    for (const Box& box : boxes) {
      if ((point.array() < box.lower.array()).any() || (point.array() > box.upper.array()).any()) continue;
      if (box.cut) return kDry;
      last = box.region;
    }
    return last;
  }
  /// Whether `test` holds for all blocks from `first` to `last`.
  template <class Test>
  bool all(const Index& first, const Index& last, const Test& test) const {
    for (std::size_t k = first[2]; k <= last[2]; ++k) {
      for (std::size_t j = first[1]; j <= last[1]; ++j) {
        for (std::size_t i = first[0]; i <= last[0]; ++i) {
          if (!test((k * count(1) + j) * count(0) + i)) return false;
        }
      }
    }
    return true;
  }

  std::array<std::vector<double>, 3> edges_;
  std::vector<std::size_t> owner_;  ///< region of every block
};

/// Chooses the layers of pieces.
class LayerChoice {
 public:
  LayerChoice(const Scene& scene) : spacing_(scene.particle_spacing) {
    for (int axis = 0; axis < 3; ++axis) {
      if (has_axis(scene, axis)) axes_.push_back(static_cast<std::size_t>(axis));
    }
  }

  [[nodiscard]] bool is_thin(const FluidPiece& piece) const {
    return std::any_of(axes_.begin(), axes_.end(),
                       [&](std::size_t a) { return length(piece, a) < kThinnest * (1.0 - kTolerance); });
  }
  /// Volume over dx^D.
  [[nodiscard]] double volume(const FluidPiece& piece) const {
    double product = 1.0;
    for (const std::size_t a : axes_) product *= length(piece, a);
    return product;
  }
  [[nodiscard]] double cell_volume(const FluidPiece& piece) const {
    double product = 1.0;
    for (const std::size_t a : axes_) product *= length(piece, a) / piece.layers[a];
    return product;
  }

  /// Gives all pieces the layers that cost least; returns the cost.
  double choose(std::vector<FluidPiece>& pieces) const {
    double total = 0.0;
    for (const FluidPiece& piece : pieces) total += std::sqrt(volume(piece));
    double best = std::numeric_limits<double>::infinity();
    std::vector<FluidPiece> trial = pieces;
    for (int k = -kTargets; k <= kTargets; ++k) {
      const double target = kTargetStep * k;
      double cost = kSpacingWeight * target * target;
      for (FluidPiece& piece : trial) {
        cost += std::sqrt(volume(piece)) / total * choose(piece, std::exp(target));
        if (cost >= best) break;
      }
      if (cost >= best) continue;
      best = cost;
      pieces = trial;
    }
    return best;
  }

 private:
  static constexpr int kTargets = 100;
  static constexpr double kTargetStep = 0.002;

  /// In spacings.
  [[nodiscard]] double length(const FluidPiece& piece, std::size_t axis) const {
    return (piece.upper[static_cast<int>(axis)] - piece.lower[static_cast<int>(axis)]) / spacing_;
  }

  [[nodiscard]] double cost(const FluidPiece& piece, double target) const {
    const double volume = std::log(cell_volume(piece) / target);
    const double mean = std::log(cell_volume(piece)) / static_cast<double>(axes_.size());
    double stretch = 0.0;
    for (const std::size_t a : axes_) {
      const double edge = std::log(length(piece, a) / piece.layers[a]) - mean;
      stretch += edge * edge;
    }
    return kVolumeWeight * volume * volume + kStretchWeight * stretch;
  }

  /// The next whole numbers about the length of every axis; along the longest also what gives cells of the
  /// volume `target` (over dx^D).
  double choose(FluidPiece& piece, double target) const {
    const std::size_t longest =
        *std::max_element(axes_.begin(), axes_.end(),
                          [&](std::size_t a, std::size_t b) { return length(piece, a) < length(piece, b); });
    double best = std::numeric_limits<double>::infinity();
    FluidPiece trial = piece;
    const auto layers = [](double wanted, int offset) {
      return std::max(1.0, std::round(wanted) + static_cast<double>(offset));
    };
    int combinations = 1;
    for (std::size_t a = 0; a < axes_.size(); ++a) combinations *= 3;
    for (int c = 0; c < combinations; ++c) {
      double others = 1.0;
      int rest = c;
      for (const std::size_t a : axes_) {
        if (a == longest) continue;
        trial.layers[a] = layers(length(piece, a), rest % 3 - 1);
        others *= length(piece, a) / trial.layers[a];
        rest /= 3;
      }
      trial.layers[longest] = layers(length(piece, longest) * others / target, rest % 3 - 1);
      const double value = cost(trial, target);
      if (value >= best) continue;
      best = value;
      piece.layers = trial.layers;
    }
    return best;
  }

  double spacing_;
  std::vector<std::size_t> axes_;
};

/// Divides the water in each order of the axes and keeps the best division.
void find_pieces(const Scene& scene, const std::vector<Box>& boxes, FluidFit& fit) {
  const Blocks blocks(scene, boxes);
  const LayerChoice choice(scene);
  std::array<std::size_t, 3> order{0, 1, 2};
  double best = std::numeric_limits<double>::infinity();
  do {
    std::vector<FluidPiece> pieces = blocks.pieces(order);
    std::vector<FluidPiece> thin;
    const auto end = std::stable_partition(pieces.begin(), pieces.end(),
                                           [&](const FluidPiece& piece) { return !choice.is_thin(piece); });
    thin.assign(end, pieces.end());
    pieces.erase(end, pieces.end());
    const double cost =
        (pieces.empty() ? 0.0 : choice.choose(pieces)) + kThinCost * static_cast<double>(thin.size());
    if (cost >= best) continue;
    best = cost;
    fit.pieces = std::move(pieces);
    fit.thin = std::move(thin);
  } while (std::next_permutation(order.begin(), order.end()));

  double volume = 0.0;
  double cells = 0.0;
  for (const FluidPiece& piece : fit.pieces) {
    volume += choice.volume(piece);
    cells += choice.volume(piece) / choice.cell_volume(piece);
  }
  if (fit.pieces.empty()) return;
  for (const FluidPiece& piece : fit.pieces) {
    fit.misfit = std::max(fit.misfit, std::abs(choice.cell_volume(piece) * cells / volume - 1.0));
  }
  fit.cell_volume = volume / cells * std::pow(scene.particle_spacing, scene.dimension);
}

}  // namespace

int thin_axis(const Scene& scene, const FluidPiece& piece) {
  int thinnest = -1;
  double least = scene.particle_spacing * (1.0 - kTolerance);
  for (int axis = 0; axis < 3; ++axis) {
    if (!has_axis(scene, axis) || piece.upper[axis] - piece.lower[axis] >= least) continue;
    least = piece.upper[axis] - piece.lower[axis];
    thinnest = axis;
  }
  return thinnest;
}

double piece_volume(const Scene& scene, const FluidPiece& piece) {
  const Vec3d size = piece.upper - piece.lower;
  return scene.dimension == 2 ? size.x() * size.z() : size.prod();
}

FluidFit fit_fluid(const Scene& scene) {
  FluidFit fit;
  fit.cell_volume = std::pow(scene.particle_spacing, scene.dimension);
  for (std::size_t r = 0; r < scene.fluid.size(); ++r) {
    if (is_upright_box(scene.fluid[r].shape)) continue;
    (scene.fluid[r].cut ? fit.loose_cuts : fit.loose).push_back(r);
  }
  const std::vector<Box> boxes = boxes_in_domain(scene);
  fit.aligned = fit.loose.empty() && fit.loose_cuts.empty() && all_on_lattice(scene, boxes);
  if (!fit.aligned && !boxes.empty()) find_pieces(scene, boxes, fit);
  return fit;
}

}  // namespace eisph
