#include "probe/column_probes.hpp"

#include "probe/depth_grid.hpp"
#include "probe/gauge.hpp"
#include "probe/hand_made.hpp"
#include "probe/probe_set.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Five by two columns of 0.1 m from (1, 2) on: a block of 0.2 m in column 1 of both rows, dry in the first
/// and below water in the second.
ColumnField columns_with_a_block() {
  ColumnField columns;
  columns.origin_x = 1.0;
  columns.origin_y = 2.0;
  columns.cell_size = 0.1;
  columns.columns = 5;
  columns.rows = 2;
  columns.bed = {0.0F, 0.2F, 0.0F, 0.0F, 0.0F, 0.0F, 0.2F, 0.0F, 0.0F, 0.0F};
  columns.depth = {0.1F, 0.0F, 0.3F, 5e-4F, 5e-5F, 0.4F, 0.1F, 0.2F, 0.0F, 0.0F};
  columns.velocity_x = {1.0F, 0.0F, -1.0F, 0.0F, 0.0F, 2.0F, 0.5F, 0.0F, 0.0F, 0.0F};
  columns.velocity_y = {0.0F, 0.0F, 2.0F, 0.0F, 0.0F, 0.0F, 0.0F, -1.0F, 0.0F, 0.0F};
  return columns;
}

/// Its scene: the floor is at z = 0.5 m.
Scene scene_of_columns() {
  Scene scene = hand_made_scene(3);
  scene.domain_min = Vec3d(1.0, 2.0, 0.5);
  scene.domain_max = Vec3d(1.5, 2.2, 1.5);
  return scene;
}

TEST(ColumnLevel, IsBedAndDepthInTheCellOfThePoint) {
  const ColumnField columns = columns_with_a_block();
  EXPECT_FLOAT_EQ(static_cast<float>(column_level(columns, 1.05, 2.05)), 0.1F);
  EXPECT_FLOAT_EQ(static_cast<float>(column_level(columns, 1.15, 2.15)), 0.3F) << "over the block";
  EXPECT_EQ(column_level(columns, 1.15, 2.05), 0.0) << "dry block";
  EXPECT_EQ(column_level(columns, 0.9, 2.05), 0.0) << "outside";
  EXPECT_EQ(column_level(columns, 1.5, 2.2), 0.0) << "the last cell has its upper corner";
}

TEST(ColumnFront, IsTheUpperEndOfTheFarthestColumnDeepEnough) {
  const LeadingEdge edge = column_front(columns_with_a_block());
  EXPECT_NEAR(edge.front, 1.4, 1e-12) << "0.5 mm";
  EXPECT_NEAR(edge.bulk_front, 1.3, 1e-12);
  ColumnField dry = columns_with_a_block();
  dry.depth.assign(10, 0.0F);
  EXPECT_TRUE(std::isnan(column_front(dry).front));
}

TEST(ColumnFront, OfAProbeLooksInItsDirectionAndBand) {
  const Scene scene = scene_of_columns();
  const ColumnField columns = columns_with_a_block();
  FrontProbe probe;
  EXPECT_NEAR(column_front(probe, columns, scene).front, 1.4, 1e-12);
  probe.band.range[1] = {2.1, 2.2};
  EXPECT_NEAR(column_front(probe, columns, scene).front, 1.3, 1e-12) << "second row";
  probe.upwards = false;
  EXPECT_NEAR(column_front(probe, columns, scene).bulk_front, 1.0, 1e-12);
  probe.band.range[1].reset();
  probe.axis = 1;
  probe.band.range[0] = {1.3, 1.4};
  EXPECT_NEAR(column_front(probe, columns, scene).front, 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(column_front(probe, columns, scene).bulk_front)) << "half a millimetre deep";
}

