#include "boundary/mirror_planes.hpp"

#include "boundary/tank_scene.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// An image of a particle that is at `at` and moves with (1, 1, 1).
struct Mirrored {
  std::array<double, 3> position{};
  std::array<double, 3> velocity{};
};

template <int Dim>
std::vector<Mirrored> images_of(const Scene& scene, const Float4& at) {
  const MirrorPlanes<Dim> planes(scene);
  std::vector<Mirrored> images;
  planes.for_images(at, [&](std::uint8_t code) {
    const auto& image = planes.image(code);
    Mirrored mirrored;
    for (std::size_t d = 0; d < Dim; ++d) {
      mirrored.position[d] = image.scale[d] * (&at.x)[d] + image.shift[d];
      mirrored.velocity[d] = image.velocity[d];
    }
    images.push_back(mirrored);
  });
  return images;
}

/// Edges of the tank in smoothing lengths.
double extent(const Scene& scene, int axis) {
  return (scene.domain_max[axis] - scene.domain_min[axis]) / scene.smoothing_length();
}

TEST(MirrorPlanes, InTheMiddleThereIsNoImage) {
  EXPECT_TRUE(images_of<3>(tank_scene(3), {10.0F, 10.0F, 10.0F, 0.0F}).empty());
  EXPECT_TRUE(images_of<2>(tank_scene(2), {10.0F, 10.0F, 0.0F, 0.0F}).empty());
}

TEST(MirrorPlanes, AFaceMakesOneImageAnEdgeThreeACornerSeven) {
  const Scene tank = tank_scene(3);
  EXPECT_EQ(images_of<3>(tank, {1.5F, 10.0F, 10.0F, 0.0F}).size(), 1U);
  EXPECT_EQ(images_of<3>(tank, {1.5F, 0.5F, 10.0F, 0.0F}).size(), 3U);
  EXPECT_EQ(images_of<3>(tank, {1.5F, 0.5F, 0.2F, 0.0F}).size(), 7U);
  const Scene plane = tank_scene(2);
  EXPECT_EQ(images_of<2>(plane, {1.5F, 10.0F, 0.0F, 0.0F}).size(), 1U);
  EXPECT_EQ(images_of<2>(plane, {1.5F, 0.5F, 0.0F, 0.0F}).size(), 3U);
}

TEST(MirrorPlanes, OnlyParticlesWithinASupportRadiusHaveAnImage) {
  const Scene tank = tank_scene(3);
  EXPECT_EQ(images_of<3>(tank, {1.999F, 10.0F, 10.0F, 0.0F}).size(), 1U);
  EXPECT_EQ(images_of<3>(tank, {2.001F, 10.0F, 10.0F, 0.0F}).size(), 0U);
  const auto top = static_cast<float>(extent(tank, 2));
  EXPECT_EQ(images_of<3>(tank, {10.0F, 10.0F, top - 1.999F, 0.0F}).size(), 1U);
  EXPECT_EQ(images_of<3>(tank, {10.0F, 10.0F, top - 2.001F, 0.0F}).size(), 0U);
}

TEST(MirrorPlanes, ImagesLieAsFarBehindTheFaceAsTheParticleBeforeIt) {
  const Scene tank = tank_scene(3);
  const auto length = static_cast<float>(extent(tank, 0));
  const auto low = images_of<3>(tank, {0.7F, 9.0F, 10.0F, 0.0F});
  ASSERT_EQ(low.size(), 1U);
  EXPECT_NEAR(low[0].position[0], -0.7, 1e-6);
  EXPECT_NEAR(low[0].position[1], 9.0, 1e-6);
  const auto high = images_of<3>(tank, {length - 0.7F, 9.0F, 10.0F, 0.0F});
  ASSERT_EQ(high.size(), 1U);
  EXPECT_NEAR(high[0].position[0], length + 0.7, 1e-5);
}

struct SlipCase {
  Face face;
  double tangential;
};

class MirrorPlanesSlip : public testing::TestWithParam<SlipCase> {};

TEST_P(MirrorPlanesSlip, NegatesTheNormalVelocityAndScalesTheTangentialOne) {
  Scene tank = tank_scene(3);
  set_all_faces(tank, GetParam().face);
  const double t = GetParam().tangential;
  const auto face = images_of<3>(tank, {0.7F, 10.0F, 10.0F, 0.0F});
  ASSERT_EQ(face.size(), 1U);
  EXPECT_FLOAT_EQ(face[0].velocity[0], -1.0);
  EXPECT_FLOAT_EQ(face[0].velocity[1], t);
  EXPECT_FLOAT_EQ(face[0].velocity[2], t);
}

