#include "app/stability/stability_cases.hpp"

#include <fmt/format.h>

namespace eisph {

std::vector<StabilityCase> stability_cases(bool full) {
  std::vector<StabilityCase> cases = {
      {"still_water",
       "water at rest",
       "still_water",
       {"particles.spacing=0.02", full ? "end_time=30" : "end_time=5", "output.times=[]"}},
      {"wall_impact", "impact on a wall", "hard/wall_impact"},
      {"edge_jet", "jet onto an edge", "hard/edge_jet"},
      {"drop", "drop at 10 m/s", "hard/drop"},
      {"thin_film", "film of two layers", "hard/thin_film"},
      {"narrow_gap", "gap of two spacings", "hard/narrow_gap"},
      {"wedge", "wedge, 3D", "hard/wedge"},
      {"jitter", "jitter of 20 %", "hard/jitter"},
      {"overlap", "overlapping particles", "hard/overlap"},
      {"tall_column", "column, aspect 10", "hard/tall_column"},
      {"square_patch",
       "rotating square patch",
       "square_patch",
       {"particles.spacing=0.025", "end_time=2", "output.times=[]"}},
      {"taylor_green",
       "Taylor-Green vortices",
       "taylor_green",
       {"particles.spacing=0.02", "end_time=1", "output.times=[]"}},
      {"slow_gate", "slow gate", "hard/slow_gate"},
  };
  StabilityCase odd{"odd_tank", "walls between lattice points", "hard/odd_tank"};
  for (int tenths = 0; tenths < 10; tenths += full ? 1 : 3) {
    odd.variants.push_back({fmt::format("domain.max=[{:.4f}, 0.4]", 0.4 + 0.001 * tenths),
                            fmt::format("fluid.region.0.max=[{:.4f}, 0.2]", 0.4 + 0.001 * tenths)});
  }
  cases.push_back(odd);
  return cases;
}

const std::vector<StabilityScheme>& stability_schemes() {
  static const std::vector<StabilityScheme> kSchemes = {
      {"EISPH", {"scheme.name=eisph"}, "phi", 0.17},
      {"EISPH, thesis", {"scheme.name=eisph", "scheme.stepping=thesis"}, "phi", 0.06},
      {"ISPH", {"scheme.name=isph"}, "phi", 0.17},
      {"WCSPH", {"scheme.name=wcsph"}, "courant", 0.25},
      {"delta-SPH", {"scheme.name=delta_sph"}, "courant", 0.25},
      {"delta-SPH, Runge-Kutta", {"scheme.name=delta_sph", "scheme.stepping=runge_kutta"}, "courant", 1.25},
  };
  return kSchemes;
}

}  // namespace eisph
