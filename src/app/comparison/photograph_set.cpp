#include "app/comparison/photograph_set.hpp"

#include "compare/tank_outline.hpp"
#include "core/error.hpp"
#include "render/grey_png.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace eisph {

namespace {

constexpr double kAboveFloor = 1e-6;  ///< m
constexpr double kRounding = 1e-6;    ///< m, by which an area may reach beyond the domain
constexpr double kWhite = 255.0;

/// Puts the file and the section before the message of what goes wrong.
template <class Action>
auto in_section(const Comparison& comparison, const char* section, Action&& action) {
  try {
    return action();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}: {}", comparison.source_file, section, error.what()));
  }
}

double distance_to_walls(const Scene& scene, double x, double y) {
  double nearest = std::numeric_limits<double>::infinity();
  const std::array<double, 4> distances = {x - scene.domain_min.x(), scene.domain_max.x() - x,
                                           y - scene.domain_min.y(), scene.domain_max.y() - y};
  for (const int face : {kXMin, kXMax, kYMin, kYMax}) {
    if (scene.faces[static_cast<std::size_t>(face)].kind == FaceKind::Wall)
      nearest = std::min(nearest, distances[static_cast<std::size_t>(face)]);
  }
  return nearest;
}

/// Reads pictures and sees to it that all have one size.
class PictureReader {
 public:
  PictureReader(const Comparison& comparison, PhotographSet& set) : comparison_(comparison), set_(set) {}

  GreyPicture read(const std::filesystem::path& path) {
    GreyPng png = read_grey_png(path, comparison_.grey_weights);
    if (set_.width == 0) {
      set_.width = png.picture.width;
      set_.height = png.picture.height;
      set_.bit_depth = png.bit_depth;
      first_ = path;
    }
    if (png.picture.width != set_.width || png.picture.height != set_.height) {
      throw InputError(fmt::format("{}: {} x {} pixels; {} has {} x {}, and one camera takes all",
                                   path.string(), png.picture.width, png.picture.height, first_.string(),
                                   set_.width, set_.height));
    }
    set_.bit_depth = std::min(set_.bit_depth, png.bit_depth);
    set_.coloured = set_.coloured || png.coloured;
    return std::move(png.picture);
  }

 private:
  const Comparison& comparison_;
  PhotographSet& set_;
  std::filesystem::path first_;
};

void find_reference_points(const Comparison& comparison, PictureReader& reader, PhotographSet& set) {
  const RegistrationSettings& settings = comparison.registration;
  for (const ReferencePointSettings& point : settings.points) {
    set.points.push_back(
        {point.name, {point.position[0], point.position[1]}, {point.pixel[0], point.pixel[1]}});
  }
  if (settings.outline.empty()) return;
  const GreyPicture picture = reader.read(settings.outline);
  const TankOutline outline =
      in_section(comparison, "registration.outline", [&] { return find_tank_outline(picture); });
  const auto& [x_min, y_min, x_max, y_max] = set.floor.area;
  set.bow = outline.bow;
  set.points.push_back({"lower left corner, found", {x_min, y_min}, outline.corners[0]});
  set.points.push_back({"lower right corner, found", {x_max, y_min}, outline.corners[1]});
  set.points.push_back({"upper right corner, found", {x_max, y_max}, outline.corners[2]});
  set.points.push_back({"upper left corner, found", {x_min, y_max}, outline.corners[3]});
}

DepthCalibration calibrate(const Comparison& comparison, PictureReader& reader, const PhotographSet& set) {
  const CalibrationSettings& settings = comparison.calibration;
  std::optional<double> tolerance;
  if (settings.tolerance) tolerance = *settings.tolerance / kWhite;
  if (!settings.levels.empty()) {
    std::vector<CalibrationPoint> points;
    for (const CalibrationLevel& level : settings.levels)
      points.push_back({level.level / kWhite, level.depth});
    return DepthCalibration::from_points(std::move(points), tolerance);
  }
  std::vector<CalibrationStep> steps;
  for (const CalibrationPhotograph& photograph : settings.photographs)
    steps.push_back({photograph.file.string(), photograph.depth, reader.read(photograph.file)});
  const auto mask = floor_mask(set.floor, set.registration.camera, set.width, set.height);
  return settings.per_pixel ? DepthCalibration::per_pixel(steps, mask, tolerance)
                            : DepthCalibration::whole_picture(steps, mask, tolerance);
}

}  // namespace

FloorMap floor_of(const Scene& scene, const std::optional<std::array<double, 4>>& area) {
  FloorMap floor;
  floor.area = {scene.domain_min.x(), scene.domain_min.y(), scene.domain_max.x(), scene.domain_max.y()};
  if (area) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double beyond = k < 2 ? floor.area[k] - (*area)[k] : (*area)[k] - floor.area[k];
      if (beyond <= kRounding) continue;
      throw InputError(fmt::format("area = [{}, {}, {}, {}] m: reaches beyond the domain, [{}, {}, {}, {}] m",
                                   (*area)[0], (*area)[1], (*area)[2], (*area)[3], floor.area[0],
                                   floor.area[1], floor.area[2], floor.area[3]));
    }
    floor.area = *area;
  }
  floor.solid_distance = [obstacles = scene.obstacles, z = scene.domain_min.z() + kAboveFloor](double x,
                                                                                               double y) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : obstacles)
      nearest = std::min(nearest, obstacle.shape.signed_distance(Vec3d(x, y, z), 3));
    return nearest;
  };
  floor.wall_distance = [scene, solid = floor.solid_distance](double x, double y) {
    return std::min(distance_to_walls(scene, x, y), solid(x, y));
  };
  return floor;
}

PhotographSet load_photographs(const Comparison& comparison, const Scene& scene) {
  PhotographSet set{.floor = in_section(comparison, "area", [&] { return floor_of(scene, comparison.area); }),
                    .points = {},
                    .bow = {},
                    .registration = {},
                    .calibration = DepthCalibration::none(),
                    .pictures = {},
                    .depths = {}};
  PictureReader reader(comparison, set);
  for (const TimedPhotograph& photograph : comparison.photographs)
    set.pictures.push_back(reader.read(photograph.file));
  find_reference_points(comparison, reader, set);
  set.registration = in_section(comparison, "registration", [&] {
    return register_points(set.points, set.width, set.height, comparison.registration.radial_distortion);
  });
  set.calibration = in_section(comparison, "calibration", [&] { return calibrate(comparison, reader, set); });
  for (const GreyPicture& picture : set.pictures)
    set.depths.push_back(depth_picture(picture, set.calibration));
  return set;
}

}  // namespace eisph
