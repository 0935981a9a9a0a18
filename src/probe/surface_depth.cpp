#include "probe/surface_depth.hpp"

#include "probe/kernel.hpp"
#include "probe/surface_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace eisph {

namespace {

constexpr double kGone = -std::numeric_limits<double>::infinity();  ///< top of a gate that is gone
constexpr double kLeastSpace = 1e-3;

/// Calls visit(cell, weight) for the cells of one axis whose centres a coordinate reaches: weights of B, 1/m.
template <class Visit>
void visit_reached(double offset, double dx, double cell_size, std::size_t cells, const Visit& visit) {
  const double first = std::max(std::ceil((offset - 2.0 * dx) / cell_size - 0.5), 0.0);
  const double last = std::floor((offset + 2.0 * dx) / cell_size - 0.5);
  if (last < first) return;
  const std::size_t end = std::min(static_cast<std::size_t>(last) + 1, cells);
  for (auto cell = static_cast<std::size_t>(first); cell < end; ++cell) {
    const double weight = axis_spline(((static_cast<double>(cell) + 0.5) * cell_size - offset) / dx) / dx;
    visit(cell, weight);
  }
}

/// The same with the mirror images at both ends of the axis.
template <class Visit>
void visit_axis(double offset, double length, double dx, double cell_size, std::size_t cells,
                const Visit& visit) {
  const double reach = 2.0 * dx;
  visit_reached(offset, dx, cell_size, cells, visit);
  if (offset < reach) visit_reached(-offset, dx, cell_size, cells, visit);
  if (length - offset < reach + cell_size) visit_reached(2.0 * length - offset, dx, cell_size, cells, visit);
}

/// A shape seen from above, in pieces; a sphere as the disc of its radius.
std::vector<SurfaceElement> plan_elements(const Shape& shape, double spacing, int dimension) {
  if (shape.kind == ShapeKind::Sphere) {
    return disc_elements(shape.centre, Vec3d::UnitZ(), 2.0 * shape.radius, spacing, dimension);
  }
  std::vector<SurfaceElement> elements = surface_elements(shape, spacing, dimension);
  std::erase_if(elements, [](const SurfaceElement& element) { return element.normal.z() < 0.5; });
  return elements;
}

/// A part of the height that solids fill to some degree.
struct Filled {
  double bottom = 0.0;
  double top = 0.0;
  double share = 0.0;
};

/// Level up to which `volume` (m^3 per m^2) stands between solids.
double level_of(double volume, const std::vector<Filled>& solids) {
  if (volume <= 0.0) return 0.0;
  std::vector<double> heights;
  for (const Filled& solid : solids) {
    heights.push_back(std::max(solid.bottom, 0.0));
    heights.push_back(std::max(solid.top, 0.0));
  }
  std::sort(heights.begin(), heights.end());
  double level = 0.0;
  for (const double next : heights) {
    const double middle = 0.5 * (level + next);
    double space = 1.0;
    for (const Filled& solid : solids) {
      if (solid.bottom <= middle && middle < solid.top) space -= solid.share;
    }
    space = std::max(space, kLeastSpace);
    if (volume <= space * (next - level)) return level + volume / space;
    volume -= space * (next - level);
    level = next;
  }
  return level + volume;
}

}  // namespace

SurfaceDepth::SurfaceDepth(const Scene& scene, const DepthGrid& grid)
    : dimension_(scene.dimension),
      dx_(scene.particle_spacing),
      lower_(scene.domain_min),
      upper_(scene.domain_max),
      gates_(scene.gates) {
  for (const Obstacle& obstacle : scene.obstacles) add_solid(obstacle.shape, kNoGate, grid);
  for (std::size_t g = 0; g < gates_.size(); ++g) add_solid(gates_[g].shape, g, grid);
  std::stable_sort(shares_.begin(), shares_.end(),
                   [](const Share& one, const Share& other) { return one.cell < other.cell; });
}

void SurfaceDepth::add_solid(const Shape& shape, std::size_t gate, const DepthGrid& grid) {
  Vec3d lower;
  Vec3d upper;
  shape.bounds(lower, upper);
  const double bottom = lower.z() - lower_.z();
  const double top = upper.z() - lower_.z();
  if (shape.kind != ShapeKind::Sphere) {
    add_prism(shape, {bottom, top, bottom, gate}, grid);
    return;
  }
  const int slices = std::max(2, static_cast<int>(std::ceil((top - bottom) / dx_)));
  for (int slice = 0; slice < slices; ++slice) {
    const double low = bottom + (top - bottom) * slice / slices;
    const double high = bottom + (top - bottom) * (slice + 1) / slices;
    const double from_middle = 0.5 * (low + high) - 0.5 * (bottom + top);
    Shape disc = shape;
    disc.radius = std::sqrt(shape.radius * shape.radius - from_middle * from_middle);
    add_prism(disc, {low, high, bottom, gate}, grid);
  }
}

