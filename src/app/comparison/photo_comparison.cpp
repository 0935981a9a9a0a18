#include "app/comparison/photo_comparison.hpp"

#include "app/saved_states.hpp"
#include "core/error.hpp"
#include "core/scene_mirror.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

/// Standard deviation of a figure of several statistics.
double scatter(const std::vector<DeviationStatistics>& all, double DeviationStatistics::*figure) {
  double mean = 0.0;
  for (const DeviationStatistics& one : all) mean += one.*figure / static_cast<double>(all.size());
  double squares = 0.0;
  for (const DeviationStatistics& one : all) squares += std::pow(one.*figure - mean, 2);
  return all.size() > 1 ? std::sqrt(squares / static_cast<double>(all.size() - 1)) : 0.0;
}

}  // namespace

const DepthGrid& depth_by_rule(const ComparedTime& time, DepthRule rule) {
  for (const RuledDepth& depth : time.simulation) {
    if (depth.rule == rule) return depth.grid;
  }
  return time.simulation.front().grid;
}

PhotoComparison::PhotoComparison(Comparison settings, const Scene& scene, double cell_size)
    : settings_(std::move(settings)),
      scene_(completed_by_symmetry(scene)),
      photographs_(load_photographs(settings_, scene_)) {
  // Cells that are too small are found before any time is compared.
  try {
    require_readable_cells(photographs_.registration.camera, photographs_.floor, cell_size);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: deviation.cell_size: {}", settings_.source_file, error.what()));
  }
}

std::size_t PhotoComparison::photograph_at(double time) const {
  for (std::size_t k = 0; k < settings_.photographs.size(); ++k) {
    if (std::abs(settings_.photographs[k].time - time) <= kStateTimeTolerance) return k;
  }
  throw std::out_of_range(fmt::format("no photograph at {} s", time));
}

const ComparedTime& PhotoComparison::add(std::size_t photograph, std::vector<RuledDepth> simulation) {
  ComparedTime compared{.photograph = photograph,
                        .time = settings_.photographs[photograph].time,
                        .simulation = std::move(simulation),
                        .measured = {},
                        .compared = {}};
  compared.measured = depth_on_cells(photographs_.depths[photograph], photographs_.registration.camera,
                                     photographs_.floor, settings_.rims, compared.simulation.front().grid);
  compared.compared = filled(compared.measured, settings_.rims.fill);
  times_.push_back(std::move(compared));
  return times_.back();
}

DeviationVariant PhotoComparison::own_variant() const {
  return {settings_.deviation.depth_rule, settings_.rims.fill, settings_.deviation.treat_as_dry};
}

std::vector<DeviationVariant> PhotoComparison::variants() const {
  std::vector<DeviationVariant> variants = {own_variant()};
  std::vector<DepthRule> rules;
  for (const RuledDepth& depth : times_.front().simulation) rules.push_back(depth.rule);
  for (const DepthRule rule : rules) {
    for (const RimFill fill : {RimFill::NearestPlus10, RimFill::LeaveOut, RimFill::Keep}) {
      const DeviationVariant variant{rule, fill, variants.front().treat_as_dry};
      if (variant.rule != variants.front().rule || variant.fill != variants.front().fill)
        variants.push_back(variant);
    }
  }
  DeviationVariant other = variants.front();
  other.treat_as_dry = !other.treat_as_dry;
  variants.push_back(other);
  return variants;
}

std::string PhotoComparison::name_of(const DeviationVariant& variant) const {
  std::string name = variant.rule == DepthRule::Surface ? "free surface" : "highest particle";
  if (scene_.scheme.name == "shallow_water") name = "depth of the model";
  switch (variant.fill) {
    case RimFill::NearestPlus10:
      name += ", rims by the nearest depth + 10 %";
      break;
    case RimFill::LeaveOut:
      name += ", rims left out";
      break;
    case RimFill::Keep:
      name += ", rims as photographed";
      break;
  }
  return variant.treat_as_dry ? name + ", shallow water as dry" : name;
}

DeviationSamples PhotoComparison::samples(const DeviationVariant& variant) const {
  DeviationSamples samples;
  for (const ComparedTime& time : times_) {
    const ComparableDepth photograph =
        variant.fill == settings_.rims.fill ? time.compared : filled(time.measured, variant.fill);
    add_samples(samples, depth_by_rule(time, variant.rule), photograph.grid, photograph.valid,
                settings_.deviation.dry_depth, variant.treat_as_dry);
  }
  if (samples.simulation.empty()) {
    throw InputError(
        fmt::format("{}: no cell of any photograph has a depth to compare with", settings_.source_file));
  }
  return samples;
}

DeviationStatistics PhotoComparison::statistics(const DeviationVariant& variant) const {
  return deviation_statistics(samples(variant), settings_.deviation.dry_depth);
}

DeviationStatistics PhotoComparison::statistics_at(const ComparedTime& time) const {
  DeviationSamples samples;
  add_samples(samples, depth_by_rule(time, settings_.deviation.depth_rule), time.compared.grid,
              time.compared.valid, settings_.deviation.dry_depth, settings_.deviation.treat_as_dry);
  if (samples.simulation.empty()) return {};
  return deviation_statistics(samples, settings_.deviation.dry_depth);
}

FrontDistance PhotoComparison::front_at(const ComparedTime& time) const {
  return front_distance(depth_by_rule(time, settings_.deviation.depth_rule), time.compared.grid,
                        time.compared.valid, settings_.deviation.dry_depth);
}

Repeatability PhotoComparison::repeatability() const {
  const RegistrationSettings& settings = settings_.registration;
  const auto registrations = perturbed_registrations(
      photographs_.points, photographs_.width, photographs_.height, settings.radial_distortion,
      settings.pick_error, settings.repetitions, static_cast<unsigned>(settings.seed));
  const double own_mean = statistics(own_variant()).mean;
  std::vector<DeviationStatistics> all;
  Repeatability result;
  for (const Registration& registration : registrations) {
    DeviationSamples samples;
    for (const ComparedTime& time : times_) {
      const PhotographDepth measured =
          depth_on_cells(photographs_.depths[time.photograph], registration.camera, photographs_.floor,
                         settings_.rims, time.simulation.front().grid);
      const ComparableDepth compared = filled(measured, settings_.rims.fill);
      add_samples(samples, depth_by_rule(time, settings_.deviation.depth_rule), compared.grid, compared.valid,
                  settings_.deviation.dry_depth, settings_.deviation.treat_as_dry);
    }
    if (samples.simulation.empty()) continue;
    all.push_back(deviation_statistics(samples, settings_.deviation.dry_depth));
    result.mean_shift = std::max(result.mean_shift, std::abs(all.back().mean - own_mean));
  }
  result.repetitions = all.size();
  result.maximum = scatter(all, &DeviationStatistics::maximum);
  result.minimum = scatter(all, &DeviationStatistics::minimum);
  result.mean = scatter(all, &DeviationStatistics::mean);
  result.median = scatter(all, &DeviationStatistics::median);
  result.percentile_15 = scatter(all, &DeviationStatistics::percentile_15);
  result.percentile_85 = scatter(all, &DeviationStatistics::percentile_85);
  result.rms = scatter(all, &DeviationStatistics::rms);
  return result;
}

}  // namespace eisph
