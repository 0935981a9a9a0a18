#include "core/fluid_fit.hpp"

#include "core/water_volume.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

Shape box(const Vec3d& min, const Vec3d& max) {
  Shape shape;
  shape.min = min;
  shape.max = max;
  return shape;
}

Scene flat_tank(double length, double depth) {
  Scene scene;
  scene.dimension = 2;
  scene.particle_spacing = 0.02;
  scene.domain_max = Vec3d(length, 0.0, 0.6);
  scene.fluid.push_back({.shape = box(Vec3d::Zero(), Vec3d(length, 0.0, depth))});
  return scene;
}

double layers(const FluidPiece& piece, std::size_t axis) { return piece.layers[axis]; }

TEST(FluidFit, LeavesWaterOnTheLatticeAlone) {
  Scene scene = flat_tank(1.0, 0.3);
  scene.fluid.push_back({.shape = box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.6, 0.0, 0.1)), .cut = true});
  const FluidFit fit = fit_fluid(scene);
  EXPECT_TRUE(fit.aligned);
  EXPECT_TRUE(fit.pieces.empty());
  EXPECT_EQ(fit.misfit, 0.0);
}

TEST(FluidFit, GivesATankTheLayersOfTheNearestCellVolume) {
  const FluidFit fit = fit_fluid(flat_tank(1.011, 0.3));  // 50.55 spacings
  ASSERT_EQ(fit.pieces.size(), 1U);
  EXPECT_FALSE(fit.aligned);
  EXPECT_EQ(layers(fit.pieces[0], 0), 51.0);
  EXPECT_EQ(layers(fit.pieces[0], 2), 15.0);
  EXPECT_NEAR(fit.cell_volume, 1.011 * 0.3 / (51.0 * 15.0), 1e-12);
  EXPECT_NEAR(fit.misfit, 0.0, 1e-12);
  EXPECT_EQ(layers(fit_fluid(flat_tank(1.009, 0.3)).pieces.at(0), 0), 50.0);
}

TEST(FluidFit, JoinsRegionsThatContinueEachOther) {
  Scene scene = flat_tank(1.007, 0.3);
  scene.fluid[0].shape.max.x() = 0.41;
  scene.fluid.push_back({.shape = box(Vec3d(0.41, 0.0, 0.0), Vec3d(1.007, 0.0, 0.3))});
  scene.fluid.push_back({.shape = box(Vec3d(0.3, 0.0, 0.05), Vec3d(0.6, 0.0, 0.295))});  // within the others
  const FluidFit fit = fit_fluid(scene);
  ASSERT_EQ(fit.pieces.size(), 1U);
  EXPECT_EQ(fit.pieces[0].upper.x(), 1.007);
  // A film on top that no lattice could hold by itself is the top of what lies below.
  scene.fluid.push_back({.shape = box(Vec3d(0.0, 0.0, 0.3), Vec3d(1.007, 0.0, 0.305))});
  ASSERT_EQ(fit_fluid(scene).pieces.size(), 1U);
  EXPECT_EQ(fit_fluid(scene).pieces[0].upper.z(), 0.305);
}

TEST(FluidFit, DividesTheWaterAboutCutOutsIntoPiecesOfLikeCells) {
  Scene scene = flat_tank(1.009, 0.307);
  scene.fluid.push_back({.shape = box(Vec3d(0.403, 0.0, 0.1), Vec3d(0.611, 0.0, 0.207)), .cut = true});
  const FluidFit fit = fit_fluid(scene);
  ASSERT_GE(fit.pieces.size(), 4U);
  EXPECT_TRUE(fit.thin.empty());
  EXPECT_LT(fit.misfit, 0.02);
  double volume = 0.0;
  double cells = 0.0;
  for (const FluidPiece& piece : fit.pieces) {
    volume += piece_volume(scene, piece);
    cells += layers(piece, 0) * layers(piece, 2);
    for (const int axis : {0, 2}) EXPECT_NEAR(piece.spacing(axis), 0.02, 0.0035);
    EXPECT_EQ(scene.fluid[1].shape.signed_distance(0.5 * (piece.lower + piece.upper), 2) > 0.0, true);
  }
  EXPECT_NEAR(volume, water_volume(scene), 1e-12);
  EXPECT_NEAR(fit.cell_volume * cells, volume, 1e-12);
}

TEST(FluidFit, NamesWaterThatIsTooThinForALayer) {
  Scene scene = flat_tank(1.013, 0.3);
  scene.fluid.push_back({.shape = box(Vec3d(0.4, 0.0, 0.0), Vec3d(0.6, 0.0, 0.295)), .cut = true});
  const FluidFit fit = fit_fluid(scene);
  ASSERT_EQ(fit.thin.size(), 1U);
  EXPECT_EQ(thin_axis(scene, fit.thin[0]), 2);
  EXPECT_NEAR(piece_volume(scene, fit.thin[0]), 0.2 * 0.005, 1e-12);
  for (const FluidPiece& piece : fit.pieces) EXPECT_EQ(thin_axis(scene, piece), -1);
  EXPECT_LT(fit.misfit, 0.02) << "the thin piece does not count";
}

}  // namespace
}  // namespace eisph
