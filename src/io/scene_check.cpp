#include "io/scene_check.hpp"

#include "io/scene_file.hpp"
#include "io/schema_value.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eisph {

namespace {

/// The name of every element of a group must be new; maps names to the section that has them.
class NameRegister {
 public:
  explicit NameRegister(const TomlSource& source) : source_(source) {}
  void add(const std::string& path, const std::string& name) {
    const auto [first, is_new] = paths_.emplace(name, path);
    if (!is_new)
      source_.fail(path + ".name", fmt::format("name already taken by {}; expected another", first->second));
  }

 private:
  const TomlSource& source_;
  std::map<std::string, std::string> paths_;
};

void check_names(const Scene& scene, const TomlSource& source) {
  if (!is_name(scene.name)) {
    source.fail("name", write_text(scene.name), "expected a name of letters, digits, _ and -");
  }
  NameRegister solids(source);
  for (std::size_t k = 0; k < scene.obstacles.size() + scene.gates.size(); ++k) {
    const bool fixed = k < scene.obstacles.size();
    solids.add(solid_path(scene, source, k),
               fixed ? scene.obstacles[k].name : scene.gates[k - scene.obstacles.size()].name);
  }
  NameRegister records(source);
  const auto add_records = [&](const auto& probes, const char* section) {
    for (std::size_t k = 0; k < probes.size(); ++k)
      records.add(fmt::format("{}.{}", section, k), probes[k].name);
  };
  add_records(scene.gauges, "gauge");
  add_records(scene.probes, "probe");
  add_records(scene.pressure_sensors, "pressure_sensor");
  add_records(scene.fronts, "front");
  add_records(scene.lines, "line");
  add_records(scene.forces, "force");
  add_records(scene.discharges, "discharge");
  NameRegister images(source);
  for (std::size_t k = 0; k < scene.images.size(); ++k)
    images.add(fmt::format("image.{}", k), scene.images[k].name);
}

void check_gates(const Scene& scene, const TomlSource& source) {
  for (std::size_t k = 0; k < scene.gates.size(); ++k) {
    if (scene.gates[k].motion != GateMotion::Lift) continue;
    const std::string path = fmt::format("gate.{}", k);
    const bool speed = source.given(path + ".speed");
    if (speed && source.given(path + ".duration")) {
      source.fail(path + ".duration", "speed is given as well; expected one of the two");
    }
    if (!(scene.gates[k].speed > 0.0)) {
      source.fail(path + ".speed", "missing; expected speed (a number above 0, in m/s) or duration (in s)");
    }
  }
}

void check_times(const Scene& scene, const TomlSource& source) {
  const auto check = [&](const std::string& path, const Schedule& schedule) {
    if (schedule.times.empty() || schedule.times.back() <= scene.end_time || !source.given(path)) return;
    source.fail(path, fmt::format("{} s is beyond the end of the run; expected times up to end_time = {} s",
                                  schedule.times.back(), scene.end_time));
  };
  check("output.times", scene.output.frames);
  check("output.particles_times", scene.output.particles);
  check("output.depth_times", scene.output.depth);
  for (std::size_t k = 0; k < scene.images.size(); ++k) {
    check(fmt::format("image.{}.times", k), scene.images[k].schedule);
  }
}

/// Which steppings a scheme has, and what its pressure needs.
void check_scheme(const Scene& scene, const TomlSource& source) {
  const SchemeSettings& scheme = scene.scheme;
  if (scheme.name == "shallow_water") return;
  const bool weakly_compressible = scheme.weakly_compressible();
  const bool several_stages =
      scheme.stepping == Stepping::PredictorCorrector || scheme.stepping == Stepping::RungeKutta;
  if (weakly_compressible && scheme.stepping == Stepping::Thesis) {
    source.fail("scheme.stepping",
                fmt::format("scheme.name is \"{}\"; expected \"symplectic\", \"predictor_corrector\" or "
                            "\"runge_kutta\"",
                            scheme.name));
  }
  if (!weakly_compressible && several_stages) {
    source.fail("scheme.stepping",
                fmt::format("scheme.name is \"{}\"; expected \"symplectic\" or \"thesis\"", scheme.name));
  }
  if (weakly_compressible && !(scheme.sound_speed > 0.0)) {
    source.fail("scheme.sound_speed",
                "missing, and neither gravity nor an initial velocity tells the speed expected; expected a "
                "number above 0, in m/s");
  }
}

/// What the depth-averaged equations need.
void check_shallow_water(const Scene& scene, const TomlSource& source) {
  if (scene.scheme.name != "shallow_water") return;
  if (scene.gravity.x() != 0.0 || scene.gravity.y() != 0.0 || scene.gravity.z() >= 0.0) {
    source.fail("gravity", write_vector(scene.gravity, scene.dimension),
                "expected an acceleration straight down with scheme.name = \"shallow_water\"");
  }
  if (scene.faces[kZMin].kind == FaceKind::Open) {
    source.fail("domain.faces.z_min", "shallow water needs a floor; expected a wall");
  }
  const double side = scene.shallow_water.cell_size;
  for (int axis = 0; axis < scene.dimension - 1; ++axis) {
    const double length = scene.domain_max[axis] - scene.domain_min[axis];
    const double cells = std::round(length / side);
    if (cells >= 1.0 && std::abs(length - cells * side) <= 1e-6 * length) continue;
    source.fail("shallow_water.cell_size", write_number(side),
                fmt::format("the domain is {:.9g} m long in {}; expected a size of which that is a multiple, "
                            "for example {:.6g} or {:.6g}",
                            length, "xyz"[axis], length / (std::floor(length / side) + 1.0),
                            length / std::max(1.0, std::floor(length / side))));
  }
}

void check_clip(const ClipBox& clip, ImageKind kind, int dimension, const std::string& path,
                const TomlSource& source) {
  if (kind != ImageKind::Particles) {
    source.fail(path, "only particles are clipped; clip is only accepted with kind = \"particles\"");
  }
  for (int d = 0; d < 3; ++d) {
    if ((dimension == 2 && d == 1) || clip.min[d] < clip.max[d]) continue;
    source.fail(path + ".max", write_vector(clip.max, dimension),
                "expected a point beyond min in every direction");
  }
}

void check_camera(const Camera& camera, const std::string& path, const TomlSource& source) {
  const Vec3d view = camera.target - camera.eye;
  if (view.norm() == 0.0) {
    source.fail(path + ".eye", "the camera is at its own target; expected a point away from it");
  }
  const double scale = view.norm() * camera.up.norm();
  if (!(view.cross(camera.up).norm() > 1e-6 * scale)) {
    source.fail(path + ".up", write_vector(camera.up, 3),
                "expected a direction that is not zero and not along the view from eye to target");
  }
}

/// What a picture of several panels is made of.
void check_panels(const Scene& scene, const ImageSettings& image, const std::string& path,
                  const TomlSource& source) {
  std::vector<std::string> images;
  images.reserve(scene.images.size());
  for (const ImageSettings& other : scene.images) {
    if (other.kind != ImageKind::Panels) images.push_back(other.name);
  }
  std::vector<std::string> gauges;
  gauges.reserve(scene.gauges.size());
  for (const Gauge& gauge : scene.gauges) gauges.push_back(gauge.name);
  const auto check = [&](const char* key, const std::vector<std::string>& names,
                         const std::vector<std::string>& known, const char* what) {
    for (const std::string& name : names) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      source.fail(path + "." + key, write_text(name),
                  fmt::format("the scene has no such {}; expected some of: {}", what,
                              known.empty() ? "(none)" : fmt::format("{}", fmt::join(known, ", "))));
    }
  };
  if (image.panels.empty()) {
    source.fail(path + ".panels", fmt::format("missing or empty; expected names of images, some of: {}",
                                              fmt::join(images, ", ")));
  }
  check("panels", image.panels, images, "image that can be a panel");
  check("gauges", image.gauges, gauges, "gauge");
}

