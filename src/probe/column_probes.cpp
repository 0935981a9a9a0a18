#include "probe/column_probes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace eisph {

namespace {

double level(const ColumnField& columns, std::size_t cell) {
  const double depth = columns.depth[cell];
  return depth > 0.0 ? columns.bed[cell] + depth : 0.0;
}

std::optional<std::size_t> place(double coordinate, double origin, double cell_size, std::size_t count) {
  // A point on the upper edge, to rounding, belongs to the last cell.
  constexpr double kTolerance = 1e-6;
  const double cell = (coordinate - origin) / cell_size;
  if (!(cell >= -kTolerance && cell <= static_cast<double>(count) + kTolerance)) return std::nullopt;
  return std::min(static_cast<std::size_t>(std::max(cell, 0.0)), count - 1);
}

std::optional<std::size_t> cell_at(const ColumnField& columns, double x, double y) {
  const auto i = place(x, columns.origin_x, columns.cell_size, columns.columns);
  const auto j = columns.rows == 1 ? std::optional<std::size_t>(0)
                                   : place(y, columns.origin_y, columns.cell_size, columns.rows);
  if (!i || !j) return std::nullopt;
  return columns.index(*i, *j);
}

/// Part of a line of source cells that lies in a target cell.
struct Overlap {
  std::size_t source;
  double share;  ///< length in common, over that of the target cell
};

/// For every target cell along an axis the source cells in it.
std::vector<std::vector<Overlap>> overlaps(double target_origin, double target_size, std::size_t targets,
                                           double source_origin, double source_size, std::size_t sources) {
  std::vector<std::vector<Overlap>> result(targets);
  const double rounding = 1e-6 * std::min(target_size, source_size);
  for (std::size_t t = 0; t < targets; ++t) {
    const double lower = target_origin + static_cast<double>(t) * target_size;
    const double upper = lower + target_size;
    const double first = std::floor((lower - source_origin) / source_size);
    for (auto s = static_cast<std::size_t>(std::max(first, 0.0)); s < sources; ++s) {
      const double begin = source_origin + static_cast<double>(s) * source_size;
      if (begin >= upper) break;
      const double shared = std::min(upper, begin + source_size) - std::max(lower, begin);
      if (shared > rounding) result[t].push_back({s, shared / target_size});
    }
  }
  return result;
}

/// Part of the interval [lower, upper] of one axis that a band leaves, 0 to 1.
double share_in(const Band& band, int axis, double lower, double upper) {
  const auto& range = band.range[static_cast<std::size_t>(axis)];
  if (!range || !(upper > lower)) return 1.0;
  const double shared = std::min(upper, (*range)[1]) - std::max(lower, (*range)[0]);
  return std::max(shared, 0.0) / (upper - lower);
}

}  // namespace

double column_level(const ColumnField& columns, double x, double y) {
  const auto cell = cell_at(columns, x, y);
  return cell ? level(columns, *cell) : 0.0;
}

LeadingEdge column_front(const ColumnField& columns) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto farthest = [&](double least_depth) {
    for (std::size_t i = columns.columns; i-- > 0;) {
      for (std::size_t j = 0; j < columns.rows; ++j) {
        if (columns.depth[columns.index(i, j)] > least_depth) {
          return columns.origin_x + static_cast<double>(i + 1) * columns.cell_size;
        }
      }
    }
    return kNone;
  };
  return {farthest(kFrontDepth), farthest(kBulkFrontDepth)};
}

LeadingEdge column_front(const FrontProbe& probe, const ColumnField& columns, const Scene& scene) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  LeadingEdge edge{kNone, kNone};
  const auto farther = [&](double present, double other) {
    return probe.upwards ? std::fmax(present, other) : std::fmin(present, other);
  };
  for (std::size_t j = 0; j < columns.rows; ++j) {
    for (std::size_t i = 0; i < columns.columns; ++i) {
      const std::size_t cell = columns.index(i, j);
      const double depth = columns.depth[cell];
      if (!(depth > kFrontDepth)) continue;
      const Vec3d centre(columns.origin_x + (static_cast<double>(i) + 0.5) * columns.cell_size,
                         columns.origin_y + (static_cast<double>(j) + 0.5) * columns.cell_size,
                         scene.domain_min.z() + level(columns, cell));
      if (!probe.band.contains(centre)) continue;
      const double end = centre[probe.axis] + (probe.upwards ? 0.5 : -0.5) * columns.cell_size;
      edge.front = farther(edge.front, end);
      if (depth > kBulkFrontDepth) edge.bulk_front = farther(edge.bulk_front, end);
    }
  }
  return edge;
}

