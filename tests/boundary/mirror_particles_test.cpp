#include "boundary/mirror_particles.hpp"

#include "boundary/tank_scene.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

namespace eisph {
namespace {

/// Position, velocity and pressure of an image, in the order used to compare two sets.
using Image = std::array<float, 7>;

template <int Dim>
struct Fixture {
  Scene scene = tank_scene(Dim);
  std::array<double, Dim> extent{};
  std::vector<Float4> position;
  std::vector<Float4> velocity;

  explicit Fixture(bool narrow) {
    scene.faces[kXMin] = {FaceKind::Wall, 0.25};
    scene.faces[kZMin] = {FaceKind::Wall, 0.0};
    scene.faces[kZMax] = {FaceKind::Open, 1.0};
    scene.faces[kYMax] = {FaceKind::Symmetry, 1.0};
    if (narrow) scene.domain_max.x() = scene.domain_min.x() + 2.0 * scene.particle_spacing;
    std::mt19937 generator(3);
    for (int d = 0; d < Dim; ++d) {
      const int axis = scene_axis<Dim>(d);
      extent[d] = (scene.domain_max[axis] - scene.domain_min[axis]) / scene.smoothing_length();
    }
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    for (int k = 0; k < 5000; ++k) {
      Float4 at{};
      Float4 u{};
      for (int d = 0; d < Dim; ++d) {
        (&at.x)[d] = unit(generator) * static_cast<float>(extent[d]);
        (&u.x)[d] = unit(generator) - 0.5F;
      }
      at.w = unit(generator);
      u.w = unit(generator);
      position.push_back(at);
      velocity.push_back(u);
    }
  }

  [[nodiscard]] bool mirrors(int face) const {
    return scene.faces[static_cast<std::size_t>(face)].kind != FaceKind::Open;
  }
  [[nodiscard]] float tangential(int face) const {
    const Face& wall = scene.faces[static_cast<std::size_t>(face)];
    return wall.kind == FaceKind::Symmetry ? 1.0F : static_cast<float>(2.0 * wall.slip_factor - 1.0);
  }

  /// All images by trying every combination of up to two reflections per axis.
  [[nodiscard]] std::vector<Image> all_images() const {
    std::vector<Image> images;
    for (std::size_t k = 0; k < position.size(); ++k) {
      Image self{};
      for (int d = 0; d < Dim; ++d) {
        self[static_cast<std::size_t>(d)] = (&position[k].x)[d];
        self[static_cast<std::size_t>(3 + d)] = (&velocity[k].x)[d];
      }
      self[6] = position[k].w;
      reflect(0, self, 0, images);
    }
    std::sort(images.begin(), images.end());
    return images;
  }

