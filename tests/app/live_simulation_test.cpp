#include "app/view/live_simulation.hpp"

#include "app/simulation_double.hpp"

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include <gmock/gmock.h>

namespace eisph {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

Scene small_scene() {
  Scene scene;
  scene.name = "moving";
  scene.end_time = 1.0;
  scene.particle_spacing = 0.1;
  scene.domain_max = {1.0, 0.2, 0.5};
  scene.output.ledger_interval = 0.25;
  return scene;
}

/// Until it holds; the thread of the simulation takes its time.
void wait_for(const std::function<bool()>& holds) {
  for (int k = 0; k < 2000 && !holds(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_TRUE(holds());
}

class LiveSimulationTest : public testing::Test {
 protected:
  LiveSimulation::Factory maker(double blow_up_time = 1e30) {
    return [this, blow_up_time] {
      auto simulation = std::make_unique<SimulationDouble>(0.01, blow_up_time);
      newest_ = simulation.get();
      ++made_;
      return simulation;
    };
  }
  static double shown_time(LiveSimulation& live) {
    const auto snapshot = live.latest();
    return snapshot != nullptr ? snapshot->time : -1.0;
  }

  SimulationDouble* newest_ = nullptr;
  std::atomic<int> made_ = 0;
};

TEST_F(LiveSimulationTest, StandsAtTheStartUntilItIsTold) {
  LiveSimulation live(small_scene(), maker());
  wait_for([&] { return shown_time(live) == 0.0; });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(live.status().steps, 0U);
  EXPECT_FALSE(live.status().playing);
}

TEST_F(LiveSimulationTest, TakesOneStepAtATime) {
  LiveSimulation live(small_scene(), maker());
  for (const double time : {0.01, 0.02, 0.03}) {
    live.step();
    wait_for([&] { return std::abs(shown_time(live) - time) < 1e-9; });
    EXPECT_FALSE(live.status().playing);
  }
}

TEST_F(LiveSimulationTest, OrdersGivenDuringAStepStand) {
  std::function<void()> during_step;
  LiveSimulation live(small_scene(), [&] {
    auto simulation = std::make_unique<SimulationDouble>(0.01);
    simulation->set_during_step([&] {
      if (during_step) during_step();
    });
    return simulation;
  });
  wait_for([&] { return shown_time(live) == 0.0; });
  // A single step, in which the user presses play; at the time then ordered, another time.
  during_step = [&, step = 0]() mutable {
    ++step;
    if (step == 1) live.run_to(0.1);
    if (step == 10) live.run_to(0.2);
  };
  live.step();
  wait_for([&] { return shown_time(live) == 0.2 && !live.status().playing; });
}

TEST_F(LiveSimulationTest, RunsToATimeExactlyAndThenToTheEnd) {
  LiveSimulation live(small_scene(), maker());
  live.run_to(0.333);
  wait_for([&] { return shown_time(live) == 0.333; });
  wait_for([&] { return !live.status().playing; });
  EXPECT_EQ(live.status().time, 0.333);
  live.play();
  wait_for([&] { return live.status().at_end; });
  wait_for([&] { return shown_time(live) == 1.0; });
  EXPECT_FALSE(live.status().playing);
}

TEST_F(LiveSimulationTest, ThePlotsHaveARowForEveryOutputTime) {
  LiveSimulation live(small_scene(), maker());
  live.play();
  wait_for([&] { return live.status().at_end; });
  const auto plots = live.plots();
  const auto front = std::find_if(plots->begin(), plots->end(),
                                  [](const ProbePlot& plot) { return plot.title == "leading_edge"; });
  ASSERT_NE(front, plots->end());
  EXPECT_THAT(front->x, ElementsAre(0.0, 0.25, 0.5, 0.75, 1.0));
  EXPECT_EQ(live.plots(), plots) << "the same as long as nothing is added";
}

TEST_F(LiveSimulationTest, TakesNoStatesThatNobodyLooksAt) {
  LiveSimulation live(small_scene(), maker());
  wait_for([&] { return live.status().carriers == 1U; });
  live.play();
  wait_for([&] { return live.status().at_end; });
  // One at the start for the viewer and one for the plots, one that was wanted, five output times, the end.
  EXPECT_LE(newest_->snapshots(), 9);
  EXPECT_GT(newest_->steps(), 90U);
}

TEST_F(LiveSimulationTest, RestartsFromTheBeginning) {
  LiveSimulation live(small_scene(), maker());
  live.run_to(0.5);
  wait_for([&] { return shown_time(live) == 0.5; });
  live.restart();
  wait_for([&] { return made_ == 2 && shown_time(live) == 0.0; });
  EXPECT_EQ(live.status().steps, 0U);
  live.run_to(0.2);
  wait_for([&] { return shown_time(live) == 0.2; });
}

TEST_F(LiveSimulationTest, TellsOfABlowUpAndStartsAgainAfterIt) {
  LiveSimulation live(small_scene(), maker(0.5));
  live.play();
  wait_for([&] { return !live.status().message.empty(); });
  EXPECT_THAT(live.status().message, HasSubstr("left the range"));
  EXPECT_FALSE(live.status().playing);
  live.restart();
  wait_for([&] { return made_ == 2 && live.status().message.empty(); });
  live.run_to(0.1);
  wait_for([&] { return shown_time(live) == 0.1; });
}

TEST_F(LiveSimulationTest, HandsTheParametersOver) {
  Scene scene = small_scene();
  scene.artificial_viscosity = 0.02;
  LiveSimulation live(scene, maker());
  RunningParameters parameters = running_parameters(scene);
  EXPECT_EQ(parameters.artificial_viscosity, 0.02);
  parameters.artificial_viscosity = 0.5;
  live.set_parameters(parameters);
  live.run_to(0.1);
  wait_for([&] { return shown_time(live) == 0.1; });
  EXPECT_EQ(newest_->parameters(), parameters);
}

TEST_F(LiveSimulationTest, HandsEveryRecordedStateToTheViewer) {
  LiveSimulation live(small_scene(), maker());
  std::vector<double> times;
  live.record(0.15, [&](const Snapshot& snapshot) { times.push_back(snapshot.time); });
  live.play();
  wait_for([&] {
    static_cast<void>(live.latest());
    return live.status().at_end;
  });
  static_cast<void>(live.latest());
  EXPECT_THAT(times, ElementsAre(DoubleNear(0.15, 1e-9), DoubleNear(0.3, 1e-9), DoubleNear(0.45, 1e-9),
                                 DoubleNear(0.6, 1e-9), DoubleNear(0.75, 1e-9), DoubleNear(0.9, 1e-9)));
}

TEST_F(LiveSimulationTest, EndsWhileItRuns) {
  Scene scene = small_scene();
  scene.end_time = 1e9;
  LiveSimulation live(scene, maker());
  live.record(0.01, [](const Snapshot&) {});  // nobody takes them: the simulation waits
  live.play();
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
}

}  // namespace
}  // namespace eisph
