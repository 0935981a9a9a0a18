#include "scheme/particle_packing.hpp"

#include "core/fluid_fit.hpp"
#include "core/water_volume.hpp"
#include "scheme/scenes.hpp"

#include <cstdio>
#include <numbers>
#include <ostream>

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

TEST_P(PackedWater, IsEvenAtASolidOffItsLattice) {
  const PackedCase& c = GetParam();
  const Scene scene = still_water_about(c.dimension, c.size, c.spacing, c.depth, c.solid);
  const auto simulation = start(scene);
  const auto snapshot = simulation->snapshot();
  double lowest = 9.0;
  double highest = 0.0;
  double all = 0.0;
  double nearest = 9.0;
  for (std::size_t k = 0; k < snapshot->size(); ++k) {
    const Vec3d at = snapshot->position[k].cast<double>();
    all = std::max<double>(all, snapshot->number_density[k]);
    const double distance = c.solid.signed_distance(at, c.dimension);
    nearest = std::min(nearest, distance / c.spacing);
    if (at.z() > c.depth - scene.support_radius() || distance > scene.support_radius()) continue;
    lowest = std::min<double>(lowest, snapshot->number_density[k]);
    highest = std::max<double>(highest, snapshot->number_density[k]);
  }
  std::printf("%s N %zu density %.4f to %.4f, all %.4f, nearest %.3f\n", c.name, snapshot->size(), lowest,
              highest, all, nearest);
  std::fflush(stdout);
  double fastest = 0.0;
  for (int k = 1; k <= 10; ++k) {
    run_until(*simulation, 0.05 * k);
    fastest = std::max(fastest, largest_speed(*simulation->snapshot()));
  }
  const RunSummary s = simulation->summary();
  std::printf("   fastest %.4f m/s, compression %.4f, energy gain %.3g of %.3g\n", fastest, s.compression_max,
              s.energy_gain_max, s.energy_initial);
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
