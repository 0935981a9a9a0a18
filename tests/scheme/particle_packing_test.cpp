#include "scheme/particle_packing.hpp"

#include "core/fluid_fit.hpp"
#include "core/water_volume.hpp"
#include "scheme/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace eisph {
namespace {

Shape sphere(const Vec3d& centre, double radius) {
  Shape shape;
  shape.kind = ShapeKind::Sphere;
  shape.centre = centre;
  shape.radius = radius;
  return shape;
}

/// A tank of still water with a solid in it, whose shape is cut out of the water.
Scene still_water_about(int dimension, const Vec3d& size, double spacing, double depth, const Shape& solid) {
  Scene scene = tank(dimension, size, spacing, box(Vec3d::Zero(), Vec3d(size.x(), size.y(), depth)));
  take_kernel_defaults(scene);
  scene.fluid.push_back({.shape = solid, .cut = true});
  scene.obstacles.push_back({"solid", solid});
  return scene;
}

struct PackedCase {
  const char* name;
  int dimension;
  double spacing;
  double depth;
  Vec3d size;
  Shape solid;

  friend void PrintTo(const PackedCase& packed, std::ostream* out) { *out << packed.name; }
};

class PackedWater : public testing::TestWithParam<PackedCase> {};

/// Of the normalised number density of what a solid is in reach of and the surface is not.
struct Range {
  double lowest = 9.0;
  double highest = 0.0;
};

Range density_about(const Snapshot& snapshot, const Scene& scene, double depth) {
  const Shape& solid = scene.obstacles[0].shape;
  Range range;
  for (std::size_t k = 0; k < snapshot.size(); ++k) {
    const Vec3d at = snapshot.position[k].cast<double>();
    if (at.z() > depth - scene.support_radius()) continue;
    if (solid.signed_distance(at, scene.dimension) > scene.support_radius()) continue;
    range.lowest = std::min<double>(range.lowest, snapshot.number_density[k]);
    range.highest = std::max<double>(range.highest, snapshot.number_density[k]);
  }
  return range;
}

TEST_P(PackedWater, IsEvenAtASolidOffItsLattice) {
  const PackedCase& c = GetParam();
  const Scene scene = still_water_about(c.dimension, c.size, c.spacing, c.depth, c.solid);
  const auto simulation = start(scene);
  const auto snapshot = simulation->snapshot();
  const Range density = density_about(*snapshot, scene, c.depth);
  RecordProperty("lowest", std::to_string(density.lowest));
  RecordProperty("highest", std::to_string(density.highest));
  EXPECT_GT(density.lowest, 0.975);
  EXPECT_LT(density.highest, 1.01);
  EXPECT_LT(*std::max_element(snapshot->number_density.begin(), snapshot->number_density.end()), 1.025);
  for (const Vec3f& at : snapshot->position) {
    ASSERT_GT(c.solid.signed_distance(at.cast<double>(), c.dimension), 0.499 * c.spacing);
    ASSERT_LT(at.z(), c.depth - 0.3 * c.spacing) << "nothing is pushed through the surface";
  }
  const double volume = water_volume(scene);
  EXPECT_NEAR(snapshot->particle_mass / snapshot->reference_density * static_cast<double>(snapshot->size()),
              volume, 1e-6 * volume);

  // Half of the speed at which a particle that falls by its spacing arrives: nothing is shot out.
  const double slow = 0.5 * std::sqrt(2.0 * kGravity * c.spacing);
  for (int k = 1; k <= 10; ++k) {
    run_until(*simulation, 0.05 * k);
    EXPECT_LT(largest_speed(*simulation->snapshot()), slow);
  }
  EXPECT_EQ(simulation->summary().penetrations, 0U);
}

TEST(Packing, IsTheSameForAnyNumberOfThreads) {
  const Scene scene =
      still_water_about(3, Vec3d(0.8, 0.8, 0.8), 0.04, 0.6, sphere(Vec3d(0.4, 0.4, 0.3), 0.15));
  EXPECT_EQ(packed_fluid(scene, 1).position, packed_fluid(scene, 3).position);
}

TEST(Packing, LeavesWaterAloneThatTouchesNoRoundSolid) {
  Scene scene = tank(3, Vec3d(0.8, 0.4, 0.6), 0.04, box(Vec3d::Zero(), Vec3d(0.4, 0.4, 0.4)));
  scene.obstacles.push_back({"wall", box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.45, 0.2, 0.4))});
  scene.obstacles.push_back({"column", cylinder(Vec3d(0.6, 0.2, 0.0), 0.1, 0.4)});
  ASSERT_TRUE(fit_fluid(scene).aligned);
  EXPECT_EQ(packed_fluid(scene, 1).position, fluid_lattice(scene).position);
}

