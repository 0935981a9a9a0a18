#include "io/comparison_keys.hpp"

#include <algorithm>
#include <utility>

namespace eisph {

namespace {

constexpr double kGreyLevels = 255.0;

bool read_pair(const toml::node& node, PlanePoint& point) {
  std::vector<double> values;
  if (!read_numbers(node, values) || values.size() != 2) return false;
  point = {values[0], values[1]};
  return true;
}

template <class Owner>
Key<Owner>& add_pair_key(KeyTable<Owner>& keys, const std::string& name, const std::string& unit,
                         PlanePoint Owner::*field, const std::string& meaning) {
  return keys.add(
      {.name = name, .type = "a list of two numbers", .unit = unit, .meaning = meaning},
      [=](const toml::node& node, int, Owner& owner) { return read_pair(node, owner.*field); },
      [=](const Owner& owner, int) {
        return write_numbers({(owner.*field)[0], (owner.*field)[1]});
      });
}

KeyTable<TimedPhotograph> photograph_keys() {
  KeyTable<TimedPhotograph> keys;
  keys.path("file", &TimedPhotograph::file, "PNG, grey or colour, 8 or 16 bit.").required();
  keys.number("time", "s", &TimedPhotograph::time, at_least(0.0), "When it was taken, from the release.")
      .required();
  return keys;
}

KeyTable<ReferencePointSettings> reference_point_keys() {
  KeyTable<ReferencePointSettings> keys;
  keys.string("name", &ReferencePointSettings::name, "What it is, for the report.").required();
  add_pair_key(keys, "position", "m", &ReferencePointSettings::position, "Where it is on the floor: [x, y].")
      .required();
  add_pair_key(keys, "pixel", "pixels", &ReferencePointSettings::pixel,
               "Where it is seen: [right, down] from the upper left corner of the picture.")
      .required();
  return keys;
}

KeyTable<RegistrationSettings> registration_keys() {
  KeyTable<RegistrationSettings> keys;
  keys.path("outline", &RegistrationSettings::outline,
            "Photograph of the empty tank in which the corners of the floor are found.")
      .fallback("none: points are given");
  keys.list("point", &RegistrationSettings::points, reference_point_keys(),
            "A point of the floor that is seen in all photographs: a corner of the tank or of an obstacle.");
  keys.boolean("radial_distortion", &RegistrationSettings::radial_distortion,
               "Fit the lens's radial distortion as well; needs five points.");
  keys.number("pick_error", "pixels", &RegistrationSettings::pick_error, at_least(0.0),
              "Standard deviation of a point in each direction, for the repetitions.");
  keys.integer("repetitions", "", &RegistrationSettings::repetitions, between(0.0, 10000.0),
               "How often the comparison is repeated with perturbed points; 0: never.");
  keys.integer("seed", "", &RegistrationSettings::seed, between(0.0, 2147483647.0),
               "Start of the random numbers of the repetitions.");
  return keys;
}

KeyTable<CalibrationPhotograph> calibration_photograph_keys() {
  KeyTable<CalibrationPhotograph> keys;
  keys.path("file", &CalibrationPhotograph::file, "Photograph of still water.").required();
  keys.number("depth", "m", &CalibrationPhotograph::depth, at_least(0.0), "Its depth.").required();
  return keys;
}

KeyTable<CalibrationLevel> calibration_level_keys() {
  KeyTable<CalibrationLevel> keys;
  keys.number("level", "of 255", &CalibrationLevel::level, between(0.0, kGreyLevels), "Grey level.")
      .required();
  keys.number("depth", "m", &CalibrationLevel::depth, at_least(0.0), "The depth that it stands for.")
      .required();
  return keys;
}

KeyTable<CalibrationSettings> calibration_keys() {
  KeyTable<CalibrationSettings> keys;
  keys.list("photograph", &CalibrationSettings::photographs, calibration_photograph_keys(),
            "A photograph of still water over the whole floor; two or more.");
  keys.list("level", &CalibrationSettings::levels, calibration_level_keys(),
            "A row of a table of grey levels and depths, instead of photographs; two or more.");
  keys.boolean("per_pixel", &CalibrationSettings::per_pixel,
               "A curve for each pixel of the photographs, instead of one for the whole picture.");
  keys.add(
          {.name = "tolerance",
           .type = "a number at least 0",
           .unit = "of 255",
           .meaning = "Levels this far beyond the calibrated ones count as the end of the curve; farther "
                      "ones have no depth."},
          [](const toml::node& node, int, CalibrationSettings& settings) {
            double value = 0.0;
            if (!read_number(node, at_least(0.0), value)) return false;
            settings.tolerance = value;
            return true;
          },
          [](const CalibrationSettings& settings, int) {
            return settings.tolerance ? write_number(*settings.tolerance) : std::string();
          })
      .fallback("3 standard deviations of the calibration's noise, at least 2");
  return keys;
}

bool read_polygons(const toml::node& node, std::vector<std::vector<PlanePoint>>& polygons) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return false;
  std::vector<std::vector<PlanePoint>> read;
  for (const toml::node& entry : *list) {
    const toml::array* corners = entry.as_array();
    if (corners == nullptr || corners->size() < 3) return false;
    std::vector<PlanePoint>& polygon = read.emplace_back();
    for (const toml::node& corner : *corners) {
      if (!read_pair(corner, polygon.emplace_back())) return false;
    }
  }
  polygons = std::move(read);
  return true;
}

std::string write_polygons(const std::vector<std::vector<PlanePoint>>& polygons) {
  std::string text = "[";
  for (const std::vector<PlanePoint>& polygon : polygons) {
    text += text.size() > 1 ? ", [" : "[";
    for (std::size_t k = 0; k < polygon.size(); ++k)
      text += (k > 0 ? ", " : "") + write_numbers({polygon[k][0], polygon[k][1]});
    text += "]";
  }
  return text + "]";
}

KeyTable<RimSettings> rim_keys() {
  KeyTable<RimSettings> keys;
  keys.number("band", "m", &RimSettings::band, at_least(0.0),
              "How far from walls and solids air bubbles darken the photographs.");
  keys.choice<RimDetection>(
      "detection", &RimSettings::detection,
      {{"detect", RimDetection::Detect}, {"band", RimDetection::Band}, {"none", RimDetection::None}},
      "What of the band is left out of the measurement: what is darker than the water beside it, all, or "
      "nothing.");
  keys.choice<RimFill>("fill", &RimSettings::fill,
                       {{"nearest_plus_10", RimFill::NearestPlus10},
                        {"leave_out", RimFill::LeaveOut},
                        {"keep", RimFill::Keep}},
                       "What stands in for it: the nearest valid depth and 10 % more, nothing, or the depth "
                       "as photographed.");
  keys.add(
          {.name = "polygons",
           .type = "a list of polygons, each a list of at least three points [x, y]",
           .unit = "m",
           .meaning = "Further areas to be left out or filled."},
          [](const toml::node& node, int, RimSettings& rims) { return read_polygons(node, rims.polygons); },
          [](const RimSettings& rims, int) { return write_polygons(rims.polygons); })
      .fallback("[]");
  return keys;
}

KeyTable<DeviationSettings> deviation_keys() {
  KeyTable<DeviationSettings> keys;
  keys.number("cell_size", "m", &DeviationSettings::cell_size, at_least(0.0),
              "Side of the square cells that depths are compared on; 0: 1.5 particle spacings of the run, or "
              "the cells of its depth grids.");
  keys.choice<DepthRule>(
      "depth_rule", &DeviationSettings::depth_rule,
      {{"highest_particle", DepthRule::HighestParticle}, {"surface", DepthRule::Surface}},
      "Depth of the simulation in a cell: the height of its highest particle, or the free surface.");
  keys.boolean(
      "ignore_spray", &DeviationSettings::ignore_spray,
      "The highest particle is one that is no spray: not in the air with a number density below that of an "
      "edge of water; false: of all particles (thesis). Depth grids are taken as they were saved.");
  keys.number("dry_depth", "m", &DeviationSettings::dry_depth, at_least(0.0),
              "Shallower cells are not wetted.");
  keys.boolean("treat_as_dry", &DeviationSettings::treat_as_dry,
               "Take depths below dry_depth as zero on both sides.");
  keys.integer("classes", "", &DeviationSettings::classes, between(1.0, 1000.0),
               "Equal classes between the smallest and the largest deviation.");
  return keys;
}

KeyTable<ComparisonImages> comparison_image_keys() {
  KeyTable<ComparisonImages> keys;
  keys.integer("width", "pixels", &ComparisonImages::width, between(700.0, 4000.0), "Of the pictures.");
  keys.number("depth", "m", &ComparisonImages::depth, above(0.0), "Deepest of the grey scale.");
  keys.number("deviation", "m", &ComparisonImages::deviation, at_least(0.0),
              "End of the deviation's colour bar, both ways; 0: a third of the depth.");
  keys.boolean("video", &ComparisonImages::video,
               "Join the pictures of each kind to a video, where ffmpeg is installed.");
  return keys;
}

template <std::size_t size>
bool read_exactly(const toml::node& node, std::array<double, size>& values) {
  std::vector<double> read;
  if (!read_numbers(node, read) || read.size() != size) return false;
  std::copy(read.begin(), read.end(), values.begin());
  return true;
}

void add_area_key(KeyTable<Comparison>& keys) {
  keys.add(
          {.name = "area",
           .type = "a list [x_min, y_min, x_max, y_max] with x_min < x_max and y_min < y_max",
           .unit = "m",
           .meaning = "Part of the floor that the photographs show."},
          [](const toml::node& node, int, Comparison& comparison) {
            std::array<double, 4> area{};
            if (!read_exactly(node, area) || area[0] >= area[2] || area[1] >= area[3]) return false;
            comparison.area = area;
            return true;
          },
          [](const Comparison& comparison, int) {
            if (!comparison.area) return std::string();
            return write_numbers({comparison.area->begin(), comparison.area->end()});
          })
      .fallback("the whole floor");
}

void add_weights_key(KeyTable<Comparison>& keys) {
  keys.add(
      {.name = "grey_weights",
       .type = "a list of three numbers at least 0 that add up to 1",
       .meaning = "Weights of red, green and blue in the grey level of a colour picture."},
      [](const toml::node& node, int, Comparison& comparison) {
        std::array<double, 3> weights{};
        if (!read_exactly(node, weights)) return false;
        if (*std::min_element(weights.begin(), weights.end()) < 0.0) return false;
        const double sum = weights[0] + weights[1] + weights[2];
        if (sum < 1.0 - 1e-6 || sum > 1.0 + 1e-6) return false;
        comparison.grey_weights = weights;
        return true;
      },
      [](const Comparison& comparison, int) {
        return write_numbers({comparison.grey_weights.begin(), comparison.grey_weights.end()});
      });
}

}  // namespace

