#include "app/pareto/peer_runs.hpp"

#include "compare/number_table.hpp"
#include "core/assets.hpp"
#include "core/error.hpp"
#include "io/csv_table.hpp"
#include "io/peer_file.hpp"
#include "io/scene_file.hpp"
#include "probe/fluid_field.hpp"
#include "probe/probe_set.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

/// How far the end of a run may be from that of the case, s.
constexpr double kEndTolerance = 1e-6;
/// How far cells may be from equal ones, in their width.
constexpr double kCellTolerance = 0.01;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

float to_float(double value) { return static_cast<float>(value); }

/// Values without gaps.
const std::vector<double>& complete_column(const NumberTable& table, const std::string& name) {
  const std::vector<double>& values = table.column(name);
  const auto gap = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  if (gap != values.end()) {
    throw InputError(
        fmt::format("{}: row {} has no finite {}", table.path.string(), gap - values.begin() + 1, name));
  }
  return values;
}

std::shared_ptr<const ColumnField> columns_of(const Scene& scene, const NumberTable& table) {
  if (scene.dimension == 3) {
    throw InputError(fmt::format("{}: depth: columns of water are for two dimensions; expected particles",
                                 table.path.string()));
  }
  const std::vector<double>& x = complete_column(table, "x");
  const std::vector<double>& depth = complete_column(table, "depth");
  auto field = std::make_shared<ColumnField>();
  const double start = scene.domain_min.x();
  field->cell_size = x.empty() ? 0.0 : 2.0 * (x.front() - start);
  if (!(field->cell_size > 0.0)) {
    throw InputError(
        fmt::format("{}: x: expected a first cell that begins at {} m", table.path.string(), start));
  }
  field->origin_x = start;
  field->origin_y = -0.5 * field->cell_size;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double centre = start + (static_cast<double>(k) + 0.5) * field->cell_size;
    if (std::abs(x[k] - centre) <= kCellTolerance * field->cell_size) continue;
    throw InputError(
        fmt::format("{}: row {}: x = {} m: expected cells of {} m from {} m on, this one at {} m",
                    table.path.string(), k + 1, x[k], field->cell_size, start, centre));
  }
  // What is not told is dry.
  const double cells = (scene.domain_max.x() - start) / field->cell_size;
  field->columns = std::max(x.size(), static_cast<std::size_t>(std::ceil(cells - kCellTolerance)));
  field->rows = 1;
  field->bed.assign(field->columns, 0.0F);
  field->velocity_x.assign(field->columns, 0.0F);
  field->velocity_y.assign(field->columns, 0.0F);
  field->depth.assign(field->columns, 0.0F);
  std::transform(depth.begin(), depth.end(), field->depth.begin(), to_float);
  return field;
}

void read_particles(const NumberTable& table, Snapshot& snapshot) {
  const std::vector<double>& x = complete_column(table, "x");
  const std::vector<double>& z = complete_column(table, "z");
  const bool in_space = snapshot.dimension == 3;
  const std::vector<double> zeros(in_space ? 0 : x.size());
  const std::vector<double>& y = in_space ? complete_column(table, "y") : zeros;
  const std::vector<double>& velocity_x = complete_column(table, "velocity_x");
  const std::vector<double>& velocity_y = in_space ? complete_column(table, "velocity_y") : zeros;
  const std::vector<double>& velocity_z = complete_column(table, "velocity_z");
  const std::vector<double>& pressure = complete_column(table, "pressure");
  snapshot.id.reserve(x.size());
  snapshot.position.reserve(x.size());
  snapshot.velocity.reserve(x.size());
  snapshot.pressure.reserve(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    snapshot.id.push_back(static_cast<std::uint32_t>(k));
    snapshot.position.emplace_back(to_float(x[k]), to_float(y[k]), to_float(z[k]));
    snapshot.velocity.emplace_back(to_float(velocity_x[k]), to_float(velocity_y[k]), to_float(velocity_z[k]));
    snapshot.pressure.push_back(to_float(pressure[k]));
  }
}

Scene scene_of(const PeerRun& peer, const ParetoCase& chosen) {
  return load_scene(shipped_scene(chosen.scene),
                    {fmt::format("particles.spacing={:.17g}", peer.spacing),
                     fmt::format("end_time={:.17g}", peer.states.back().time), "output.times=[]"});
}

