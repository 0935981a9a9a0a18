#include "app/saved_states.hpp"

#include "app/record_stage.hpp"
#include "app/simulation_double.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"
#include "io/vtk_output.hpp"
#include "probe/depth_grid.hpp"
#include "probe/nearest_neighbours.hpp"

#include <gmock/gmock.h>

namespace eisph {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

Scene small_scene() {
  Scene scene;
  scene.particle_spacing = 0.1;
  scene.domain_max = {1.0, 1.0, 1.0};
  scene.output.particles.interval = 0.1;
  return scene;
}

/// The state of the double at `time`, with as many object particles as given.
std::shared_ptr<const Snapshot> state_at(double time, std::size_t objects) {
  SimulationDouble simulation(1.0);
  if (time > 0.0) simulation.step(time);
  Snapshot state = *simulation.snapshot();
  auto solids = std::make_shared<ObjectParticles>();
  solids->position.assign(objects, Vec3f(0.5F, 0.5F, 0.5F));
  solids->pressure.assign(objects, 7.0F);
  solids->spacing = 0.1F;
  state.objects = solids;
  return std::make_shared<Snapshot>(std::move(state));
}

TEST(SavedStates, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path()};
  RecordStage stage(small_scene(), files);
  DueOutputs due;
  due.particles = true;
  stage.write({state_at(0.0, 3), due});
  stage.write({state_at(0.1, 2), due});
  stage.write({state_at(0.2, 0), due});

  const std::vector<SavedState> states = saved_states(files);
  ASSERT_THAT(states, SizeIs(3));
  EXPECT_EQ(states[1].time, 0.1);
  const Snapshot state = read_state(states[1]);
  EXPECT_EQ(state.time, 0.1);
  EXPECT_EQ(state.position, state_at(0.1, 2)->position);
  EXPECT_THAT(state.objects->position, SizeIs(2));
  EXPECT_EQ(state.objects->pressure[0], 7.0F);
  EXPECT_THAT(read_state(states[0]).objects->position, SizeIs(3));
  EXPECT_THAT(read_state(states[2]).objects->position, SizeIs(0));
}

TEST(SavedStates, GiveTheDepthAndTheDistancesOfTheRun) {
  Scene scene = small_scene();
  scene.output.depth.interval = 0.1;
  Snapshot water = *state_at(0.0, 0);
  water.particle_mass = 1.0;
  water.id = {0, 1, 2, 3};
  water.position = {{0.05F, 0.05F, 0.05F}, {0.05F, 0.05F, 0.1F}, {0.05F, 0.05F, 0.75F}, {0.55F, 0.5F, 0.05F}};
  water.velocity.assign(4, Vec3f::Zero());
  water.pressure.assign(4, 0.0F);
  water.number_density = {1.0F, 0.75F, 0.14F, 0.2F};
  const TemporaryFolder folder;
  const RunFiles files{folder.path()};
  RecordStage stage(scene, files);
  DueOutputs due;
  due.particles = true;
  due.depth = true;
  stage.write({std::make_shared<Snapshot>(water), due});

  const Snapshot state = read_state(saved_states(files).at(0));
  EXPECT_EQ(state.number_density, water.number_density);
  const DepthGrid written = read_depth(files.depth(0));
  EXPECT_EQ(DepthGridBuilder(scene).build(state).depth, written.depth);
  EXPECT_EQ(written.at(0, 0), 0.1F) << "without the drop above it";
  EXPECT_EQ(written.at(3, 3), 0.05F) << "the drop on the floor";
  const NeighbourDistances distances = neighbour_distances(state);
  EXPECT_EQ(distances.paired_fraction, stage.neighbours().last.paired_fraction);
  EXPECT_EQ(distances.paired_fraction, 0.5);
  EXPECT_EQ(stage.neighbours().last.isolated_particles, 2U);
}

TEST(SavedStates, ShareOneFileOfObjectsThatHaveNotChanged) {
  const TemporaryFolder folder;
  const RunFiles files{folder.path()};
  RecordStage stage(small_scene(), files);
  DueOutputs due;
  due.particles = true;
  const auto first = state_at(0.0, 3);
  Snapshot later = *state_at(0.1, 0);
  later.objects = first->objects;
  stage.write({first, due});
  stage.write({std::make_shared<Snapshot>(later), due});
  const std::vector<SavedState> states = saved_states(files);
  EXPECT_EQ(states[0].objects, states[1].objects);
  EXPECT_FALSE(std::filesystem::exists(files.objects(1)));
}

TEST(SavedStates, OfARunWithoutAnyAreAnError) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of<InputError>([&] { (void)saved_states({folder.path()}); }),
              HasSubstr("holds no saved states"));
}

TEST(SelectedStates, AreAllOfThemUnlessTimesAreGiven) {
  const std::vector<SavedState> states = {{0.0, "a", ""}, {0.1, "b", ""}, {0.2, "c", ""}};
  EXPECT_THAT(select_states(states, {}), SizeIs(3));
  const std::vector<SavedState> selected = select_states(states, {0.2, 0.0004, 0.2});
  ASSERT_THAT(selected, SizeIs(2));
  EXPECT_EQ(selected[0].particles, "a");
  EXPECT_EQ(selected[1].particles, "c");
}

TEST(SelectedStates, HaveToBeNearTheTimeAskedFor) {
  const std::vector<SavedState> states = {{0.0, "a", ""}, {0.1, "b", ""}};
  EXPECT_THAT(error_of<InputError>([&] { (void)select_states(states, {0.13}); }),
              HasSubstr("--time 0.13: no state is saved there; the nearest is at 0.1 s"));
}

}  // namespace
}  // namespace eisph