TEST(Packing, MovesOnlyWaterNearTheSolid) {
  Scene scene = still_water_about(2, Vec3d(2.0, 0.0, 0.8), 0.02, 0.4, sphere(Vec3d(0.5, 0.0, 0.2), 0.1));
  const FluidLattice lattice = fluid_lattice(scene);
  const FluidLattice packed = packed_fluid(scene, 1);
  ASSERT_EQ(packed.position.size(), lattice.position.size());
  double moved = 0.0;
  for (std::size_t k = 0; k < packed.position.size(); ++k) {
    const double way = (packed.position[k] - lattice.position[k]).norm();
    moved = std::max(moved, way);
    if (lattice.position[k].x() > 0.6 + 8.0 * scene.smoothing_length()) {
      EXPECT_EQ(way, 0.0);
    }
  }
  EXPECT_GT(moved, 0.1 * scene.particle_spacing);
}

TEST(Packing, JitterComesOnTop) {
  Scene scene = still_water_about(2, Vec3d(1.0, 0.0, 0.8), 0.02, 0.4, sphere(Vec3d(0.5, 0.0, 0.2), 0.1));
  const FluidLattice still = packed_fluid(scene, 1);
  scene.jitter = 0.1;
  const FluidLattice jittered = packed_fluid(scene, 1);
  ASSERT_EQ(still.position.size(), jittered.position.size());
  for (std::size_t k = 0; k < still.position.size(); ++k) {
    EXPECT_LE((still.position[k] - jittered.position[k]).cwiseAbs().maxCoeff(), 0.1 * 0.02 + 1e-12);
  }
  EXPECT_NE(still.position, jittered.position);
}

constexpr double kDegree = std::numbers::pi / 180.0;

Shape rotated_box(double degrees) {
  return box(Vec3d(0.24, 0.24, 0.2), Vec3d(0.56, 0.56, 0.4), degrees * kDegree);
}

const Vec3d kFlat(1.0, 0.0, 0.8);
const Vec3d kDeep(0.8, 0.8, 0.8);

INSTANTIATE_TEST_SUITE_P(
    Solids, PackedWater,
    testing::Values(PackedCase{"disc", 2, 0.02, 0.6, kFlat, sphere(Vec3d(0.5, 0.0, 0.3), 0.1)},
                    PackedCase{"disc_on_the_floor", 2, 0.02, 0.4, kFlat, sphere(Vec3d(0.47, 0.0, 0.0), 0.15)},
                    PackedCase{"disc_through_the_surface", 2, 0.02, 0.4, kFlat,
                               sphere(Vec3d(0.47, 0.0, 0.4), 0.15)},
                    PackedCase{"box_17", 3, 0.04, 0.6, kDeep, rotated_box(17.0)},
                    PackedCase{"box_30", 3, 0.04, 0.6, kDeep, rotated_box(30.0)},
                    PackedCase{"box_45", 3, 0.04, 0.6, kDeep, rotated_box(45.0)},
                    PackedCase{"sphere", 3, 0.04, 0.6, kDeep, sphere(Vec3d(0.4, 0.4, 0.3), 0.15)},
                    PackedCase{"cylinder", 3, 0.04, 0.6, kDeep, cylinder(Vec3d(0.4, 0.4, 0.2), 0.15, 0.2)},
                    PackedCase{"column", 3, 0.04, 0.6, kDeep, cylinder(Vec3d(0.4, 0.4, 0.0), 0.15, 0.8)}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace eisph