TEST(ColumnDischarge, IsDepthTimesVelocityBetweenTheColumns) {
  const Scene scene = scene_of_columns();
  const ColumnField columns = columns_with_a_block();
  DischargeProbe probe;
  probe.position = 1.25;
  EXPECT_NEAR(column_discharge(probe, columns, scene), 0.1 * (0.3 * -1.0), 1e-8);
  probe.position = 1.1;  // half way between columns 0 and 1
  EXPECT_NEAR(column_discharge(probe, columns, scene), 0.1 * 0.5 * (0.1 + 0.8 + 0.05), 1e-8);
  probe.band.range[1] = {2.05, 2.1};
  EXPECT_NEAR(column_discharge(probe, columns, scene), 0.05 * 0.5 * 0.1, 1e-8);
  probe.band.range[1].reset();
  probe.position = 1.05;
  probe.band.range[2] = {0.5, 0.7};  // up to 0.2 m above the floor
  EXPECT_NEAR(column_discharge(probe, columns, scene), 0.1 * (0.1 * 1.0 + 0.2 * 2.0), 1e-8);
  DischargeProbe across;
  across.axis = 1;
  across.position = 2.05;
  EXPECT_NEAR(column_discharge(across, columns, scene), 0.1 * 0.6, 1e-8);
}

TEST(ColumnWallPressure, IsThatOfTheColumnInFront) {
  const Scene scene = scene_of_columns();
  const ColumnField columns = columns_with_a_block();
  // The block's face at x = 1.2 in the first row, with 0.3 m of water before it.
  const auto at = [&](double x, double z, const Vec3d& normal) {
    return column_wall_pressure(Vec3d(x, 2.05, z), normal, columns, scene);
  };
  ASSERT_TRUE(at(1.2, 0.6, Vec3d::UnitX()));
  EXPECT_NEAR(*at(1.2, 0.6, Vec3d::UnitX()), 1000.0 * 9.81 * 0.2, 1e-3);
  EXPECT_FALSE(at(1.2, 0.81, Vec3d::UnitX())) << "above the water";
  EXPECT_NEAR(*at(1.25, 0.5, Vec3d::UnitZ()), 1000.0 * 9.81 * 0.3, 1e-3) << "floor";
  EXPECT_NEAR(*at(1.14, 0.6, Vec3d::UnitX()), 1000.0 * 9.81 * 0.2, 1e-3)
      << "a face inside the cell of a solid";
  EXPECT_FALSE(at(1.15, 0.7, Vec3d::UnitZ())) << "dry top";
}

TEST(ColumnLedger, SumsMassEnergiesAndMomentum) {
  const Scene scene = scene_of_columns();
  const ColumnField columns = columns_with_a_block();
  const LedgerEntry entry = column_ledger(columns, scene);
  const double area = 0.01;
  EXPECT_NEAR(entry.mass, 1000.0 * area * (0.1 + 0.3 + 5e-4 + 5e-5 + 0.4 + 0.1 + 0.2), 1e-6);
  EXPECT_NEAR(entry.volume, 1e-3 * entry.mass, 1e-12);
  EXPECT_NEAR(entry.kinetic_energy,
              500.0 * area * (0.1 * 1.0 + 0.3 * 5.0 + 0.4 * 4.0 + 0.1 * 0.25 + 0.2 * 1.0), 1e-6);
  EXPECT_NEAR(entry.momentum.x(), 1000.0 * area * (0.1 - 0.3 + 0.8 + 0.05), 1e-6);
  EXPECT_NEAR(entry.momentum.y(), 1000.0 * area * (0.6 - 0.2), 1e-6);
  const double potential =
      0.005 + 0.045 + 0.5 * 25e-8 + 0.5 * 25e-10 + 0.08 + 0.1 * 0.25 + 0.02;  // depth x height of the centre
  EXPECT_NEAR(entry.potential_energy, 1000.0 * 9.81 * area * potential, 1e-5);
  EXPECT_EQ(entry.compression_max, 0.0);
  EXPECT_EQ(wet_columns(columns), 7U);
}

TEST(ColumnSample, IsHydrostaticBetweenBedAndSurface) {
  const Scene scene = scene_of_columns();
  const ColumnField columns = columns_with_a_block();
  const PointSample sample = sample_column(Vec3d(1.25, 2.05, 0.6), columns, scene);
  ASSERT_TRUE(sample.wet);
  EXPECT_NEAR(sample.pressure, 1000.0 * 9.81 * 0.2, 1e-3);
  EXPECT_EQ(sample.velocity, Vec3d(-1.0, 2.0, 0.0));
  EXPECT_FALSE(sample_column(Vec3d(1.25, 2.05, 0.81), columns, scene).wet) << "above the water";
  EXPECT_FALSE(sample_column(Vec3d(1.15, 2.15, 0.65), columns, scene).wet) << "in the block";
  EXPECT_TRUE(sample_column(Vec3d(1.15, 2.15, 0.75), columns, scene).wet);
  EXPECT_FALSE(sample_column(Vec3d(1.15, 2.05, 0.75), columns, scene).wet) << "on the dry block";
}

