#pragma once

#include "core/column_field.hpp"
#include "core/depth_grid.hpp"
#include "core/scene.hpp"
#include "core/snapshot.hpp"
#include "probe/leading_edge.hpp"
#include "probe/ledger.hpp"
#include "probe/point_probe.hpp"

#include <cstddef>
#include <optional>

namespace eisph {

// What the probes read of a depth-averaged model, Snapshot::columns. Levels are those of the free surface,
// bed + depth, in metres above the floor, and zero where it is dry: the same as the height of the highest
// particle, without the half spacing by which that falls short.

/// Columns shallower than these (m) are no part of LeadingEdge::front and of bulk_front.
inline constexpr double kFrontDepth = 1e-4;
inline constexpr double kBulkFrontDepth = 1e-3;

/// Level in the cell of a point; zero outside the cells.
[[nodiscard]] double column_level(const ColumnField& columns, double x, double y);

/// Upper ends along x of the farthest columns deeper than kFrontDepth and kBulkFrontDepth.
[[nodiscard]] LeadingEdge column_front(const ColumnField& columns);

/// The same in the direction of a probe and among the columns whose centre (at the surface) lies in its band.
[[nodiscard]] LeadingEdge column_front(const FrontProbe& probe, const ColumnField& columns,
                                       const Scene& scene);

/// Sums over the columns, in two dimensions per metre of width; the water is incompressible.
[[nodiscard]] LedgerEntry column_ledger(const ColumnField& columns, const Scene& scene);

/// How many columns hold water.
[[nodiscard]] std::size_t wet_columns(const ColumnField& columns);

/// Velocity of the column at the point and hydrostatic pressure; wet between bed and surface, ends included.
[[nodiscard]] PointSample sample_column(const Vec3d& point, const ColumnField& columns, const Scene& scene);

/// Hydrostatic pressure (Pa) on a wall at `point`, `normal` being a unit vector into the water: that of the
/// first column in front of it, at most one and a half cells away, whose bed is not above the point. Nothing
/// where that one ends below the point, or if there is none. What a stream presses beyond the weight of the
/// water it piles up is not in it.
[[nodiscard]] std::optional<double> column_wall_pressure(const Vec3d& point, const Vec3d& normal,
                                                         const ColumnField& columns, const Scene& scene);

/// Volume of water through a plane, m^3/s (m^2/s in two dimensions), positive along its axis, linear between
/// the columns at both sides. Edges of the band cut columns, also in height. Nothing passes a level plane.
[[nodiscard]] double column_discharge(const DischargeProbe& probe, const ColumnField& columns,
                                      const Scene& scene);

/// Replaces the depths of `grid` by the mean levels over its cells, weighted with the areas that cells of the
/// two grids share. Columns on dry solids are left out, and so is what of a cell lies outside the columns;
/// elsewhere over a bare floor the volume of the water stays exactly the same.
void resample_levels(const ColumnField& columns, DepthGrid& grid);

}  // namespace eisph
