#include "app/pareto/peer_runs.hpp"

#include "app/case_choice.hpp"
#include "compare/ritter.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace eisph {
namespace {

using testing::AllOf;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kEnd = 0.02;

const ParetoCase& known_case(const std::string& name) {
  return *choose_cases("test", pareto_cases(), {name}).front();
}

/// Water at rest for 20 ms at the coarsest spacing: its pressure, and its leading edge in m.
ParetoCase small_case() {
  ParetoCase small = known_case("still_water");
  small.quick_spacings = {0.05};
  small.quick_end = kEnd;
  small.errors.push_back(
      {"edge", "place of the leading edge", [](const ValidationRun& run, const ValidationRun*) {
         return run.table("leading_edge").column("bulk_front").back();
       }});
  return small;
}

std::string particles_csv(const Snapshot& state) {
  std::string text = "x [m],z [m],velocity_x [m/s],velocity_z [m/s],pressure [Pa]\n";
  for (std::size_t k = 0; k < state.size(); ++k) {
    text += fmt::format("{},{},{},{},{}\n", state.position[k].x(), state.position[k].z(),
                        state.velocity[k].x(), state.velocity[k].z(), state.pressure[k]);
  }
  return text;
}

std::string peer_toml(const std::string& flow, double spacing, double end) {
  return fmt::format(
      "case = \"{}\"\nscheme = \"Other\"\nspacing = {}\nsteps = 40\ncpu_time = 0.5\n[[state]]\ntime = "
      "{}\nfile = "
      "\"state.csv\"\n",
      flow, spacing, end);
}

class PeerRuns : public testing::Test {
 protected:
  [[nodiscard]] Validator validator() {
    return {{folder_ / "report", 1, false, true}, out_, [] { return false; }};
  }
  std::string complaint(const ParetoCase& chosen) const {
    return error_of<InputError>(
        [&] { static_cast<void>(find_peer_runs(folder_ / "peers", {&chosen}, false)); });
  }
  void put_peer(const std::string& toml, const std::string& state) const {
    std::filesystem::create_directories(folder_ / "peers" / "one");
    put_text(folder_ / "peers" / "one" / "peer.toml", toml);
    put_text(folder_ / "peers" / "one" / "state.csv", state);
  }

