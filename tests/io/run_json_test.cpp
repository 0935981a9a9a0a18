#include "io/run_json.hpp"

#include "io/temporary_folder.hpp"

#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace eisph {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

RunTimes some_times() {
  const std::chrono::system_clock::time_point start{std::chrono::seconds(1709209800)};
  return {start, start + std::chrono::seconds(75)};
}

json written(const RunSummary& summary, const BuildInfo& build = {}, const HostInfo& host = {}) {
  const TemporaryFolder folder;
  write_run_json(folder / "run.json", summary, build, host, some_times());
  return json::parse(text_of(folder / "run.json"));
}

std::vector<std::string> keys(const json& object) {
  std::vector<std::string> result;
  for (const auto& item : object.items()) result.push_back(item.key());
  return result;
}

TEST(RunJson, HasTheFieldsOfTheSummaryAndTheCircumstancesAtItsTopLevel) {
  EXPECT_THAT(
      keys(written({})),
      UnorderedElementsAre(
          "scene", "scheme", "status", "message", "dimension", "fluid_particles", "object_particles",
          "ghost_particles_max", "threads", "steps", "simulated_time", "time_step_mean", "wall_time_loop",
          "cpu_time_loop", "wall_time_initial_pressure", "particle_steps_per_second", "pair_evaluations",
          "pressure_iterations_mean", "cpu_time_total", "stage_ns_per_particle_step",
          "state_bytes_per_particle", "state_bytes_by_array", "peak_rss_bytes", "penetrations",
          "lost_particles", "outflow_particles", "outflow_volume", "compression_max", "compression_p95",
          "paired_fraction_max", "paired_fraction_final", "nearest_distance_p5_min",
          "nearest_distance_p5_final", "isolated_particles_max", "isolated_particles_final",
          "isolated_fraction_max", "isolated_fraction_final", "energy_initial", "energy_final",
          "energy_gain_max", "mass_error", "frames_written", "frames_dropped", "frames_drawn_by", "version",
          "build", "host", "started", "finished"));
}

TEST(RunJson, GivesEachFieldItsOwnValue) {
  RunSummary summary;
  summary.scene = "ritter";
  summary.status = "blown_up";
  summary.dimension = 2;
  summary.fluid_particles = 144000;
  summary.steps = 5400;
  summary.simulated_time = 5.4;
  summary.time_step_mean = 1e-3;
  summary.stage_ns_per_particle_step = {{"neighbours", 180.5}, {"gradient", 105.0}};
  summary.state_bytes_by_array = {{"position", 1.5e6}};
  summary.peak_rss_bytes = 12345678901;
  summary.compression_p95 = 0.0005;
  summary.paired_fraction_max = 0.15;
  summary.isolated_particles_final = 7;
  summary.energy_gain_max = -0.25;
  summary.frames_written = 5;
  summary.frames_dropped = 2;
  const json run = written(summary);
  EXPECT_EQ(run["scene"], "ritter");
  EXPECT_EQ(run["status"], "blown_up");
  EXPECT_EQ(run["dimension"], 2);
  EXPECT_EQ(run["fluid_particles"], 144000);
  EXPECT_EQ(run["steps"], 5400);
  EXPECT_EQ(run["simulated_time"], 5.4);
  EXPECT_EQ(run["time_step_mean"], 1e-3);
  EXPECT_EQ(run["stage_ns_per_particle_step"], json({{"neighbours", 180.5}, {"gradient", 105.0}}));
  EXPECT_EQ(run["state_bytes_by_array"], json({{"position", 1.5e6}}));
  EXPECT_EQ(run["peak_rss_bytes"], 12345678901);
  EXPECT_EQ(run["compression_p95"], 0.0005);
  EXPECT_EQ(run["paired_fraction_max"], 0.15);
  EXPECT_TRUE(run["paired_fraction_final"].is_null());
  EXPECT_EQ(run["isolated_particles_final"], 7);
  EXPECT_EQ(run["energy_gain_max"], -0.25);
  EXPECT_EQ(run["frames_written"], 5);
  EXPECT_EQ(run["frames_dropped"], 2);
}

TEST(RunJson, GivesMapsWithoutEntriesAsObjects) {
  EXPECT_TRUE(written({})["stage_ns_per_particle_step"].is_object());
}

TEST(RunJson, TellsBuildHostAndTimes) {
  const BuildInfo build{"0.1.0", "GCC 12.2.0", "Release", "-O3", "AVX2", "abc123"};
  const HostInfo host{"node", "Some CPU", 2, 17179869184, "Linux"};
  const json run = written({}, build, host);
  EXPECT_EQ(run["version"], "0.1.0");
  EXPECT_EQ(run["build"], json({{"compiler", "GCC 12.2.0"},
                                {"type", "Release"},
                                {"flags", "-O3"},
                                {"instruction_set", "AVX2"},
                                {"commit", "abc123"}}));
  EXPECT_EQ(run["host"], json({{"name", "node"},
                               {"cpu_model", "Some CPU"},
                               {"cores", 2},
                               {"memory_bytes", 17179869184},
                               {"os", "Linux"}}));
  EXPECT_EQ(run["started"], "2024-02-29T12:30:00Z");
  EXPECT_EQ(run["finished"], "2024-02-29T12:31:15Z");
}

TEST(RunJson, LeavesAnUnknownCommitOut) { EXPECT_FALSE(written({})["build"].contains("commit")); }

TEST(RunJson, StaysValidForNotANumberAndBytesThatAreNoText) {
  RunSummary summary;
  summary.mass_error = std::numeric_limits<double>::quiet_NaN();
  summary.message = "bad \xff byte";
  const json run = written(summary);
  EXPECT_TRUE(run["mass_error"].is_null());
  EXPECT_THAT(run["message"].get<std::string>(), HasSubstr("bad "));
}

TEST(RunJson, NamesThePathThatCannotBeWritten) {
  const TemporaryFolder folder;
  const auto path = folder / "missing" / "run.json";
  EXPECT_THAT(error_of<std::runtime_error>([&] { write_run_json(path, {}, {}, {}, some_times()); }),
              HasSubstr(path.string()));
}

TEST(CompiledBuildInfo, NamesCompilerAndInstructionSet) {
  EXPECT_THAT(compiled_build_info().compiler, testing::AnyOf(HasSubstr("GCC 1"), HasSubstr("Clang ")));
  EXPECT_FALSE(compiled_build_info().instruction_set.empty());
}

}  // namespace
}  // namespace eisph
