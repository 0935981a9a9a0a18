#include "io/peer_file.hpp"

#include "io/schema_table.hpp"

#include <cstddef>

#include <fmt/format.h>

namespace eisph {

namespace {

KeyTable<PeerState> state_keys() {
  KeyTable<PeerState> keys;
  keys.number("time", "s", &PeerState::time, at_least(0.0), "From the release.").required();
  keys.path("file", &PeerState::file, "Table of the state.").required();
  return keys;
}

KeyTable<PeerRun> peer_keys() {
  KeyTable<PeerRun> keys;
  keys.string("case", &PeerRun::flow, "Case of eisph pareto.").required();
  keys.string("scheme", &PeerRun::scheme, "Program and scheme.").required();
  keys.string("setting", &PeerRun::setting, "What tells runs of a scheme apart.");
  keys.number("spacing", "m", &PeerRun::spacing, above(0.0), "Of particles or cells.").required();
  keys.integer("particles", "", &PeerRun::particles, between(1.0, 1e12), "Particles or cells.")
      .fallback("the rows of the last state");
  keys.integer("steps", "", &PeerRun::steps, between(1.0, 1e12), "Time steps.").required();
  keys.number("cpu_time", "s", &PeerRun::cpu_time, above(0.0), "CPU time of the time loop.").required();
  keys.list("state", &PeerRun::states, state_keys(), "A state of the run.");
  return keys;
}

}  // namespace

PeerRun load_peer_run(const std::filesystem::path& file) {
  TomlSource source(file, {}, {.expected = "a description of a run (TOML)", .example = "steps=100"});
  PeerRun run;
  run.source_file = file;
  SectionReader reader{.source = source, .dimension = 2};
  peer_keys().read(reader, "", source.root(), run);
  if (run.states.empty()) source.fail("state", "missing; expected at least one section [[state]]");
  for (std::size_t k = 0; k < run.states.size(); ++k) {
    PeerState& state = run.states[k];
    if (k > 0 && state.time <= run.states[k - 1].time) {
      source.fail(
          fmt::format("state.{}.time", k),
          fmt::format("expected more than {} s, the time of the state before", run.states[k - 1].time));
    }
    source.resolve_file(state.file, fmt::format("state.{}.file", k));
  }
  return run;
}

}  // namespace eisph