KeyTable<Comparison> comparison_keys() {
  KeyTable<Comparison> keys;
  keys.string("title", &Comparison::title, "Heading of the report.").fallback("the name of the file");
  keys.string("experiment", &Comparison::experiment, "What the photographs show, in captions.");
  keys.boolean("synthetic", &Comparison::synthetic,
               "The photographs are computed; the report and all pictures say so.");
  keys.path("run", &Comparison::run, "Folder of the run to compare with.")
      .fallback("the one named on the command line");
  keys.path("other_run", &Comparison::other_run,
            "Folder of a second run, whose lower half is drawn below the upper half of the first.")
      .fallback("none");
  add_area_key(keys);
  add_weights_key(keys);
  keys.list("photograph", &Comparison::photographs, photograph_keys(), "A photograph of the wave.");
  keys.section("registration", &Comparison::registration, registration_keys(),
               "Where the floor is in the photographs.");
  keys.section("calibration", &Comparison::calibration, calibration_keys(),
               "From grey levels to water depth.");
  keys.section("rims", &Comparison::rims, rim_keys(), "Dark rims of air bubbles at walls and solids.");
  keys.section("deviation", &Comparison::deviation, deviation_keys(), "Comparison and statistics.");
  keys.section("images", &Comparison::images, comparison_image_keys(), "Pictures of the comparison.");
  return keys;
}

}  // namespace eisph
