#include "io/run_json.hpp"

#include "io/file_io.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace eisph {

namespace {

using Json = nlohmann::ordered_json;

/// Each field under its own name. The binding takes all fields of RunSummary: a field added there does not
/// compile here until it is written too.
Json summary_json(const RunSummary& summary) {
  const auto& [scene, scheme, status, message, dimension, fluid_particles, object_particles,
               ghost_particles_max, threads, steps, simulated_time, time_step_mean, wall_time_loop,
               cpu_time_loop, wall_time_initial_pressure, particle_steps_per_second, pair_evaluations,
               pressure_iterations_mean, cpu_time_total, stage_ns_per_particle_step, state_bytes_per_particle,
               state_bytes_by_array, peak_rss_bytes, penetrations, lost_particles, outflow_particles,
               outflow_volume, compression_max, compression_p95, paired_fraction_max, paired_fraction_final,
               nearest_distance_p5_min, nearest_distance_p5_final, isolated_particles_max,
               isolated_particles_final, isolated_fraction_max, isolated_fraction_final, energy_initial,
               energy_final, energy_gain_max, mass_error, frames_written, frames_dropped, frames_drawn_by] =
      summary;
  Json json;
#define EISPH_PUT(name) json[#name] = name  // NOLINT(cppcoreguidelines-macro-usage)
  EISPH_PUT(scene);
  EISPH_PUT(scheme);
  EISPH_PUT(status);
  EISPH_PUT(message);
  EISPH_PUT(dimension);
  EISPH_PUT(fluid_particles);
  EISPH_PUT(object_particles);
  EISPH_PUT(ghost_particles_max);
  EISPH_PUT(threads);
  EISPH_PUT(steps);
  EISPH_PUT(simulated_time);
  EISPH_PUT(time_step_mean);
  EISPH_PUT(wall_time_loop);
  EISPH_PUT(cpu_time_loop);
  EISPH_PUT(wall_time_initial_pressure);
  EISPH_PUT(particle_steps_per_second);
  EISPH_PUT(pair_evaluations);
  EISPH_PUT(pressure_iterations_mean);
  EISPH_PUT(cpu_time_total);
  EISPH_PUT(stage_ns_per_particle_step);
  EISPH_PUT(state_bytes_per_particle);
  EISPH_PUT(state_bytes_by_array);
  EISPH_PUT(peak_rss_bytes);
  EISPH_PUT(penetrations);
  EISPH_PUT(lost_particles);
  EISPH_PUT(outflow_particles);
  EISPH_PUT(outflow_volume);
  EISPH_PUT(compression_max);
  EISPH_PUT(compression_p95);
  EISPH_PUT(paired_fraction_max);
  EISPH_PUT(paired_fraction_final);
  EISPH_PUT(nearest_distance_p5_min);
  EISPH_PUT(nearest_distance_p5_final);
  EISPH_PUT(isolated_particles_max);
  EISPH_PUT(isolated_particles_final);
  EISPH_PUT(isolated_fraction_max);
  EISPH_PUT(isolated_fraction_final);
  EISPH_PUT(energy_initial);
  EISPH_PUT(energy_final);
  EISPH_PUT(energy_gain_max);
  EISPH_PUT(mass_error);
  EISPH_PUT(frames_written);
  EISPH_PUT(frames_dropped);
  EISPH_PUT(frames_drawn_by);
#undef EISPH_PUT
  return json;
}

Json build_json(const BuildInfo& build) {
  Json json{{"compiler", build.compiler},
            {"type", build.type},
            {"flags", build.flags},
            {"instruction_set", build.instruction_set}};
  if (!build.commit.empty()) json["commit"] = build.commit;
  return json;
}

Json host_json(const HostInfo& host) {
  return {{"name", host.name},
          {"cpu_model", host.cpu_model},
          {"cores", host.cores},
          {"memory_bytes", host.memory_bytes},
          {"os", host.os}};
}

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("Clang {}", __clang_version__);
#else
  return fmt::format("GCC {}", __VERSION__);
#endif
}

std::string instruction_set() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__SSE2__)
  return "SSE2";
#elif defined(__ARM_NEON)
  return "NEON";
#else
  return "baseline";
#endif
}

}  // namespace

BuildInfo compiled_build_info() {
  BuildInfo build;
  build.compiler = compiler_name();
  build.instruction_set = instruction_set();
  return build;
}

void write_run_json(const std::filesystem::path& path, const RunSummary& summary, const BuildInfo& build,
                    const HostInfo& host, const RunTimes& times) {
  Json json = summary_json(summary);
  json["version"] = build.version;
  json["build"] = build_json(build);
  json["host"] = host_json(host);
  json["started"] = iso_time(times.started);
  json["finished"] = iso_time(times.finished);
  // Names come from scene files: bytes that are no UTF-8 must not lose a run its record.
  write_file_atomically(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace eisph
