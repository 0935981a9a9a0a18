#pragma once

#include "core/depth_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eisph {

// Deviation of simulated from photographed depth: h_simulation - h_photograph, m, cell by cell.

/// Pairs of depths of one or several times.
struct DeviationSamples {
  std::vector<float> simulation;  ///< m
  std::vector<float> photograph;  ///< m
};

/// Adds the cells with valid != 0 of two grids of the same cells. With `treat_as_dry` depths below
/// `dry_depth` count as zero. Throws std::invalid_argument for grids of different cells.
void add_samples(DeviationSamples& samples, const DepthGrid& simulation, const DepthGrid& photograph,
                 const std::vector<std::uint8_t>& valid, double dry_depth, bool treat_as_dry);

struct DeviationStatistics {
  std::size_t points = 0;
  double maximum = 0.0;  ///< m, as all others unless said otherwise
  double minimum = 0.0;
  double mean = 0.0;  ///< the bias
  double median = 0.0;
  double percentile_15 = 0.0;
  double percentile_85 = 0.0;
  double rms = 0.0;
  double standard_deviation = 0.0;
  double correlation = 0.0;     ///< of the depths (Pearson), pure; not-a-number if one is constant
  double wetted_overlap = 0.0;  ///< cells deeper than dry_depth in both over those in either, pure
};

/// Percentiles are linear between the ordered values. Throws std::invalid_argument without samples.
[[nodiscard]] DeviationStatistics deviation_statistics(const DeviationSamples& samples, double dry_depth);

/// How far the water has come in x at one time.
struct FrontDistance {
  double foremost = 0.0;  ///< m, simulation - photograph, of the most downstream wet cells
  double rms = 0.0;       ///< m, over the rows with water in both
  std::size_t rows = 0;   ///< with water in both
};

/// Cells deeper than `dry_depth` with valid != 0 count, if the one upstream of them does too: single ones are
/// drops or noise. Not-a-number where one side is dry.
[[nodiscard]] FrontDistance front_distance(const DepthGrid& simulation, const DepthGrid& photograph,
                                           const std::vector<std::uint8_t>& valid, double dry_depth);

struct DeviationClass {
  double centre = 0.0;  ///< m
  std::size_t count = 0;
  double share = 0.0;             ///< of all counts
  double cumulative_share = 0.0;  ///< up to and with this class
};

/// Equal classes from the least to the largest deviation; the largest one belongs to the last class. The
/// range may be given instead: what lies outside is then left out of the counts.
[[nodiscard]] std::vector<DeviationClass> deviation_classes(
    const DeviationSamples& samples, int classes,
    std::optional<std::pair<double, double>> range = std::nullopt);

/// Shares from the counts of classes with these centres.
[[nodiscard]] std::vector<DeviationClass> classes_from_counts(const std::vector<double>& centres,
                                                              const std::vector<std::size_t>& counts);

/// The deviation below which a share of the points lies, linear within the class, m.
[[nodiscard]] double percentile_of_classes(const std::vector<DeviationClass>& classes, double share);

/// A grid that ends on the plane y = `plane`, completed by its mirror image. Throws InputError if it does not
/// end there by a hundredth of a cell.
[[nodiscard]] DepthGrid mirrored(const DepthGrid& grid, double plane);

/// CSV with the thesis's columns: deviation [m], count [-], share [-], cumulative_share [-].
void write_deviation_classes(const std::filesystem::path& path, const std::vector<DeviationClass>& classes);

struct NamedStatistics {
  std::string name;
  DeviationStatistics statistics;
};
/// CSV with one row for each.
void write_deviation_statistics(const std::filesystem::path& path, const std::vector<NamedStatistics>& rows);

}  // namespace eisph
