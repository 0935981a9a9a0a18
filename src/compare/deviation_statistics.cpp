#include "compare/deviation_statistics.hpp"

#include "compare/whole_file.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPlaneTolerance = 0.01;  ///< of a cell
constexpr double kConstant = 1e-20;  ///< relative variance of depths that are all the same but for rounding

void check_same_cells(const DepthGrid& a, const DepthGrid& b, const std::vector<std::uint8_t>& valid) {
  if (a.columns == b.columns && a.rows == b.rows && valid.size() == a.depth.size()) return;
  throw std::invalid_argument(fmt::format("deviation: grids of {} x {} and {} x {} cells, {} marks",
                                          a.columns, a.rows, b.columns, b.rows, valid.size()));
}

std::vector<double> deviations_of(const DeviationSamples& samples) {
  std::vector<double> deviations(samples.simulation.size());
  for (std::size_t k = 0; k < deviations.size(); ++k)
    deviations[k] = static_cast<double>(samples.simulation[k]) - static_cast<double>(samples.photograph[k]);
  return deviations;
}

/// Of ordered values, linear between them.
double percentile(const std::vector<double>& ordered, double share) {
  const double place = share * static_cast<double>(ordered.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ordered.size() - 1);
  return ordered[below] + (place - static_cast<double>(below)) * (ordered[above] - ordered[below]);
}

double correlation_of(const DeviationSamples& samples) {
  const auto count = static_cast<double>(samples.simulation.size());
  double mean_a = 0.0;
  double mean_b = 0.0;
  for (std::size_t k = 0; k < samples.simulation.size(); ++k) {
    mean_a += samples.simulation[k] / count;
    mean_b += samples.photograph[k] / count;
  }
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
  for (std::size_t k = 0; k < samples.simulation.size(); ++k) {
    const double a = samples.simulation[k] - mean_a;
    const double b = samples.photograph[k] - mean_b;
    aa += a * a;
    bb += b * b;
    ab += a * b;
  }
  const bool vary = aa > kConstant * count * mean_a * mean_a && bb > kConstant * count * mean_b * mean_b;
  return vary ? ab / std::sqrt(aa * bb) : kNone;
}

/// Column of the most downstream wet cell of a row that follows another one, -1 for none.
std::ptrdiff_t last_wet(const DepthGrid& grid, const std::vector<std::uint8_t>& valid, std::size_t row,
                        double dry_depth) {
  bool follower_is_wet = false;
  for (std::size_t i = grid.columns; i-- > 0;) {
    const std::size_t cell = row * grid.columns + i;
    const bool wet = valid[cell] != 0 && grid.depth[cell] > dry_depth;
    if (wet && follower_is_wet) return static_cast<std::ptrdiff_t>(i + 1);
    follower_is_wet = wet;
  }
  return -1;
}

}  // namespace

void add_samples(DeviationSamples& samples, const DepthGrid& simulation, const DepthGrid& photograph,
                 const std::vector<std::uint8_t>& valid, double dry_depth, bool treat_as_dry) {
  check_same_cells(simulation, photograph, valid);
  const auto counted = [&](float depth) { return treat_as_dry && depth < dry_depth ? 0.0F : depth; };
  for (std::size_t cell = 0; cell < valid.size(); ++cell) {
    if (valid[cell] == 0) continue;
    samples.simulation.push_back(counted(simulation.depth[cell]));
    samples.photograph.push_back(counted(photograph.depth[cell]));
  }
}

DeviationStatistics deviation_statistics(const DeviationSamples& samples, double dry_depth) {
  std::vector<double> deviations = deviations_of(samples);
  if (deviations.empty()) throw std::invalid_argument("statistics of no deviations");
  DeviationStatistics statistics;
  statistics.points = deviations.size();
  const auto count = static_cast<double>(deviations.size());
  double squares = 0.0;
  for (const double deviation : deviations) {
    statistics.mean += deviation / count;
    squares += deviation * deviation / count;
  }
  statistics.rms = std::sqrt(squares);
  statistics.standard_deviation = std::sqrt(std::max(0.0, squares - statistics.mean * statistics.mean));
  std::sort(deviations.begin(), deviations.end());
  statistics.minimum = deviations.front();
  statistics.maximum = deviations.back();
  statistics.median = percentile(deviations, 0.5);
  statistics.percentile_15 = percentile(deviations, 0.15);
  statistics.percentile_85 = percentile(deviations, 0.85);
  statistics.correlation = correlation_of(samples);
  double both = 0.0;
  double either = 0.0;
  for (std::size_t k = 0; k < samples.simulation.size(); ++k) {
    const bool a = samples.simulation[k] > dry_depth;
    const bool b = samples.photograph[k] > dry_depth;
    both += a && b ? 1.0 : 0.0;
    either += a || b ? 1.0 : 0.0;
  }
  statistics.wetted_overlap = either > 0.0 ? both / either : 1.0;
  return statistics;
}