/// Fields that only one of the two looks of water has.
void check_style(const ImageSettings& image, const std::string& path, const TomlSource& source) {
  const bool surface = image.style == WaterStyle::Surface;
  if (surface && image.field == "kind") {
    source.fail(path + ".field", write_text(image.field),
                "the surface is of water alone; expected another field, or style = \"particles\"");
  }
  if (!surface && image.field == "water") {
    source.fail(path + ".field", write_text(image.field),
                "spheres show a field; expected another one, or style = \"surface\"");
  }
}

void check_images(const Scene& scene, const TomlSource& source) {
  const std::vector<std::string> colour_maps = colour_map_names();
  for (std::size_t k = 0; k < scene.images.size(); ++k) {
    const ImageSettings& image = scene.images[k];
    const std::string path = fmt::format("image.{}", k);
    if (image.kind == ImageKind::DepthMap && scene.dimension == 2) {
      source.fail(path + ".kind", "a depth map needs dimension = 3; expected \"particles\"");
    }
    if (image.kind == ImageKind::Panels) check_panels(scene, image, path, source);
    check_style(image, path, source);
    if (image.field == "velocity_y" && scene.dimension == 2) {
      source.fail(path + ".field", "a 2D scene has no y; expected another field");
    }
    if (std::find(colour_maps.begin(), colour_maps.end(), image.colour_map) == colour_maps.end()) {
      source.fail(path + ".colour_map", write_text(image.colour_map),
                  fmt::format("unknown colour map; expected one of {}", fmt::join(colour_maps, ", ")));
    }
    if (image.clip) check_clip(*image.clip, image.kind, scene.dimension, path + ".clip", source);
    if (!image.camera) continue;
    if (image.kind == ImageKind::Panels) {
      source.fail(path + ".camera",
                  "each panel has the camera of its own image; camera is only accepted with kind = "
                  "\"particles\"");
    }
    if (image.kind == ImageKind::DepthMap) {
      source.fail(path + ".camera",
                  "a depth map is seen from above; camera is only accepted with kind = \"particles\"");
    }
    check_camera(*image.camera, path + ".camera", source);
  }
}

}  // namespace

std::string solid_path(const Scene& scene, const TomlSource& source, std::size_t index) {
  const std::size_t obstacles = source.list_size("obstacle");
  if (index < obstacles) return fmt::format("obstacle.{}", index);
  if (index < scene.obstacles.size()) return fmt::format("dam.{}", index - obstacles);
  return fmt::format("gate.{}", index - scene.obstacles.size());
}

void check_settings(const Scene& scene, const TomlSource& source) {
  if (scene.gravity.norm() == 0.0 && scene.expected_speed() == 0.0) {
    source.fail("gravity",
                "nothing moves; expected an acceleration that is not zero, for example [0.0, 0.0, -9.81] "
                "(2D: [0.0, -9.81]), or an initial velocity");
  }
  check_names(scene, source);
  check_gates(scene, source);
  check_times(scene, source);
  check_scheme(scene, source);
  check_shallow_water(scene, source);
  check_images(scene, source);
}

}  // namespace eisph
