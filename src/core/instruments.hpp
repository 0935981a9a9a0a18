#pragma once

#include "core/shape.hpp"

#include <array>
#include <optional>
#include <string>

namespace eisph {

// Probes of a scene beyond gauges and points. SI units; an interval of 0 means with every snapshot.

/// Part of the domain: lower and upper end for each axis that is restricted.
struct Band {
  std::array<std::optional<std::array<double, 2>>, 3> range;  ///< m, by axis

  [[nodiscard]] bool contains(const Vec3d& point) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto& ends = range[static_cast<std::size_t>(axis)];
      if (ends && (point[axis] < (*ends)[0] || point[axis] > (*ends)[1])) return false;
    }
    return true;
  }

  bool operator==(const Band&) const = default;
};

enum class SensorShape { Disc, Square };

/// Pressure on a wall: the mean over a disc or a square, in two dimensions over a line.
struct PressureSensor {
  std::string name;
  Vec3d position = Vec3d::Zero();  ///< m, centre
  Vec3d normal = Vec3d::Zero();    ///< into the water, of any length; zero: away from the nearest face
  SensorShape shape = SensorShape::Disc;
  double size = 0.0;           ///< m, diameter or side; 0: a point
  double response_time = 0.0;  ///< s, time constant with which it follows the pressure; 0: at once
  double interval = 0.0;       ///< s

  bool operator==(const PressureSensor&) const = default;
};

/// How far the water has come in a horizontal direction.
struct FrontProbe {
  std::string name;
  int axis = 0;           ///< 0 or 1
  bool upwards = true;    ///< towards larger coordinates
  Band band{};            ///< where it looks
  double interval = 0.0;  ///< s

  bool operator==(const FrontProbe&) const = default;
};

/// Pressure and velocity at equidistant points from start to end, both included.
struct LineProbe {
  std::string name;
  Vec3d start = Vec3d::Zero();
  Vec3d end = Vec3d::Zero();
  int points = 21;
  double interval = 0.0;  ///< s

  bool operator==(const LineProbe&) const = default;
};

/// Force of the water on a solid, and its moment.
struct ForceProbe {
  std::string name;
  std::string obstacle;               ///< name of an obstacle, dam or gate
  std::optional<Vec3d> moment_point;  ///< m; default: centre of the solid's base
  double interval = 0.0;              ///< s

  bool operator==(const ForceProbe&) const = default;
};

/// Volume of water that passes a plane in the direction of its axis.
struct DischargeProbe {
  std::string name;
  int axis = 0;
  double position = 0.0;  ///< m, of the plane on its axis
  Band band{};            ///< part of the plane
  double interval = 0.0;  ///< s

  bool operator==(const DischargeProbe&) const = default;
};

/// What the depth grid holds.
enum class DepthRule {
  HighestParticle,  ///< height of the highest particle of a cell (thesis)
  Surface,          ///< level of the water around the centre of a cell, without holes
};

}  // namespace eisph