LedgerEntry column_ledger(const ColumnField& columns, const Scene& scene) {
  const double area = scene.dimension == 2 ? columns.cell_size : columns.cell_size * columns.cell_size;
  const double gravity = std::abs(scene.gravity.z());
  LedgerEntry entry;
  for (std::size_t cell = 0; cell < columns.size(); ++cell) {
    const double depth = columns.depth[cell];
    const Vec3d velocity(columns.velocity_x[cell], columns.velocity_y[cell], 0.0);
    const double mass = scene.density * area * depth;
    entry.mass += mass;
    entry.volume += area * depth;
    entry.kinetic_energy += 0.5 * mass * velocity.squaredNorm();
    entry.potential_energy += mass * gravity * (columns.bed[cell] + 0.5 * depth);
    entry.momentum += mass * velocity;
  }
  return entry;
}

std::size_t wet_columns(const ColumnField& columns) {
  return static_cast<std::size_t>(
      std::count_if(columns.depth.begin(), columns.depth.end(), [](float depth) { return depth > 0.0F; }));
}

PointSample sample_column(const Vec3d& point, const ColumnField& columns, const Scene& scene) {
  const auto cell = cell_at(columns, point.x(), point.y());
  if (!cell) return {};
  const double height = point.z() - scene.domain_min.z();
  const double surface = columns.bed[*cell] + columns.depth[*cell];
  if (!(columns.depth[*cell] > 0.0F) || height < columns.bed[*cell] || height > surface) return {};
  return {true, scene.density * std::abs(scene.gravity.z()) * (surface - height),
          Vec3d(columns.velocity_x[*cell], columns.velocity_y[*cell], 0.0)};
}

std::optional<double> column_wall_pressure(const Vec3d& point, const Vec3d& normal,
                                           const ColumnField& columns, const Scene& scene) {
  const double height = point.z() - scene.domain_min.z();
  const double tolerance = 1e-6 * columns.cell_size;
  for (const double cells : {0.5, 1.0, 1.5}) {
    const Vec3d in_front = point + cells * columns.cell_size * normal;
    const auto cell = cell_at(columns, in_front.x(), in_front.y());
    if (!cell || columns.bed[*cell] > height + tolerance) continue;
    const double above = columns.bed[*cell] + columns.depth[*cell] - height;
    if (!(columns.depth[*cell] > 0.0F) || above < 0.0) return std::nullopt;
    return scene.density * std::abs(scene.gravity.z()) * above;
  }
  return std::nullopt;
}

double column_discharge(const DischargeProbe& probe, const ColumnField& columns, const Scene& scene) {
  if (probe.axis == 2) return 0.0;
  const bool along_x = probe.axis == 0;
  const double size = columns.cell_size;
  const double origin = along_x ? columns.origin_x : columns.origin_y;
  const std::size_t count = along_x ? columns.columns : columns.rows;
  const std::size_t across = along_x ? columns.rows : columns.columns;
  const double place =
      std::clamp((probe.position - origin) / size - 0.5, 0.0, static_cast<double>(count - 1));
  const auto before = static_cast<std::size_t>(place);
  const std::size_t behind = std::min(before + 1, count - 1);
  const double weight = place - static_cast<double>(before);
  const std::vector<float>& velocity = along_x ? columns.velocity_x : columns.velocity_y;
  double sum = 0.0;
  for (std::size_t k = 0; k < across; ++k) {
    const auto passing = [&](std::size_t n) {
      const std::size_t cell = along_x ? columns.index(n, k) : columns.index(k, n);
      const double foot = scene.domain_min.z() + columns.bed[cell];
      const double depth = columns.depth[cell];
      return depth * velocity[cell] * share_in(probe.band, 2, foot, foot + depth);
    };
    const double lower = (along_x ? columns.origin_y : columns.origin_x) + static_cast<double>(k) * size;
    const double width =
        scene.dimension == 2 ? 1.0 : size * share_in(probe.band, along_x ? 1 : 0, lower, lower + size);
    sum += width * ((1.0 - weight) * passing(before) + weight * passing(behind));
  }
  return sum;
}

void resample_levels(const ColumnField& columns, DepthGrid& grid) {
  const auto along_x = overlaps(grid.origin_x, grid.cell_size, grid.columns, columns.origin_x,
                                columns.cell_size, columns.columns);
  std::vector<std::vector<Overlap>> along_y{{{0, 1.0}}};
  if (grid.rows > 1 || columns.rows > 1) {
    along_y =
        overlaps(grid.origin_y, grid.cell_size, grid.rows, columns.origin_y, columns.cell_size, columns.rows);
  }
  for (std::size_t j = 0; j < grid.rows; ++j) {
    for (std::size_t i = 0; i < grid.columns; ++i) {
      double sum = 0.0;
      double weights = 0.0;
      for (const Overlap& y : along_y[j]) {
        for (const Overlap& x : along_x[i]) {
          const std::size_t cell = columns.index(x.source, y.source);
          if (columns.bed[cell] > 0.0F && !(columns.depth[cell] > 0.0F)) continue;
          sum += x.share * y.share * level(columns, cell);
          weights += x.share * y.share;
        }
      }
      grid.depth[j * grid.columns + i] = weights > 0.0 ? static_cast<float>(sum / weights) : 0.0F;
    }
  }
}

}  // namespace eisph
