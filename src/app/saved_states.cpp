#include "app/saved_states.hpp"

#include "core/error.hpp"
#include "io/pvd_collection.hpp"
#include "io/vtk_output.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace eisph {

std::vector<SavedState> saved_states(const RunFiles& files) {
  std::vector<SavedState> states;
  if (std::filesystem::exists(files.particles_collection())) {
    for (const PvdEntry& entry : read_pvd(files.particles_collection())) {
      states.push_back({entry.time, entry.file, {}});
    }
  }
  if (states.empty()) {
    throw InputError(
        fmt::format("{}: holds no saved states; they are written at output.particles_times and "
                    "output.particles_interval",
                    files.particles_collection().string()));
  }
  if (!std::filesystem::exists(files.objects_collection())) return states;
  for (const PvdEntry& entry : read_pvd(files.objects_collection())) {
    const auto state = std::find_if(states.begin(), states.end(), [&entry](const SavedState& candidate) {
      return candidate.time == entry.time;
    });
    if (state != states.end()) state->objects = entry.file;
  }
  return states;
}

std::vector<SavedState> select_states(const std::vector<SavedState>& states,
                                      const std::vector<double>& times) {
  if (times.empty()) return states;
  std::vector<bool> wanted(states.size(), false);
  for (const double time : times) {
    const auto nearest =
        std::min_element(states.begin(), states.end(), [time](const SavedState& a, const SavedState& b) {
          return std::abs(a.time - time) < std::abs(b.time - time);
        });
    if (std::abs(nearest->time - time) > kStateTimeTolerance) {
      throw InputError(
          fmt::format("--time {}: no state is saved there; the nearest is at {} s, the {} saved ones lie "
                      "between {} and {} s",
                      time, nearest->time, states.size(), states.front().time, states.back().time));
    }
    wanted[static_cast<std::size_t>(nearest - states.begin())] = true;
  }
  std::vector<SavedState> selected;
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (wanted[k]) selected.push_back(states[k]);
  }
  return selected;
}

Snapshot read_state(const SavedState& state) {
  Snapshot snapshot = read_particles(state.particles);
  snapshot.objects = state.objects.empty()
                         ? std::make_shared<const ObjectParticles>()
                         : std::make_shared<const ObjectParticles>(read_objects(state.objects));
  return snapshot;
}

}  // namespace eisph