TEST(ResampledLevels, KeepTheVolumeOverABareFloor) {
  ColumnField columns = columns_with_a_block();
  columns.bed.assign(10, 0.0F);
  const double volume = 0.01 * std::accumulate(columns.depth.begin(), columns.depth.end(), 0.0);
  for (const double cell : {0.1, 0.05, 0.025, 0.2 / 3.0}) {
    DepthGrid grid;
    grid.origin_x = 1.0 - cell;
    grid.origin_y = 2.0 - cell;
    grid.cell_size = cell;
    grid.columns = static_cast<std::size_t>(std::ceil(0.5 / cell - 1e-9)) + 2;
    grid.rows = static_cast<std::size_t>(std::ceil(0.2 / cell - 1e-9)) + 2;
    grid.depth.assign(grid.columns * grid.rows, 7.0F);
    resample_levels(columns, grid);
    if (grid.cell_size != 0.2 / 3.0) {
      EXPECT_NEAR(cell * cell * std::accumulate(grid.depth.begin(), grid.depth.end(), 0.0), volume, 1e-9)
          << cell;
    }
    EXPECT_EQ(grid.depth[0], 0.0F) << "outside";
  }
}

TEST(ResampledLevels, AreWeightedWithTheAreasInCommon) {
  ColumnField columns = columns_with_a_block();
  columns.bed.assign(10, 0.0F);
  DepthGrid grid;
  grid.origin_x = 1.0;
  grid.origin_y = 2.0;
  grid.cell_size = 0.15;
  grid.columns = 2;
  grid.rows = 1;
  grid.depth.assign(2, 0.0F);
  resample_levels(columns, grid);
  // Two thirds and a third along each axis.
  const double lower = (2.0 * 0.1 + 0.0) / 3.0;
  const double upper = (2.0 * 0.4 + 0.1) / 3.0;
  EXPECT_NEAR(grid.depth[0], (2.0 * lower + upper) / 3.0, 1e-7);
}

TEST(ResampledLevels, LeaveDrySolidsOut) {
  const ColumnField columns = columns_with_a_block();
  DepthGrid grid;
  grid.origin_x = 1.0;
  grid.origin_y = 2.0;
  grid.cell_size = 0.2;
  grid.columns = 3;
  grid.rows = 1;
  grid.depth.assign(3, 0.0F);
  resample_levels(columns, grid);
  EXPECT_NEAR(grid.depth[0], (0.1 + 0.4 + 0.3) / 3.0, 1e-7) << "three cells of four";
  EXPECT_NEAR(grid.depth[2], 5e-5 / 2.0, 1e-9) << "the half outside the columns counts for nothing";
}

TEST(Probes, ReadTheColumnsWhereThereAreAny) {
  Scene scene = scene_of_columns();
  scene.output.depth_cell_size = 0.1;
  // Particles that say something else.
  Snapshot snapshot = hand_made_snapshot(scene, {Vec3f(1.25F, 2.05F, 1.4F)});
  snapshot.columns = std::make_shared<const ColumnField>(columns_with_a_block());
  Gauge gauge;
  gauge.x = 1.25;
  gauge.y = 2.05;
  EXPECT_NEAR(water_level(gauge, scene, snapshot), 0.3, 1e-7);
  EXPECT_NEAR(leading_edge(snapshot).front, 1.4, 1e-12);
  EXPECT_NEAR(take_ledger(snapshot, scene).mass, column_ledger(*snapshot.columns, scene).mass, 1e-12);
  snapshot.number_density[0] = 0.1F;  // no spray where there are no particles
  EXPECT_NEAR(water_level(gauge, scene, snapshot), 0.3, 1e-7);
  const DepthGrid grid = DepthGridBuilder(scene).build(snapshot);
  EXPECT_NEAR(grid.at(2, 0), 0.3, 1e-7);
  EXPECT_NEAR(grid.at(1, 1), 0.3, 1e-7);
}

}  // namespace
}  // namespace eisph