  void reflect(int d, const Image& image, int reflections, std::vector<Image>& images) const {
    if (d == Dim) {
      if (reflections > 0) images.push_back(image);
      return;
    }
    const auto length = static_cast<float>(extent[d]);
    const int lower = 2 * scene_axis<Dim>(d);
    const int upper = lower + 1;
    const std::vector<std::vector<int>> sequences = {{}, {lower}, {upper}, {upper, lower}, {lower, upper}};
    for (const std::vector<int>& sequence : sequences) {
      if (!std::all_of(sequence.begin(), sequence.end(), [&](int face) { return mirrors(face); })) continue;
      Image next = image;
      auto& x = next[static_cast<std::size_t>(d)];
      for (const int face : sequence) {
        x = face == lower ? -x : 2.0F * length - x;
        for (int c = 0; c < Dim; ++c) {
          next[static_cast<std::size_t>(3 + c)] *= c == d ? -1.0F : tangential(face);
        }
      }
      if (!sequence.empty() && (x < -2.0F || x > length + 2.0F)) continue;
      reflect(d + 1, next, reflections + static_cast<int>(sequence.size()), images);
    }
  }
};

template <int Dim>
void expect_all_images(bool narrow, int threads) {
  const Fixture<Dim> fixture(narrow);
  const MirrorPlanes<Dim> planes(fixture.scene);
  const CellGrid<Dim> grid(fixture.extent);
  ThreadPool pool(threads);
  CellSort::Workspace workspace;
  MirrorParticles<Dim> mirror;
  mirror.find(planes, grid, fixture.position.data(), fixture.position.size(), pool, workspace);
  std::vector<Float4> position(mirror.size());
  std::vector<Float4> velocity(mirror.size());
  mirror.mirror_positions(planes, fixture.position.data(), position.data(), pool);
  mirror.mirror_vectors(planes, fixture.velocity.data(), velocity.data(), pool);

  std::vector<Image> found;
  for (std::size_t k = 0; k < position.size(); ++k) {
    const Float4& at = position[k];
    const Float4& u = velocity[k];
    found.push_back({at.x, at.y, at.z, u.x, u.y, u.z, at.w});
  }
  std::sort(found.begin(), found.end());
  const std::vector<Image> expected = fixture.all_images();
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_GT(found.size(), 100U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (std::size_t c = 0; c < 7; ++c) ASSERT_NEAR(found[k][c], expected[k][c], 1e-5) << k << ", " << c;
  }
  // Sorted by cell, as the neighbour search needs it.
  for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
    for (std::uint32_t k = mirror.start()[cell]; k < mirror.start()[cell + 1]; ++k) {
      ASSERT_EQ(grid.index(&position[k].x), cell);
    }
  }
  // A new pressure reaches the images without touching their places.
  std::vector<Float4> changed = fixture.position;
  for (Float4& row : changed) row.w = 10.0F * row.x + row.w;
  const std::vector<Float4> before = position;
  mirror.mirror_pressure(changed.data(), position.data(), pool);
  std::vector<Float4> again(mirror.size());
  mirror.mirror_positions(planes, changed.data(), again.data(), pool);
  for (std::size_t k = 0; k < position.size(); ++k) {
    ASSERT_EQ(position[k].x, before[k].x);
    ASSERT_EQ(position[k].w, again[k].w);
  }
}

TEST(MirrorParticles, AreAllReflectionsWithinReachInThePlane) { expect_all_images<2>(false, 1); }
TEST(MirrorParticles, AreAllReflectionsWithinReachInSpace) { expect_all_images<3>(false, 1); }
TEST(MirrorParticles, AreAllReflectionsWithinReachInANarrowTank) {
  expect_all_images<2>(true, 1);
  expect_all_images<3>(true, 1);
}
TEST(MirrorParticles, AreAllReflectionsWithSeveralThreads) { expect_all_images<3>(false, 3); }

TEST(MirrorParticles, ComeInTheSameOrderWithAnyNumberOfThreads) {
  const Fixture<3> fixture(false);
  const MirrorPlanes<3> planes(fixture.scene);
  const CellGrid<3> grid(fixture.extent);
  const auto positions = [&](int threads) {
    ThreadPool pool(threads);
    CellSort::Workspace workspace;
    MirrorParticles<3> mirror;
    mirror.find(planes, grid, fixture.position.data(), fixture.position.size(), pool, workspace);
    std::vector<Float4> rows(mirror.size());
    mirror.mirror_positions(planes, fixture.position.data(), rows.data(), pool);
    std::vector<std::tuple<float, float, float>> list;
    for (const Float4& row : rows) list.emplace_back(row.x, row.y, row.z);
    return list;
  };
  const auto one = positions(1);
  EXPECT_EQ(one, positions(2));
  EXPECT_EQ(one, positions(3));
}

TEST(MirrorParticles, AreNoneWithoutPlanes) {
  Fixture<3> fixture(false);
  set_all_faces(fixture.scene, {FaceKind::Open, 1.0});
  ThreadPool pool(1);
  CellSort::Workspace workspace;
  MirrorParticles<3> mirror;
  mirror.find(MirrorPlanes<3>(fixture.scene), CellGrid<3>(fixture.extent), fixture.position.data(),
              fixture.position.size(), pool, workspace);
  EXPECT_EQ(mirror.size(), 0U);
}

}  // namespace
}  // namespace eisph
