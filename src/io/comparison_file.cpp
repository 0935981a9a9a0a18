#include "io/comparison_file.hpp"

#include "io/comparison_keys.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr std::size_t kCorners = 4;               ///< that the outline of the floor gives
constexpr std::size_t kFewestPoints = 4;          ///< of a projective transform
constexpr std::size_t kFewestWithDistortion = 5;  ///< with one coefficient more

void resolve_paths(Comparison& comparison, const TomlSource& source) {
  for (std::size_t k = 0; k < comparison.photographs.size(); ++k)
    source.resolve_file(comparison.photographs[k].file, fmt::format("photograph.{}.file", k));
  std::vector<CalibrationPhotograph>& still = comparison.calibration.photographs;
  for (std::size_t k = 0; k < still.size(); ++k)
    source.resolve_file(still[k].file, fmt::format("calibration.photograph.{}.file", k));
  if (!comparison.registration.outline.empty())
    source.resolve_file(comparison.registration.outline, "registration.outline");
  for (std::filesystem::path* run : {&comparison.run, &comparison.other_run}) {
    if (run->empty() || run->is_absolute()) continue;
    *run = (std::filesystem::path(source.file()).parent_path() / *run).lexically_normal();
  }
}

void check_photographs(const Comparison& comparison, const TomlSource& source) {
  if (comparison.photographs.empty())
    source.fail("photograph", "missing; expected at least one section [[photograph]]");
  for (std::size_t k = 1; k < comparison.photographs.size(); ++k) {
    if (comparison.photographs[k].time > comparison.photographs[k - 1].time) continue;
    source.fail(fmt::format("photograph.{}.time", k),
                fmt::format("expected more than {} s, the time of the photograph before",
                            comparison.photographs[k - 1].time));
  }
}

void check_registration(const RegistrationSettings& registration, const TomlSource& source) {
  const std::size_t corners = registration.outline.empty() ? 0 : kCorners;
  const std::size_t points = registration.points.size() + corners;
  const std::size_t fewest = registration.radial_distortion ? kFewestWithDistortion : kFewestPoints;
  if (points >= fewest) return;
  source.fail(
      "registration",
      fmt::format("{} reference points; expected at least {}{}: sections [[registration.point]], or "
                  "an outline, which counts for {}",
                  points, fewest, registration.radial_distortion ? " with radial_distortion" : "", kCorners));
}

void check_calibration(const CalibrationSettings& calibration, const TomlSource& source) {
  const bool table = !calibration.levels.empty();
  if (table && !calibration.photographs.empty())
    source.fail("calibration.level", "expected either photographs or a table of levels, not both");
  if (std::max(calibration.levels.size(), calibration.photographs.size()) < 2) {
    source.fail("calibration",
                "expected two or more sections [[calibration.photograph]] or [[calibration.level]]");
  }
  if (table && source.given("calibration.per_pixel") && calibration.per_pixel)
    source.fail("calibration.per_pixel", "a table of levels holds for all pixels; expected false");
}

}  // namespace

Comparison load_comparison(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  TomlSource source(file, overrides,
                    {.expected = "a comparison file (TOML)", .example = "rims.fill=leave_out"});
  Comparison comparison;
  comparison.source_file = file.string();
  SectionReader reader{.source = source, .dimension = 3};
  comparison_keys().read(reader, "", source.root(), comparison);
  if (comparison.title.empty()) comparison.title = file.stem().string();
  check_photographs(comparison, source);
  check_registration(comparison.registration, source);
  check_calibration(comparison.calibration, source);
  if (!comparison.calibration.levels.empty()) comparison.calibration.per_pixel = false;
  resolve_paths(comparison, source);
  return comparison;
}

std::string comparison_toml(const Comparison& comparison) {
  SectionWriter writer{.dimension = 3, .text = ""};
  comparison_keys().write(writer, "", comparison);
  return writer.text;
}

std::string comparison_schema_text() {
  SchemaWriter writer{.text =
                          "Keys of a comparison file (TOML). SI units; pixels from the upper left corner of "
                          "a picture; grey levels from 0 (black) to\n255 (white) for files of any depth.\n\n"
                          "[top of the file]\n"};
  comparison_keys().describe(writer, "");
  return writer.text;
}

}  // namespace eisph