  TemporaryFolder folder_;
  std::ostringstream out_;
};

TEST_F(PeerRuns, AreMeasuredAsTheProgramsOwn) {
  const ParetoCase small = small_case();
  Validator runs = validator();
  runs.begin_case("still_water");
  const ValidationRun own =
      runs.run({.scene = "still_water",
                .label = "own",
                .overrides = {"particles.spacing=0.05", fmt::format("end_time={}", kEnd)},
                .states = {kEnd}});
  put_peer(peer_toml("still_water", 0.05, kEnd), particles_csv(own.state(kEnd)));

  const std::vector<PeerRun> peers = find_peer_runs(folder_ / "peers", {&small}, false);
  const ParetoResult result = study(small, choose_settings({"EISPH, phi 0.17"}), 1, runs, peers);
  const ParetoPoint& peer = result.points.back();
  EXPECT_EQ(peer.scheme, "Other");
  EXPECT_EQ(peer.particles, own.summary.fluid_particles);
  EXPECT_DOUBLE_EQ(peer.cpu_time(), 0.5 / kEnd);
  EXPECT_DOUBLE_EQ(peer.time_step, kEnd / 40.0);
  EXPECT_TRUE(std::isnan(peer.pair_evaluations));
  EXPECT_THAT(peer.errors, ElementsAre(DoubleNear(small.errors[0].evaluate(own, nullptr), 1e-6),
                                       DoubleNear(small.errors[1].evaluate(own, nullptr), 1e-6)));

  write_pareto_case(folder_ / "report", result);
  write_pareto_report(folder_ / "report", {result}, "test");
  const auto json = nlohmann::json::parse(text_of(folder_ / "report" / "pareto.json"));
  EXPECT_TRUE(json["cases"][0]["points"].back()["pair_evaluations"].is_null());
  EXPECT_THAT(text_of(folder_ / "report" / "still_water.csv"), HasSubstr("\"Other\",\"\",0.05,"));
}

TEST_F(PeerRuns, ColumnsOfWaterHaveAProfileAndAFront) {
  const ParetoCase& ritter = known_case("ritter_long");
  const RitterSolution exact(0.1);
  const double end = ritter.quick_end;
  std::string text = "x [m],depth [m]\n";
  for (int k = 0; k < 320; ++k) {  // the last centimetres of the tank are not told: dry
    const double x = 0.01 * (k + 0.5);
    text += fmt::format("{},{}\n", x, exact.depth(x - 1.5, end));
  }
  put_peer(peer_toml("ritter_long", 0.01, end), text);
  const auto peers = find_peer_runs(folder_ / "peers", {&ritter}, false);
  const ParetoPoint point = measure_peer(peers.front(), ritter, nullptr, folder_ / "tables");
  EXPECT_EQ(point.particles, 330U);
  EXPECT_LT(point.errors.front(), 0.6) << "the error of cells of 10 mm";
  EXPECT_TRUE(std::filesystem::exists(folder_ / "tables" / "front_front.csv"));
}

TEST_F(PeerRuns, AreReadInSpace) {
  Scene scene;
  scene.particle_spacing = 0.1;
  scene.domain_max = {1.0, 1.0, 1.0};
  put_text(folder_ / "state.csv",
           "x [m],y [m],z [m],velocity_x [m/s],velocity_y [m/s],velocity_z [m/s],pressure [Pa]\n"
           "0.25,0.5,0.75,1,2,3,4\n");
  const Snapshot state = read_peer_state(scene, {0.5, folder_ / "state.csv"});
  EXPECT_EQ(state.time, 0.5);
  EXPECT_EQ(state.position.front(), Vec3f(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(state.velocity.front(), Vec3f(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(state.pressure.front(), 4.0F);
  // A particle alone: the middle of its own cube, (2/3)^3.
  EXPECT_NEAR(state.number_density.front(), 8.0 / 27.0, 1e-5);
  put_text(folder_ / "state.csv", "x [m],depth [m]\n0.05,0.1\n");
  EXPECT_THAT(error_of<InputError>([&] {
                static_cast<void>(read_peer_state(scene, {0.5, folder_ / "state.csv"}));
              }),
              HasSubstr("two dimensions"));
}

TEST_F(PeerRuns, WithTooFewStatesForAnErrorAreNamed) {
  ParetoCase column = known_case("martin_moyce");
  column.errors.resize(1);  // without the one that takes a reference run
  put_peer(peer_toml("martin_moyce", 0.0047625, column.quick_end),
           "x [m],z [m],velocity_x [m/s],velocity_z [m/s],pressure [Pa]\n0.1,0.002,0,0,0\n");
  const auto peers = find_peer_runs(folder_ / "peers", {&column}, false);
  EXPECT_THAT(error_of<InputError>([&] {
                static_cast<void>(measure_peer(peers.front(), column, nullptr, folder_ / "tables"));
              }),
              AllOf(HasSubstr("peer.toml"), HasSubstr("\"front\"")));
}

TEST_F(PeerRuns, ThatCannotBeUsedAreRefusedBeforeAnythingRuns) {
  const ParetoCase small = small_case();
  EXPECT_THAT(complaint(small), AllOf(HasSubstr("--peers"), HasSubstr("peer.toml")));
  const std::string state = "x [m],z [m],velocity_x [m/s],velocity_z [m/s],pressure [Pa]\n0.1,0.1,0,0,0\n";
  put_peer(peer_toml("ritter_long", 0.05, kEnd), state);
  EXPECT_THAT(complaint(small), AllOf(HasSubstr("ritter_long"), HasSubstr("still_water")));
  put_peer(peer_toml("still_water", 0.05, 0.5 * kEnd), state);
  EXPECT_THAT(complaint(small), AllOf(HasSubstr("state.0.time = 0.01"), HasSubstr("0.02 s")));
  put_peer(peer_toml("still_water", 0.05, kEnd),
           "x [m],z [m],velocity_x [m/s],velocity_z [m/s]\n0.1,0.1,0,0\n");
  EXPECT_THAT(complaint(small), AllOf(HasSubstr("state.csv"), HasSubstr("pressure")));
  put_peer(peer_toml("still_water", 0.05, kEnd), state + "0.2,,0,0,0\n");
  EXPECT_THAT(complaint(small), AllOf(HasSubstr("state.csv"), HasSubstr("row 2"), HasSubstr("z")));
  put_peer(peer_toml("still_water", 0.05, kEnd), "x [m],depth [m]\n0.1,0.3\n0.2,0.3\n");
  EXPECT_THAT(complaint(small), AllOf(HasSubstr("row 2"), HasSubstr("0.3")));
  put_peer(peer_toml("still_water", 0.05, kEnd), state);
  EXPECT_EQ(complaint(small), "");
}

}  // namespace
}  // namespace eisph
