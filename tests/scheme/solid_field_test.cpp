#include "scheme/solid_field.hpp"

#include "scheme/scenes.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace eisph {
namespace {

constexpr double kSpacing = 0.01;

/// A system with its neighbours found, as at the beginning of a step.
template <int Dim>
std::unique_ptr<ParticleSystem<Dim>> placed(const Scene& scene) {
  auto particles = std::make_unique<ParticleSystem<Dim>>(scene, 2);
  particles->sort_fluid();
  particles->place_boundaries(0.0);
  particles->find_neighbours();
  return particles;
}

template <int Dim>
Vec3d place_of(const ParticleSystem<Dim>& particles, std::uint32_t row) {
  std::array<double, Dim> at;
  for (int d = 0; d < Dim; ++d) at[d] = particles.h * (&particles.table.position[row].x)[d];
  return particles.scene_vector(at);
}

template <int Dim, class Field>
void set_pressures(ParticleSystem<Dim>& particles, const Field& field) {
  for (std::uint32_t i = 0; i < particles.fluid; ++i) {
    const std::uint32_t row = particles.fluid_row(i);
    const auto pressure = static_cast<float>(field(place_of(particles, row)));
    particles.carried[i] = pressure;
    particles.table.position[row].w = pressure;
  }
  particles.mirror_pressure();
}

/// Water beside a wall of eight spacings and on a floor of four, both of object particles.
template <int Dim>
Scene beside_wall_and_floor(bool wall, double jitter = 0.2) {
  const double width = Dim == 2 ? 0.0 : 0.2;
  Scene scene =
      tank(Dim, Vec3d(0.3, width, 0.3), kSpacing, box(Vec3d(0.0, 0.0, 0.04), Vec3d(0.22, width, 0.24)));
  scene.jitter = jitter;
  scene.boundary.object_no_slip = false;
  if (wall) {
    scene.fluid[0].shape.min.z() = 0.0;
    scene.obstacles.push_back({"wall", box(Vec3d(0.22, 0.0, 0.0), Vec3d(0.3, width, 0.3))});
  } else {
    scene.fluid[0].shape.max.x() = 0.3;
    scene.obstacles.push_back({"floor", box(Vec3d(0.0, 0.0, 0.0), Vec3d(0.3, width, 0.04))});
  }
  return scene;
}

/// Objects with water all about the place before them, visited with their row and place.
template <int Dim, class Body>
int for_well_wetted(const ParticleSystem<Dim>& particles, const Body& body) {
  int visited = 0;
  for (std::size_t k = 0; k < particles.objects(); ++k) {
    const std::uint32_t row = particles.object_row(k);
    const Vec3d at = place_of(particles, row);
    const bool inside = at.z() > (at.x() > 0.22 && at.z() > 0.04 ? 0.04 : -1.0) && at.z() < 0.2;
    const bool off_sides = Dim == 2 || (at.y() > 0.04 && at.y() < 0.16);
    if (!particles.neighbours.is_wet(row) || !inside || !off_sides) continue;
    body(k, row, at);
    ++visited;
  }
  return visited;
}

template <int Dim>
void expect_linear_field_beside_a_wall() {
  const auto particles = placed<Dim>(beside_wall_and_floor<Dim>(true));
  SolidField<Dim> solids(*particles);
  // Whatever the gradient along the wall is; across it nothing changes, as gravity has no part there.
  const auto field = [](const Vec3d& at) { return 5000.0 - 7000.0 * at.z() + 3000.0 * at.y(); };
  set_pressures(*particles, field);
  solids.find_weights();
  solids.extrapolate();
  const int visited = for_well_wetted(*particles, [&](std::size_t k, std::uint32_t row, const Vec3d& at) {
    // The second layer sees one column of water, three particles of which have weight: these do not spread.
    if (at.x() > 0.23) return;
    ASSERT_NEAR(particles->table.position[row].w, field(at), 0.5) << at.transpose();
    ASSERT_EQ(particles->kept_object_pressure(k), particles->table.position[row].w);
  });
  EXPECT_GT(visited, 30);
}

TEST(SolidField, ContinuesALinearPressureAlongAWall) {
  expect_linear_field_beside_a_wall<2>();
  expect_linear_field_beside_a_wall<3>();
}

TEST(SolidField, ContinuesTheWeightOfTheWaterIntoAFloor) {
  const auto particles = placed<2>(beside_wall_and_floor<2>(false));
  SolidField<2> solids(*particles);
  const auto field = [](const Vec3d& at) { return kDensity * kGravity * (0.24 - at.z()) + 2000.0 * at.x(); };
  set_pressures(*particles, field);
  solids.find_weights();
  solids.extrapolate();
  int visited = 0;
  for (std::size_t k = 0; k < particles->objects(); ++k) {
    const std::uint32_t row = particles->object_row(k);
    const Vec3d at = place_of(*particles, row);
    if (at.z() < 0.03 || at.x() < 0.04 || at.x() > 0.26) continue;
    ASSERT_NEAR(particles->table.position[row].w, field(at), 0.5) << at.transpose();
    ++visited;
  }
  EXPECT_GT(visited, 20);
}

TEST(SolidField, TheLinearPartAndTheRiseAddUp) {
  const auto particles = placed<2>(beside_wall_and_floor<2>(false));
  SolidField<2> solids(*particles);
  set_pressures(*particles, [](const Vec3d& at) { return 1000.0 + 300.0 * std::sin(20.0 * at.x()); });
  solids.find_weights();
  solids.extrapolate_unclamped();
  std::vector<float> whole;
  for (std::size_t k = 0; k < particles->objects(); ++k) {
    whole.push_back(particles->table.position[particles->object_row(k)].w);
  }
  solids.extrapolate_linear();
  std::vector<float> linear;
  for (std::size_t k = 0; k < particles->objects(); ++k) {
    linear.push_back(particles->table.position[particles->object_row(k)].w);
  }
  set_pressures(*particles, [](const Vec3d&) { return 0.0; });
  solids.extrapolate_unclamped();
  for (std::size_t k = 0; k < particles->objects(); ++k) {
    const float rise = particles->table.position[particles->object_row(k)].w;
    ASSERT_NEAR(whole[k], linear[k] + rise, 1e-2);
  }
}

TEST(SolidField, TwiceIsOnceWithAndOnceWithoutTheCorrection) {
  const auto particles = placed<3>(beside_wall_and_floor<3>(true));
  SolidField<3> solids(*particles);
  solids.find_weights();
  set_pressures(*particles, [](const Vec3d& at) { return 4000.0 - 9810.0 * at.z() + 500.0; });
  for (std::uint32_t i = 0; i < particles->fluid; ++i) particles->carried[i] -= 500.0F;
  solids.extrapolate_twice();
  for_well_wetted(*particles, [&](std::size_t k, std::uint32_t row, const Vec3d&) {
    ASSERT_NEAR(particles->table.position[row].w - particles->kept_object_pressure(k), 500.0, 0.1);
  });
}

TEST(SolidField, MirrorsTheVelocityAcrossTheWallAndContinuesItAlong) {
  Scene scene = beside_wall_and_floor<2>(true);
  scene.fluid[0].velocity = Vec3d(0.5, 0.0, 2.0);
  const auto particles = placed<2>(scene);
  SolidField<2> solids(*particles);
  solids.find_weights();
  solids.set_velocities();
  solids.set_sources(3.0, 0.01);
  const int visited = for_well_wetted(*particles, [&](std::size_t, std::uint32_t row, const Vec3d&) {
    const Float4& velocity = particles->table.velocity[row];
    ASSERT_NEAR(velocity.x, -0.5, 1e-5);
    ASSERT_NEAR(velocity.y, 2.0, 1e-5);
    EXPECT_EQ(velocity.w, 0.0F) << "slips: no part in the viscous sum";
    const Float4& source = particles->table.source[row];
    ASSERT_NEAR(source.x, -1.5, 1e-5);
    ASSERT_NEAR(source.y, 6.0 - 0.01 * kGravity, 1e-5);
  });
  EXPECT_GT(visited, 30);
}

TEST(SolidField, WithNoSlipSolidsHaveTheirOwnVelocity) {
  Scene scene = beside_wall_and_floor<2>(true);
  scene.fluid[0].velocity = Vec3d(0.5, 0.0, 2.0);
  scene.boundary.object_no_slip = true;
  const auto particles = placed<2>(scene);
  SolidField<2> solids(*particles);
  solids.find_weights();
  solids.set_velocities();
  for_well_wetted(*particles, [&](std::size_t, std::uint32_t row, const Vec3d&) {
    EXPECT_EQ(particles->table.velocity[row].x, 0.0F);
    EXPECT_EQ(particles->table.velocity[row].y, 0.0F);
    EXPECT_GT(particles->table.velocity[row].w, 0.0F);
  });
}

/// Water on both sides of a wall of `layers` spacings.
Scene both_sides(int layers) {
  const double thickness = layers * kSpacing;
  Scene scene = tank(2, Vec3d(0.3, 0.0, 0.3), kSpacing, box(Vec3d::Zero(), Vec3d(0.1, 0.0, 0.2)));
  FluidRegion right = scene.fluid[0];
  right.shape = box(Vec3d(0.1 + thickness, 0.0, 0.0), Vec3d(0.3, 0.0, 0.2));
  scene.fluid.push_back(right);
  scene.obstacles.push_back({"wall", box(Vec3d(0.1, 0.0, 0.0), Vec3d(0.1 + thickness, 0.0, 0.3))});
  return scene;
}

TEST(SolidField, PressureDoesNotActThroughAThinWall) {
  for (const int layers : {2, 3, 4}) {
    const auto particles = placed<2>(both_sides(layers));
    ASSERT_TRUE(particles->solids.has_thin_solids());
    SolidField<2> solids(*particles);
    set_pressures(*particles, [](const Vec3d& at) { return at.x() < 0.1 ? 100.0 : 700.0; });
    solids.find_weights();
    solids.extrapolate();
    const auto pressure = [&](std::uint32_t row) { return particles->table.position[row].w; };
    for (std::uint32_t i = 0; i < particles->fluid; ++i) {
      const std::uint32_t row = particles->fluid_row(i);
      const Neighbours near = particles->neighbours.of(row);
      if (!near.near_object) continue;
      double volume = 0.0;
      for (const std::uint32_t* j = near.begin; j != near.end; ++j) {
        if (*j == SourceTable::kNothing) continue;
        if (*j < particles->table.first_fluid) volume += particles->table.source[*j].w;
        ASSERT_NEAR(pressure(*j), pressure(row), 1e-2) << layers << " layers";
      }
      EXPECT_GT(volume, 0.0) << "it still sees the wall";
    }
  }
}

TEST(SolidField, AThinWallIsAsDenseAsAThickOne) {
  // Each place in the wall counts once for the water before it.
  for (const int layers : {3, 4}) {
    const auto particles = placed<2>(both_sides(layers));
    for (std::uint32_t i = 0; i < particles->fluid; ++i) {
      const std::uint32_t row = particles->fluid_row(i);
      const Vec3d at = place_of(*particles, row);
      if (std::abs(at.x() - 0.095) > 1e-6 || at.z() < 0.05 || at.z() > 0.15) continue;
      const Neighbours near = particles->neighbours.of(row);
      double sum = particles->own_number_density();
      with_kernel(particles->scene.kernel, [&](auto kernel) {
        for (const std::uint32_t* j = near.begin; j != near.end; ++j) {
          if (*j == SourceTable::kNothing) continue;
          const double q = (place_of(*particles, *j) - at).norm() / particles->h;
          const double volume =
              *j < particles->table.first_fluid ? particles->table.source[*j].w : particles->volume;
          sum += volume * particles->alpha * decltype(kernel)::value(q);
        }
      });
      EXPECT_NEAR(sum / particles->lattice.number_density, 1.0, layers == 4 ? 1e-3 : 0.02);
    }
  }
}

}  // namespace
}  // namespace eisph