FrontDistance front_distance(const DepthGrid& simulation, const DepthGrid& photograph,
                             const std::vector<std::uint8_t>& valid, double dry_depth) {
  check_same_cells(simulation, photograph, valid);
  std::ptrdiff_t foremost_a = -1;
  std::ptrdiff_t foremost_b = -1;
  double squares = 0.0;
  FrontDistance distance;
  for (std::size_t row = 0; row < simulation.rows; ++row) {
    const std::ptrdiff_t a = last_wet(simulation, valid, row, dry_depth);
    const std::ptrdiff_t b = last_wet(photograph, valid, row, dry_depth);
    foremost_a = std::max(foremost_a, a);
    foremost_b = std::max(foremost_b, b);
    if (a < 0 || b < 0) continue;
    ++distance.rows;
    squares += static_cast<double>((a - b) * (a - b));
  }
  const bool wet = foremost_a >= 0 && foremost_b >= 0;
  distance.foremost = wet ? simulation.cell_size * static_cast<double>(foremost_a - foremost_b) : kNone;
  distance.rms = distance.rows > 0
                     ? simulation.cell_size * std::sqrt(squares / static_cast<double>(distance.rows))
                     : kNone;
  return distance;
}

std::vector<DeviationClass> classes_from_counts(const std::vector<double>& centres,
                                                const std::vector<std::size_t>& counts) {
  double all = 0.0;
  for (const std::size_t count : counts) all += static_cast<double>(count);
  std::vector<DeviationClass> classes;
  double sum = 0.0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    sum += static_cast<double>(counts[k]);
    classes.push_back({centres[k], counts[k], static_cast<double>(counts[k]) / all, sum / all});
  }
  return classes;
}

std::vector<DeviationClass> deviation_classes(const DeviationSamples& samples, int classes,
                                              std::optional<std::pair<double, double>> range) {
  const std::vector<double> deviations = deviations_of(samples);
  if (deviations.empty() || classes < 1) throw std::invalid_argument("classes of no deviations");
  if (!range) {
    const auto [least, most] = std::minmax_element(deviations.begin(), deviations.end());
    range = {*least, *most};
  }
  const double width = std::max((range->second - range->first) / classes, std::numeric_limits<double>::min());
  std::vector<std::size_t> counts(static_cast<std::size_t>(classes), 0);
  for (const double deviation : deviations) {
    if (deviation < range->first || deviation > range->second) continue;
    const auto number = static_cast<std::size_t>((deviation - range->first) / width);
    ++counts[std::min(number, counts.size() - 1)];
  }
  std::vector<double> centres;
  centres.reserve(counts.size());
  for (int k = 0; k < classes; ++k) centres.push_back(range->first + (k + 0.5) * width);
  return classes_from_counts(centres, counts);
}

double percentile_of_classes(const std::vector<DeviationClass>& classes, double share) {
  const double width = classes.size() > 1 ? classes[1].centre - classes[0].centre : 0.0;
  for (const DeviationClass& one : classes) {
    if (one.count == 0 || one.cumulative_share < share) continue;
    const double before = one.cumulative_share - one.share;
    return one.centre + width * ((share - before) / one.share - 0.5);
  }
  return classes.empty() ? kNone : classes.back().centre + 0.5 * width;
}

DepthGrid mirrored(const DepthGrid& grid, double plane) {
  const double lower = grid.origin_y;
  const double upper = grid.origin_y + static_cast<double>(grid.rows) * grid.cell_size;
  const bool ends = std::abs(upper - plane) < kPlaneTolerance * grid.cell_size;
  const bool begins = std::abs(lower - plane) < kPlaneTolerance * grid.cell_size;
  if (!ends && !begins) {
    throw InputError(
        fmt::format("depth cells of {:g} m lie from y = {:g} to {:g} m and do not end on the plane of "
                    "symmetry, y = {:g} m; "
                    "the width of the half domain has to be a whole number of cells",
                    grid.cell_size, lower, upper, plane));
  }
  DepthGrid whole = grid;
  whole.rows = 2 * grid.rows;
  whole.origin_y = ends ? lower : 2.0 * plane - upper;
  whole.depth.assign(whole.columns * whole.rows, 0.0F);
  for (std::size_t j = 0; j < grid.rows; ++j) {
    const std::size_t own = ends ? j : grid.rows + j;
    const std::size_t image = whole.rows - 1 - own;
    for (std::size_t i = 0; i < grid.columns; ++i) {
      whole.depth[own * grid.columns + i] = grid.at(i, j);
      whole.depth[image * grid.columns + i] = grid.at(i, j);
    }
  }
  return whole;
}

void write_deviation_classes(const std::filesystem::path& path, const std::vector<DeviationClass>& classes) {
  std::string text = "deviation [m],count [-],share [-],cumulative_share [-]\n";
  for (const DeviationClass& one : classes)
    text += fmt::format("{:.6g},{},{:.6g},{:.6g}\n", one.centre, one.count, one.share, one.cumulative_share);
  write_whole_file(path, text);
}

void write_deviation_statistics(const std::filesystem::path& path, const std::vector<NamedStatistics>& rows) {
  std::string text =
      "comparison,points [-],maximum [m],minimum [m],mean [m],median [m],percentile_15 [m],percentile_85 [m],"
      "rms [m],standard_deviation [m],correlation [-],wetted_overlap [-]\n";
  for (const auto& [name, s] : rows) {
    text += fmt::format("\"{}\",{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n",
                        name, s.points, s.maximum, s.minimum, s.mean, s.median, s.percentile_15,
                        s.percentile_85, s.rms, s.standard_deviation, s.correlation, s.wetted_overlap);
  }
  write_whole_file(path, text);
}

}  // namespace eisph
