#pragma once

#include "app/comparison/photograph_set.hpp"
#include "app/comparison/run_depths.hpp"
#include "compare/deviation_statistics.hpp"
#include "core/comparison.hpp"
#include "core/scene.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace eisph {

/// How deviations are obtained: the simulation's depth and what stands in for dark rims.
struct DeviationVariant {
  DepthRule rule = DepthRule::HighestParticle;
  RimFill fill = RimFill::NearestPlus10;
  bool treat_as_dry = false;
};

/// Photograph and simulation at one time.
struct ComparedTime {
  std::size_t photograph = 0;  ///< number in the comparison
  double time = 0.0;           ///< s
  std::vector<RuledDepth> simulation;
  PhotographDepth measured;
  ComparableDepth compared;  ///< by the settings' rule for rims
};

/// Standard deviations over the repetitions with perturbed reference points, m.
struct Repeatability {
  std::size_t repetitions = 0;
  double maximum = 0.0;
  double minimum = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double percentile_15 = 0.0;
  double percentile_85 = 0.0;
  double rms = 0.0;
  double mean_shift = 0.0;  ///< largest change of the mean deviation by a repetition
};

/// A run compared with photographs, time by time: by `eisph compare` from saved states, or beside the
/// simulation. Memory: the photographs, and two depth grids for each time.
class PhotoComparison {
 public:
  /// Reads everything that the comparison names. `scene` is that of the run. Throws InputError.
  PhotoComparison(Comparison settings, const Scene& scene, double cell_size);

  [[nodiscard]] const Comparison& settings() const { return settings_; }
  [[nodiscard]] const PhotographSet& photographs() const { return photographs_; }
  /// The whole tank, with the mirror image of a half one.
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<ComparedTime>& times() const { return times_; }

  /// Number of the photograph taken at `time`, by the tolerance of saved states. Throws std::out_of_range if
  /// there is none.
  [[nodiscard]] std::size_t photograph_at(double time) const;
  /// Adds one time; times have to rise.
  const ComparedTime& add(std::size_t photograph, std::vector<RuledDepth> simulation);

  /// The variant of the settings, then those that differ from it in one point or more.
  [[nodiscard]] std::vector<DeviationVariant> variants() const;
  [[nodiscard]] std::string name_of(const DeviationVariant& variant) const;
  /// Of all times together.
  [[nodiscard]] DeviationSamples samples(const DeviationVariant& variant) const;
  [[nodiscard]] DeviationStatistics statistics(const DeviationVariant& variant) const;
  /// Of one time, by the settings.
  [[nodiscard]] DeviationStatistics statistics_at(const ComparedTime& time) const;
  [[nodiscard]] FrontDistance front_at(const ComparedTime& time) const;
  /// Repeats the comparison with the settings' perturbed points.
  [[nodiscard]] Repeatability repeatability() const;

 private:
  [[nodiscard]] DeviationVariant own_variant() const;

  Comparison settings_;
  Scene scene_;
  PhotographSet photographs_;
  std::vector<ComparedTime> times_;
};

/// The depth by a rule, or the first if there is no other.
[[nodiscard]] const DepthGrid& depth_by_rule(const ComparedTime& time, DepthRule rule);

}  // namespace eisph
