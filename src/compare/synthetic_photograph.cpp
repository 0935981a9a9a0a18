#include "compare/synthetic_photograph.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Geometry>

namespace eisph {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kSamples = 2;  ///< along a side of a pixel
constexpr double kWhite = 255.0;
constexpr double kWet = 0.001;           ///< m, water that can hold bubbles
constexpr double kBubbleLength = 0.015;  ///< m, over which a rim changes its width
constexpr double kUnit = 0x1p-64;

/// Scrambles a number (Steele, Lea & Flood 2014, as in SplitMix64).
std::uint64_t scrambled(std::uint64_t value) {
  value += 0x9E3779B97F4A7C15ULL;
  value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  value = (value ^ (value >> 27U)) * 0x94D049BB133111EBULL;
  return value ^ (value >> 31U);
}

/// From 0 to 1, by a key.
double uniform(std::uint64_t key) { return (static_cast<double>(scrambled(key)) + 0.5) * kUnit; }

double normal(std::uint64_t key) {
  const double radius = std::sqrt(-2.0 * std::log(std::min(uniform(2 * key), 1.0 - 1e-16)));
  return radius * std::cos(2.0 * std::numbers::pi * uniform(2 * key + 1));
}

/// Smooth random numbers from 0 to 1 over the floor.
double wandering(double x, double y, std::uint64_t seed) {
  const double u = std::floor(x / kBubbleLength);
  const double v = std::floor(y / kBubbleLength);
  const auto at = [&](double i, double j) {
    const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(i));
    const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(j));
    return uniform(seed ^ scrambled(column * 0x100000001B3ULL ^ scrambled(row)));
  };
  const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double s = ease(x / kBubbleLength - u);
  const double t = ease(y / kBubbleLength - v);
  const double below = at(u, v) + s * (at(u + 1, v) - at(u, v));
  const double above = at(u, v + 1) + s * (at(u + 1, v + 1) - at(u, v + 1));
  return below + t * (above - below);
}

/// Share of the light at a pixel.
double backlight(const SyntheticSettings& settings, const Vector2d& pixel) {
  const double u = pixel.x() / settings.camera.width - 0.5;
  const double v = pixel.y() / settings.camera.height - 0.5;
  return (1.0 - settings.light.falloff * 2.0 * (u * u + v * v)) * (1.0 + settings.light.gradient * u);
}

/// Level of one point of the picture without noise.
double level_at(const SyntheticSettings& settings, const FloorMap& floor, const Vector2d& plane,
                const std::function<double(double, double)>& depth) {
  const double x = plane.x();
  const double y = plane.y();
  if (x < floor.area[0] || y < floor.area[1] || x > floor.area[2] || y > floor.area[3])
    return settings.light.frame;
  if (floor.solid_distance(x, y) <= 0.0) return settings.light.solid;
  const double water = std::max(0.0, depth(x, y));
  double level = settings.light.bright * std::exp(-water / settings.light.extinction_length);
  if (water > kWet && settings.rims.width > 0.0) {
    const double distance = floor.wall_distance(x, y);
    const double width =
        2.0 * settings.rims.width * wandering(x, y, static_cast<std::uint64_t>(settings.seed));
    if (distance < width) level *= 1.0 - settings.rims.darkness * (1.0 - distance / width);
  }
  return level;
}

}  // namespace

PlaneCamera synthetic_camera(const SyntheticCamera& settings, const std::array<double, 4>& area) {
  const double radians = std::numbers::pi / 180.0;
  const Vector3d middle(0.5 * (area[0] + area[2]), 0.5 * (area[1] + area[3]), 0.0);
  // Looking down, right is positive x and down in the picture negative y.
  Matrix3d turn = Vector3d(1.0, -1.0, -1.0).asDiagonal();
  turn = Eigen::AngleAxisd(settings.roll * radians, Vector3d::UnitZ()) *
         Eigen::AngleAxisd(settings.tilt * radians, Vector3d::UnitY()) * turn;
  const Vector3d eye = middle - turn.transpose() * Vector3d(0.0, 0.0, settings.elevation);
  Matrix3d view;  // of (x, y, 1) with z = 0
  view.col(0) = turn.col(0);
  view.col(1) = turn.col(1);
  view.col(2) = -turn * eye;
  // The focal length at which the farthest corner just stays within the margin.
  double focal = 1e30;
  for (const double x : {area[0], area[2]}) {
    for (const double y : {area[1], area[3]}) {
      const Vector2d corner = (view * Vector3d(x, y, 1.0)).eval().hnormalized();
      focal = std::min(focal, (0.5 - settings.margin) * settings.width / std::abs(corner.x()));
      focal = std::min(focal, (0.5 - settings.margin) * settings.height / std::abs(corner.y()));
    }
  }
  Matrix3d lens = Vector3d(focal, focal, 1.0).asDiagonal();
  lens(0, 2) = 0.5 * settings.width;
  lens(1, 2) = 0.5 * settings.height;
  const Matrix3d homography = lens * view;
  return {homography / homography(2, 2), settings.radial_distortion, settings.width, settings.height};
}

double depth_between(const DepthGrid& grid, double x, double y) {
  const auto along = [&grid](double position, double origin, std::size_t cells) {
    const double last = static_cast<double>(cells) - 1.0;
    return std::clamp((position - origin) / grid.cell_size - 0.5, 0.0, last);
  };
  const double u = along(x, grid.origin_x, grid.columns);
  const double v = along(y, grid.origin_y, grid.rows);
  const auto i = static_cast<std::size_t>(u);
  const auto j = static_cast<std::size_t>(v);
  const std::size_t next_i = std::min(i + 1, grid.columns - 1);
  const std::size_t next_j = std::min(j + 1, grid.rows - 1);
  const double s = u - static_cast<double>(i);
  const double t = v - static_cast<double>(j);
  return (1.0 - t) * ((1.0 - s) * grid.at(i, j) + s * grid.at(next_i, j)) +
         t * ((1.0 - s) * grid.at(i, next_j) + s * grid.at(next_i, next_j));
}

GreyPicture synthetic_photograph(const SyntheticSettings& settings, const PlaneCamera& camera,
                                 const FloorMap& floor,
                                 const std::function<double(double x, double y)>& depth, unsigned number) {
  GreyPicture picture(settings.camera.width, settings.camera.height);
  const double steps = settings.camera.bit_depth == 16 ? 65535.0 : kWhite;
  const std::uint64_t seed = scrambled((static_cast<std::uint64_t>(settings.seed) << 32U) + number);
  for (int j = 0; j < picture.height; ++j) {
    for (int i = 0; i < picture.width; ++i) {
      double level = 0.0;
      for (int v = 0; v < kSamples; ++v) {
        for (int u = 0; u < kSamples; ++u) {
          const Vector2d pixel(i + (u + 0.5) / kSamples, j + (v + 0.5) / kSamples);
          level += level_at(settings, floor, camera.plane_of(pixel), depth);
        }
      }
      level *= backlight(settings, {i + 0.5, j + 0.5}) / (kSamples * kSamples);
      level += settings.light.noise * normal(seed ^ picture.index(i, j));
      level = std::clamp(level / kWhite, 0.0, 1.0);
      picture.at(i, j) = static_cast<float>(std::round(level * steps) / steps);
    }
  }
  return picture;
}

}  // namespace eisph