TEST_P(MirrorPlanesSlip, TakesTheProductOfTheFactorsAtEdgesAndCorners) {
  Scene tank = tank_scene(3);
  set_all_faces(tank, GetParam().face);
  const double t = GetParam().tangential;
  int edges = 0;
  int corners = 0;
  for (const Mirrored& image : images_of<3>(tank, {0.7F, 0.6F, 0.5F, 0.0F})) {
    const bool x = image.position[0] < 0.0;
    const bool y = image.position[1] < 0.0;
    const bool z = image.position[2] < 0.0;
    edges += x + y + z == 2 ? 1 : 0;
    corners += x && y && z ? 1 : 0;
    const auto factor = [&](bool own, bool one, bool other) {
      return (own ? -1.0 : 1.0) * (one ? t : 1.0) * (other ? t : 1.0);
    };
    EXPECT_FLOAT_EQ(image.velocity[0], factor(x, y, z));
    EXPECT_FLOAT_EQ(image.velocity[1], factor(y, x, z));
    EXPECT_FLOAT_EQ(image.velocity[2], factor(z, x, y));
  }
  EXPECT_EQ(edges, 3);
  EXPECT_EQ(corners, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Faces, MirrorPlanesSlip,
    testing::Values(SlipCase{{FaceKind::Wall, 1.0}, 1.0}, SlipCase{{FaceKind::Wall, 0.0}, -1.0},
                    SlipCase{{FaceKind::Wall, 0.25}, -0.5},
                    // A symmetry plane is free of friction whatever its slip factor says.
                    SlipCase{{FaceKind::Symmetry, 0.0}, 1.0}));

TEST(MirrorPlanes, EdgesOfDifferentFacesKeepTheFactorOfEach) {
  Scene tank = tank_scene(3);
  tank.faces[kXMin] = {FaceKind::Wall, 0.0};
  tank.faces[kYMin] = {FaceKind::Symmetry, 1.0};
  for (const Mirrored& image : images_of<3>(tank, {0.7F, 0.6F, 10.0F, 0.0F})) {
    const double no_slip = image.position[0] < 0.0 ? -1.0 : 1.0;
    EXPECT_FLOAT_EQ(image.velocity[0], no_slip);
    EXPECT_FLOAT_EQ(image.velocity[1], (image.position[1] < 0.0 ? -1.0 : 1.0) * no_slip);
    EXPECT_FLOAT_EQ(image.velocity[2], no_slip);
  }
}

TEST(MirrorPlanes, OpenFacesMakeNoImages) {
  Scene tank = tank_scene(3);
  tank.faces[kXMin].kind = FaceKind::Open;
  EXPECT_TRUE(images_of<3>(tank, {0.5F, 10.0F, 10.0F, 0.0F}).empty());
  EXPECT_EQ(images_of<3>(tank, {0.5F, 0.5F, 10.0F, 0.0F}).size(), 1U) << "the other face still mirrors";
  set_all_faces(tank, {FaceKind::Open, 1.0});
  EXPECT_TRUE(MirrorPlanes<3>(tank).empty());
}

TEST(MirrorPlanes, WallsWithoutGhostsMakeNoImagesButSymmetryPlanesDo) {
  Scene tank = tank_scene(3);
  tank.boundary.ghost_particles = false;
  tank.faces[kYMax].kind = FaceKind::Symmetry;
  EXPECT_TRUE(images_of<3>(tank, {0.5F, 0.5F, 0.5F, 0.0F}).empty());
  const auto top = static_cast<float>(extent(tank, 1));
  EXPECT_EQ(images_of<3>(tank, {0.5F, top - 0.5F, 0.5F, 0.0F}).size(), 1U);
}

TEST(MirrorPlanes, ANarrowDomainHasImagesOfTheSecondOrder) {
  Scene slot = tank_scene(3);
  // Two spacings wide: 1.515 smoothing lengths, less than the support radius of two.
  slot.domain_max.y() = slot.domain_min.y() + 2.0 * slot.particle_spacing;
  set_all_faces(slot, {FaceKind::Wall, 0.0});
  const double width = extent(slot, 1);
  const auto images = images_of<3>(slot, {10.0F, 0.4F, 10.0F, 0.0F});
  std::vector<double> places;
  for (const Mirrored& image : images) places.push_back(image.position[1]);
  std::sort(places.begin(), places.end());
  // Both first-order images, and the one of the second order that is near enough: 0.4 + 2 x 1.515 = 3.43 is
  // within 2 of the domain's end, 0.4 - 2 x 1.515 = -2.63 is not within 2 of its beginning.
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[0], -0.4, 1e-5);
  EXPECT_NEAR(places[1], 2.0 * width - 0.4, 1e-5);
  EXPECT_NEAR(places[2], 2.0 * width + 0.4, 1e-5);
  for (const Mirrored& image : images) {
    const bool second = image.position[1] > 2.0 * width;
    EXPECT_FLOAT_EQ(image.velocity[0], second ? 1.0 : -1.0) << "two no-slip reflections undo each other";
    EXPECT_FLOAT_EQ(image.velocity[1], second ? 1.0 : -1.0);
  }
}

TEST(MirrorPlanes, AWideDomainHasNoImagesOfTheSecondOrder) {
  Scene slot = tank_scene(3);
  slot.domain_max.y() = slot.domain_min.y() + 3.0 * slot.particle_spacing;  // 2.27 smoothing lengths
  EXPECT_EQ(images_of<3>(slot, {10.0F, 1.1F, 10.0F, 0.0F}).size(), 2U);
}

}  // namespace
}  // namespace eisph