/// Spreads the outline of a prism over the cells as though it were particles. Its own z does not count.
void SurfaceDepth::add_prism(const Shape& outline, const Prism& prism, const DepthGrid& grid) {
  const auto number = static_cast<std::uint32_t>(prisms_.size());
  prisms_.push_back(prism);
  std::vector<double> share(grid.depth.size(), 0.0);
  for (const SurfaceElement& part : plan_elements(outline, dx_, dimension_)) {
    // Only what is inside the domain: the mirror images stand for the rest.
    const Vec3d& point = part.point;
    if (point.x() < lower_.x() || point.x() > upper_.x()) continue;
    if (dimension_ == 3 && (point.y() < lower_.y() || point.y() > upper_.y())) continue;
    visit_cells(point.x(), point.y(), grid,
                [&](std::size_t cell, double weight) { share[cell] += weight * part.area; });
  }
  Vec3d middle = outline.centre;
  if (outline.kind == ShapeKind::Box) middle = 0.5 * (outline.min + outline.max);
  if (outline.kind == ShapeKind::Cylinder) middle.z() += 0.5 * outline.height;
  for (std::size_t cell = 0; cell < share.size(); ++cell) {
    if (share[cell] <= 0.0) continue;
    const std::size_t row = cell / grid.columns;
    const std::size_t column = cell % grid.columns;
    const Vec3d point(grid.origin_x + (static_cast<double>(column) + 0.5) * grid.cell_size,
                      grid.origin_y + (static_cast<double>(row) + 0.5) * grid.cell_size, middle.z());
    shares_.push_back({static_cast<std::uint32_t>(cell), number, std::min(share[cell], 1.0),
                       outline.contains(point, dimension_)});
  }
}

/// Calls visit(cell, weight) for every cell that (x, y) and its mirror images reach.
template <class Visit>
void SurfaceDepth::visit_cells(double x, double y, const DepthGrid& grid, const Visit& visit) const {
  const auto along_x = [&](std::size_t row, double row_weight) {
    visit_axis(
        x - lower_.x(), upper_.x() - lower_.x(), dx_, grid.cell_size, grid.columns,
        [&](std::size_t column, double weight) { visit(row * grid.columns + column, row_weight * weight); });
  };
  if (dimension_ == 2) {
    along_x(0, 1.0);
  } else {
    visit_axis(y - lower_.y(), upper_.y() - lower_.y(), dx_, grid.cell_size, grid.rows, along_x);
  }
}

std::vector<SurfaceDepth::Prism> SurfaceDepth::standing_prisms(double time) const {
  std::vector<Prism> prisms = prisms_;
  for (Prism& prism : prisms) {
    if (prism.gate == kNoGate) continue;
    const std::optional<double> lift = gates_[prism.gate].lift(time);
    prism.bottom += lift.value_or(0.0);
    prism.foot += lift.value_or(0.0);
    prism.top = lift ? prism.top + *lift : kGone;
  }
  return prisms;
}

/// Turns volumes into levels where solids are near.
void SurfaceDepth::fill_around_solids(const std::vector<Prism>& prisms, const std::vector<double>& ground,
                                      std::vector<double>& volume) const {
  std::vector<Filled> solids;
  for (std::size_t s = 0; s < shares_.size();) {
    const std::uint32_t cell = shares_[s].cell;
    solids.clear();
    for (; s < shares_.size() && shares_[s].cell == cell; ++s) {
      const Prism& prism = prisms[shares_[s].prism];
      // What is below the ground of a covered cell is not there for its water.
      const double bottom = std::max(prism.bottom, ground[cell]);
      if (prism.top > bottom)
        solids.push_back({bottom - ground[cell], prism.top - ground[cell], shares_[s].share});
    }
    const double level = level_of(volume[cell], solids);
    volume[cell] = level > 0.0 ? ground[cell] + level : 0.0;
  }
}

void SurfaceDepth::fill(const Snapshot& snapshot, DepthGrid& grid) const {
  std::vector<double> volume(grid.depth.size(), 0.0);
  const std::vector<Prism> prisms = standing_prisms(snapshot.time);
  // Height of the solid under the centre of a cell, unless there is room for water below that.
  std::vector<double> ground(shares_.empty() ? 0 : grid.depth.size(), 0.0);
  for (const Share& share : shares_) {
    const Prism& prism = prisms[share.prism];
    if (share.covered && prism.foot <= dx_) ground[share.cell] = std::max(ground[share.cell], prism.top);
  }
  const double slack = 1e-3 * dx_;  // single precision may put a particle on a wall a little beyond it
  const double particle = snapshot.particle_mass / snapshot.reference_density;
  for (const Vec3f& position : snapshot.position) {
    const Vec3d offset = position.cast<double>() - lower_;
    if (!(offset.z() >= -slack) || !(offset.x() >= -slack) || !(position.x() <= upper_.x() + slack)) continue;
    if (dimension_ == 3 && (!(offset.y() >= -slack) || !(position.y() <= upper_.y() + slack))) continue;
    if (ground.empty()) {
      visit_cells(position.x(), position.y(), grid,
                  [&](std::size_t cell, double weight) { volume[cell] += particle * weight; });
    } else {
      visit_cells(position.x(), position.y(), grid, [&](std::size_t cell, double weight) {
        if (offset.z() >= ground[cell] - slack) volume[cell] += particle * weight;
      });
    }
  }
  if (!shares_.empty()) fill_around_solids(prisms, ground, volume);
  std::transform(volume.begin(), volume.end(), grid.depth.begin(),
                 [](double level) { return static_cast<float>(level); });
}

}  // namespace eisph