/// Finds out now what would fail after hours of runs.
void check(const PeerRun& peer, const std::vector<const ParetoCase*>& cases, bool full) {
  const std::string file = peer.source_file.string();
  const auto found = std::find_if(cases.begin(), cases.end(),
                                  [&](const ParetoCase* known) { return known->name == peer.flow; });
  if (found == cases.end()) {
    std::string names;
    for (const ParetoCase* known : cases) names += (names.empty() ? "" : ", ") + known->name;
    throw InputError(
        fmt::format("{}: case = \"{}\": expected one of those that run: {}", file, peer.flow, names));
  }
  const double end = full ? (*found)->full_end : (*found)->quick_end;
  if (std::abs(peer.states.back().time - end) > kEndTolerance) {
    throw InputError(
        fmt::format("{}: state.{}.time = {}: expected the last state at {} s, where the case ends", file,
                    peer.states.size() - 1, peer.states.back().time, end));
  }
  static_cast<void>(read_peer_state(scene_of(peer, **found), peer.states.back()));
}

}  // namespace

std::vector<PeerRun> find_peer_runs(const std::filesystem::path& folder,
                                    const std::vector<const ParetoCase*>& cases, bool full) {
  constexpr const char* kName = "peer.toml";
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder)) {
    if (std::filesystem::exists(folder / kName)) files.push_back(folder / kName);
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (std::filesystem::exists(entry.path() / kName)) files.push_back(entry.path() / kName);
    }
  }
  if (files.empty()) {
    throw InputError(
        fmt::format("--peers {}: expected a folder with {} in it or in its folders", folder.string(), kName));
  }
  std::sort(files.begin(), files.end());
  std::vector<PeerRun> runs;
  runs.reserve(files.size());
  for (const std::filesystem::path& file : files) {
    runs.push_back(load_peer_run(file));
    check(runs.back(), cases, full);
  }
  return runs;
}

Snapshot read_peer_state(const Scene& scene, const PeerState& state) {
  const NumberTable table = read_number_table(state.file);
  Snapshot snapshot;
  snapshot.time = state.time;
  snapshot.dimension = scene.dimension;
  snapshot.particle_spacing = scene.particle_spacing;
  snapshot.smoothing_length = scene.smoothing_length();
  snapshot.reference_density = scene.density;
  snapshot.particle_mass = scene.density * std::pow(scene.particle_spacing, scene.dimension);
  snapshot.objects = std::make_shared<ObjectParticles>();
  if (std::find(table.names.begin(), table.names.end(), "depth") != table.names.end()) {
    snapshot.columns = columns_of(scene, table);
    return snapshot;
  }
  read_particles(table, snapshot);
  const FluidField field(scene, snapshot);
  snapshot.number_density.reserve(snapshot.size());
  for (const Vec3f& place : snapshot.position) {
    snapshot.number_density.push_back(to_float(field.water_fraction(place.cast<double>())));
  }
  return snapshot;
}

ParetoPoint measure_peer(const PeerRun& peer, const ParetoCase& chosen, const ValidationRun* reference,
                         const std::filesystem::path& folder) {
  ValidationRun run;
  run.scene = scene_of(peer, chosen);
  run.files = {folder};
  std::filesystem::create_directories(folder);
  CsvFolder tables(folder);
  ProbeSet probes(run.scene, tables);
  for (const PeerState& state : peer.states) {
    run.states = {std::make_shared<const Snapshot>(read_peer_state(run.scene, state))};
    probes.record(*run.states.back());
  }
  const Snapshot& last = *run.states.back();
  ParetoPoint point;
  point.scheme = peer.scheme;
  point.step = peer.setting;
  point.spacing = peer.spacing;
  point.particles = peer.particles;
  if (point.particles == 0) point.particles = last.columns ? last.columns->size() : last.size();
  point.steps = peer.steps;
  point.time_step = last.time / static_cast<double>(peer.steps);
  point.cpu_times = {peer.cpu_time / last.time};
  point.pair_evaluations = kUnknown;
  point.state_memory = kUnknown;
  point.compression = kUnknown;
  point.energy_gain = kUnknown;
  for (const ParetoError& error : chosen.errors) {
    std::string reason = "not enough states";
    double off = kUnknown;
    try {
      off = error.evaluate(run, reference);
    } catch (const std::exception& failure) {
      reason = failure.what();
    }
    if (!std::isfinite(off)) {
      throw InputError(fmt::format("{}: the states do not give the error \"{}\" ({}): {}",
                                   peer.source_file.string(), error.name, error.meaning, reason));
    }
    point.errors.push_back(off);
  }
  return point;
}

}  // namespace eisph
